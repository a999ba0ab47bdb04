"""Which physics did a simulation leave out? A recording of the paper: sliding friction against load."""

import pathlib

import asperity

recordings = pathlib.Path(__file__).resolve().parents[2] / "runs" / "paper" / "recordings"
answer = asperity.diagnose(recordings / "sliding_offset_untreated")
print(answer.verdict)
for name, effect in answer.left_out.items():
    for parameter, number in effect["parameters"].items():
        low, high = number["ci95"]
        print(f"{name}: {parameter} = {number['value']:.3g} {number['unit']} ({low:.2g} to {high:.2g})")
print(answer.to_frame()[["normal_force", "lateral_force", "simulated_before", "simulated_after"]].head(4))

# prints: explained
# prints: adhesion_offset: adhesion_force = 1.2e-05 N (9.2e-06 to 1.5e-05)
