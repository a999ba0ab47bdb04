"""From a surface to the contact of a sphere on it: measured, then previewed by half-spaces in seconds."""

import asperity

surface = asperity.generate_surface(rms=1.5e-9, size=2.56e-6, pixels=256, cutoff=80e-9, seed=3)  # or read_surface("scan.gwy")
asperity.write_surface("scan.gsf", surface)
measured = asperity.measure_surface(surface)
print(f"RMS height {measured['Sq_m'] * 1e9:.2f} nm, RMS slope {measured['rms_slope']:.3f}")

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
  set Topography = scan.gsf
end
subsection Experiment
  set Normal load = 100 uN
end
""")
for load in ("30 uN", "100 uN"):
    contact = asperity.preview("case.prm", {"Experiment/Normal load": load})
    print(f"{load}: stiffness {contact.stiffness / 1e3:.1f} kN/m, real area {contact.area * 1e12:.4f} um^2 "
          f"in {contact.spots} spots, largest pressure {contact.pressure.max() / 1e9:.2f} GPa")

# prints: RMS height 1.36 nm, RMS slope 0.022
