"""Recordings as an instrument writes them: a contact along a path, what the instrument adds by plain formulas, noise. SI units."""

import json
import math

GLASS, SILICON, DIAMOND = (71e9, 0.17), (179e9, 0.25), (1140e9, 0.07)
NAMES = {GLASS: "borosilicate", SILICON: "Si(100)", DIAMOND: "diamond"}
RADIUS = 8.5e-6


def body(material, radius=None):
    entry = {"material": NAMES[material], "youngs_modulus": material[0], "poissons_ratio": material[1]}
    if radius:
        entry["radius"] = radius
    return entry


def noises(random, count, sd, memory):
    """White, or half of it an autoregression."""
    slow, values = random.gauss(0, 1), []
    for _ in range(count):
        values.append(sd * (math.sqrt(0.5) * (slow + random.gauss(0, 1)) if memory else random.gauss(0, 1)))
        slow = memory * slow + math.sqrt(1 - memory ** 2) * random.gauss(0, 1)
    return values


class Instrument:
    """d = d_contact + C f + offset + rate t, f = (f_contact + slope d) through the detector."""

    def __init__(self, compliance=0.0, offset=0.0, rate=0.0, slope=0.0, detector=None, ripple=None, hysteresis=0.0):
        self.compliance, self.offset, self.rate, self.slope, self.hysteresis = compliance, offset, rate, slope, hysteresis
        self.ripple = ripple  # amplitude and period
        self.detector = detector or (lambda force: force)

    def read(self, approach, force, time):
        displacement = approach + self.compliance * force + self.offset + self.rate * time
        if self.ripple:
            force += self.ripple[0] * math.sin(2 * math.pi * displacement / self.ripple[1])
        return displacement, self.detector(force + self.slope * displacement)


class Normal:
    """Loading, hold and unloading; `make` gives a contact without history for each run, `creep` the hold's relative growth."""

    def __init__(self, make, instrument, depths, off_contact=0.0, hold=0.0, unload=True, samples=100, duration=10.0,
                 by_force=False, creep=None, jumps=None):
        self.make, self.instrument, self.depths = make, instrument, depths
        self.off_contact, self.hold, self.unload, self.samples, self.duration = off_contact, hold, unload, samples, duration
        self.by_force, self.creep, self.jumps = by_force, creep, jumps

    def path(self, depth):
        """Approach of the contact, time, segment."""
        start = -self.off_contact * max(self.depths)
        for i in range(self.samples):
            part = (i + 1) / self.samples
            yield start + (depth - start) * part, self.duration * part, "load"
        held = round(self.samples * 0.4) if self.hold else 0
        for i in range(held):
            yield depth, self.duration + self.hold * (i + 1) / held, "hold"
        for i in range(self.samples if self.unload else 0):
            part = (i + 1) / self.samples
            yield depth - (depth - start) * part, self.duration * (1 + part) + self.hold, "unload"

    def rows(self):
        for run, depth in enumerate(self.depths, 1):
            contact, jumped = self.make(), 0.0
            crept, last_force, last_time, furthest, last_segment = 0.0, 0.0, 0.0, 0.0, ""
            for approach, time, segment in self.path(depth):
                force = contact.force(approach)
                if self.creep:  # q goes to share x elastic approach with the time constant: a Kelvin element that feels the force^(2/3)
                    share, constant = self.creep
                    decay = math.exp(-(time - last_time) / constant)
                    mean = share * (max(0.0, force) ** (2 / 3) + max(0.0, last_force) ** (2 / 3)) / 2
                    crept = crept * decay + mean * (1 - decay)
                scale = depth / max(1e-30, contact.force(depth)) ** (2 / 3) if self.creep else 0
                if self.jumps and force > self.jumps[0] * (0.9 + 0.1 * run):
                    jumped = self.jumps[1]
                last_force, last_time = force, time
                displacement, read = self.instrument.read(approach + scale * crept + jumped, force, time)
                if segment == "unload":  # of the actuator: nothing at both ends of its way
                    part = (approach + self.off_contact * max(self.depths)) / (depth + self.off_contact * max(self.depths))
                    displacement += self.instrument.hysteresis * math.sin(math.pi * part)
                # What drives moves on: a spring in series lets a contact snap open where force falls faster than the spring
                # gives way, and what lies between before and after a snap is not recorded.
                if segment == "unload" and force < 0 and displacement > furthest:
                    contact, force = self.make(), 0.0
                    displacement, read = self.instrument.read(approach, force, time)
                # Under a driven displacement a contact forms where the bodies touch, not before.
                if segment == "load" and force < 0 and approach + self.instrument.compliance * force < 0 and not self.by_force:
                    continue
                forward = 1 if segment == "load" else -1
                if segment != last_segment:
                    furthest, last_segment = displacement, segment
                elif segment == "hold" or forward * displacement > forward * furthest or self.by_force:
                    furthest = displacement
                else:
                    continue
                yield run, time, displacement, read, segment

    def write(self, folder, random, noise, memory=0.0, materials=(GLASS, SILICON), radius=RADIUS):
        rows = list(self.rows())
        if self.by_force:
            rows = [row for row in rows if row[3] > 0]
        response = 2 if self.by_force else 3
        sd = noise * max(abs(row[response]) for row in rows)
        added = noises(random, len(rows), sd, memory)
        folder.mkdir(parents=True)
        channels = ["normal_displacement", "normal_force"]
        control = channels[1] if self.by_force else channels[0]
        description = {"format": "asperity-recording/1", "title": "blind recording", "mode": "normal",
                       "particle": body(materials[0], radius), "substrate": body(materials[1]),
                       "tables": [{"file": "loading.csv", "kind": "trace", "control": [control],
                                   "response": channels[0] if self.by_force else channels[1]}]}
        (folder / "recording.json").write_text(json.dumps(description, indent=1))
        lines = ["run,time [s],normal_displacement [m],normal_force [N],segment"]
        for row, off in zip(rows, added):
            values = list(row)
            values[response] += off
            lines.append("{},{:.8g},{:.9e},{:.9e},{}".format(*values))
        (folder / "loading.csv").write_text("\n".join(lines) + "\n")
