"""Friction loops, rolling and torsion as an instrument writes them, from tables of 03, 04 and 05 and plain formulas. SI units."""

import json
import math

from contacts import Curve, reduced_modulus, table
from recordings import DIAMOND, GLASS, RADIUS, SILICON, body, noises


def contact_radius(load):
    return (3 * load * RADIUS / (4 * reduced_modulus(GLASS, SILICON))) ** (1 / 3)


def stiffness(load):
    """Mindlin 1949, no slip [N/m]."""
    compliance = sum((2 - poisson) * 2 * (1 + poisson) / modulus for modulus, poisson in (GLASS, SILICON))
    return 8 * contact_radius(load) / compliance


def masing(limit, spring):
    """Force against shift since a turn, from a table of Mindlin's solution; shift in full slip 1."""
    rows = table("03_mindlin_table_Qdelta.csv")
    curve = Curve([0.0] + [float(r["delta_over_delta_gs"]) for r in rows], [0.0] + [float(r["Q_over_muP"]) for r in rows])
    full = 1.5 * limit / spring
    return lambda shift: limit * min(1.0, curve(min(1.0, shift / full)))


class Loops:
    """Sliding there and back under each load; `limit(load, radius, slip, path, cycle, speed)` is the friction force."""

    def __init__(self, limit, loads, stroke, cycles=3, samples=60, speeds=(1e-6,), compliance=0.0, offset=0.0, tilt=0.0,
                 partial=False, event=None):
        self.limit, self.loads, self.stroke, self.cycles, self.samples = limit, loads, stroke, cycles, samples
        self.speeds, self.compliance, self.offset, self.tilt = speeds, compliance, offset, tilt
        self.partial, self.event = partial, event

    def loop(self, load, speed, random):
        """cycle, segment, shift, force of the contact; the way before the first sliding is left out."""
        spring, radius = stiffness(load), contact_radius(load)
        force, position, shift = 0.0, 0.0, 0.0
        step, since = self.stroke / self.samples, 0.0
        drop, spacing, turn_force = 0.0, 0.0, 0.0
        for half in range(2 * self.cycles):
            sign, slip, since, turn_force = (1 if half % 2 == 0 else -1), 0.0, 0.0, force
            for i in range(self.samples):
                shift += sign * step
                since += step
                most = self.limit(load, radius, slip, half * self.stroke + since, (half + (i + 1) / self.samples) / 2, speed)
                if self.event:  # saw-tooth of uneven events
                    if spacing <= 0:
                        spacing = self.event[1] * random.gauss(1, 0.04)
                    drop = self.event[0] * (0.5 - spacing / self.event[1])
                    spacing -= step
                    most += drop
                if self.partial and half == 0:
                    force = masing(most, spring)(shift)
                elif self.partial:
                    force = turn_force + sign * 2 * masing(most, spring)(since / 2)
                else:
                    trial = (force + spring * (shift - position)) / (1 + spring * self.compliance)
                    force = max(-most, min(most, trial))
                    slipped = abs(shift - self.compliance * force - position) if abs(force) >= most * (1 - 1e-9) else 0
                    slip, position = slip + slipped, shift - self.compliance * force
                yield half // 2, "forward" if sign > 0 else "backward", shift, force

    def write(self, folder, random, noise, memory=0.0):
        rows, run = [], 0
        for load in self.loads:
            for speed in self.speeds:
                run += 1
                for i, (cycle, segment, shift, force) in enumerate(self.loop(load, speed, random)):
                    time = (i + 1) * self.stroke / self.samples / speed
                    rows.append([run, cycle, time, load, shift, force + self.offset + math.tan(self.tilt) * load, speed, segment])
        sd = noise * max(abs(row[5]) for row in rows)
        for row, off in zip(rows, noises(random, len(rows), sd, memory)):
            row[5] += off
        lines = ["run,cycle,time [s],normal_force [N],lateral_displacement [m],lateral_force [N],speed [m/s],segment"]
        lines += ["{},{},{:.7g},{:.7g},{:.7g},{:.8g},{:.5g},{}".format(*row) for row in rows]
        simulation = {"sliding": "mindlin_coulomb", "parameters": {"sliding_friction": {"value": 0.3, "calibrate": True}}}
        write_tables(folder, "sliding", simulation, "loops.csv", "trace", ["lateral_displacement", "normal_force"], lines)


def write_series(folder, mode, force, loads, random, noise, speeds=(0.0,), repeats=3):
    """Rows of rolling or torsion; force(load, speed)."""
    rows = [(load, speed, force(load, speed)) for load in loads for speed in speeds for _ in range(repeats)]
    lines = ["normal_force [N],speed [m/s],lateral_force [N],lateral_force_sd [N]"]
    sd = noise * max(row[2] for row in rows)
    for load, speed, value in rows:
        lines.append("{:.7g},{:.5g},{:.8g},{:.8g}".format(load, speed, value + random.gauss(0, sd), sd))
    simulation = {"rolling": "constant", "parameters": {"rolling_friction": {"value": 5e-4, "calibrate": True}}}
    if mode == "torsion":
        simulation = {"torsion": "constant", "parameters": {"torsion_friction": {"value": 5e-4, "calibrate": True}}}
    write_tables(folder, mode, simulation, "series.csv", "series", ["normal_force"], lines)


def write_tables(folder, mode, simulation, file, kind, control, lines):
    folder.mkdir(parents=True)
    description = {"format": "asperity-recording/1", "title": "blind recording", "mode": mode, "particle": body(GLASS, RADIUS),
                   "substrate": body(SILICON), "simulation": simulation,
                   "tables": [{"file": file, "kind": kind, "control": control, "response": "lateral_force"}]}
    if mode == "rolling":
        description["indenter"] = body(DIAMOND)
    (folder / "recording.json").write_text(json.dumps(description, indent=1))
    (folder / file).write_text("\n".join(lines) + "\n")
