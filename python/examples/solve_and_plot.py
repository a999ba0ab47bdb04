"""A case by finite elements, its history as a table, its numbers for a particle simulation."""

import asperity

with open("case.prm", "w", encoding="utf-8") as case:
    case.write("""
subsection Particle
  set Radius = 8.5 um
  set Young modulus = 71 GPa
  set Poisson ratio = 0.17
end
subsection Substrate
  set Young modulus = 179 GPa
  set Poisson ratio = 0.25
end
subsection Experiment
  set Normal load = 1 mN
  set Load steps = 4
  set Unload = false
end
""")
solved = asperity.solve("case.prm", "solved", overwrite=True, progress=print)
table = solved.history.to_frame()  # table.plot("normal_displacement [m]", "normal_force [N]") draws it
print(table[["normal_displacement [m]", "normal_force [N]", "contact_radius [m]"]])
stiffness = solved.effective["normal_stiffness"]
print(f"normal stiffness {stiffness.value / 1e3:.0f} kN/m, standard deviation {stiffness.sd / 1e3:.1f} kN/m")

# prints: normal stiffness 53 kN/m
