"""What is hidden in the blind recordings: families, each with several of other numbers, from a seed."""

import math
import random as dice

import contacts
from contacts import reduced_modulus, table
from lateral import Loops, contact_radius, write_series
from recordings import DIAMOND, GLASS, RADIUS, SILICON, Instrument, Normal

OTHER_CODE = "other code"  # yielding and roughness by finite and boundary elements and by Greenwood & Tripp
MODULUS = reduced_modulus(GLASS, SILICON)


class Blind:
    """One recording: what it holds, how it is written, its true parameters."""

    def __init__(self, family, name, truth, write, noise, parameters=None):
        self.family, self.name, self.truth, self.write, self.noise = family, name, sorted(truth), write, noise
        self.parameters = parameters or {}


class Normals:
    """Draws recordings under normal load."""

    def __init__(self, random, surfaces):
        self.random, self.surfaces = random, surfaces

    def between(self, low, high):
        return math.exp(self.random.uniform(math.log(low), math.log(high)))

    def sign(self):
        return self.random.choice((-1, 1))

    def contact(self, kind):
        """make(), largest depth, materials, parameters."""
        load = self.between(0.2e-3, 1.5e-3)
        depth = (load / (4 / 3 * MODULUS * math.sqrt(RADIUS))) ** (2 / 3)
        if kind in ("yielding", "incipient"):
            w = self.between(8, 50) if kind == "yielding" else self.between(2.5, 6)
            materials = (GLASS, DIAMOND) if self.random.random() < 0.5 else (GLASS, GLASS)
            modulus = reduced_modulus(*materials)
            # The tables are those of small contacts: up to a/R = 0.2.
            top = min(2e9, 0.2 / math.sqrt(w) * 2 * modulus / (1.6 * math.pi))
            yield_stress = self.between(0.25 * top, top)
            make = lambda: contacts.Yielding(modulus, RADIUS, yield_stress)
            return make, w * make().approach, materials, {"bulk_plasticity/yield_stress": yield_stress}
        if kind == "greenwood_tripp":
            rms, asperities = self.between(1e-9, 3e-9), self.random.choice((1, 4, 17, 50))
            largest = 4 / 3 * MODULUS * math.sqrt(RADIUS) * (rms / self.between(0.06, 0.2)) ** 1.5
            make = lambda: contacts.greenwood_tripp(MODULUS, RADIUS, rms, asperities, largest)
            return make, (largest / (4 / 3 * MODULUS * math.sqrt(RADIUS))) ** (2 / 3) + 1.5 * rms, (GLASS, SILICON), {}
        if kind == "rough_sphere":
            largest, name = self.between(100e-6, 350e-6), self.random.choice(self.surfaces)
            make = lambda: contacts.rough_sphere(name, MODULUS, RADIUS, largest)
            contact = make()
            return make, contact.approach(math.log(largest)) - contact.approach(contact.first), (GLASS, SILICON), {}
        if kind == "adhesion":
            load = self.between(15e-6, 60e-6)
            depth, pull, parameter = (load / (4 / 3 * MODULUS * math.sqrt(RADIUS))) ** (2 / 3), self.between(0.08, 0.3) * load, \
                self.between(0.1, 2)
            make = lambda: contacts.Adhesive(MODULUS, RADIUS, pull, parameter)
            return make, depth, (GLASS, SILICON), {"adhesion/pull_off_force": pull}
        if kind == "radius":
            ratio = self.between(1.2, 1.8) if self.random.random() < 0.5 else self.between(0.55, 0.83)
            return (lambda: contacts.Elastic(MODULUS, ratio * RADIUS)), depth, (GLASS, SILICON), {"effective_radius/radius_ratio": ratio}
        if kind == "coated":
            softer = self.between(0.1, 0.4)
            thickness = self.between(0.3, 0.8) * math.sqrt(RADIUS * depth)
            return (lambda: contacts.Coated(MODULUS, RADIUS, softer, thickness)), depth, (GLASS, SILICON), {}
        return (lambda: contacts.Elastic(MODULUS, RADIUS)), depth, (GLASS, SILICON), {}

    def recording(self, family, name, kind, truth, noise, parts=(), runs=3, **how):
        """`parts`: what the instrument adds; `how`: of the protocol."""
        make, depth, materials, parameters = self.contact(kind)
        largest = make().force(depth)
        hold = how.get("hold", 0.0)
        given = {}
        if "compliance" in parts:
            given["compliance"] = self.between(0.08, 0.35) * depth / largest
            parameters["instrument_compliance/compliance"] = given["compliance"]
        if "offset" in parts:
            given["offset"] = self.sign() * self.between(0.06, 0.2) * depth
            parameters["contact_point_offset/offset"] = given["offset"]
        if "drift" in parts:
            given["rate"] = self.sign() * self.between(0.06, 0.2) * depth / (20 + hold)
            parameters["thermal_drift/rate"] = given["rate"]
        if "tilt" in parts:
            given["slope"] = self.sign() * self.between(0.05, 0.2) * largest / depth
            parameters["baseline_tilt/slope"] = given["slope"]
        if "creep" in parts:
            how["creep"] = (self.between(0.05, 0.2), self.between(0.1, 0.5) * hold)
            parameters["creep/time_constant"] = how["creep"][1]
        if "nonlinear" in parts:
            bend = self.between(0.1, 0.3)
            given["detector"] = lambda force: force * (1 - bend * (force / largest) ** 2)
        if "clipped" in parts:
            top = self.between(0.7, 0.9) * largest
            given["detector"] = lambda force: min(force, top)
        if "interference" in parts:  # light reflected by the sample: a ripple along the displacement
            given["ripple"] = (self.between(0.03, 0.08) * largest, self.between(0.3, 0.7) * depth)
        if "piezo" in parts:  # hysteresis of the actuator: its way back lies beside its way there
            given["hysteresis"] = parameters["actuator_hysteresis/lag"] = self.sign() * self.between(0.03, 0.08) * depth
        if "jumps" in parts:
            how["jumps"] = (0.4 * largest, self.between(0.06, 0.2) * depth)
        depths = [depth * part for part in ({1: (1,), 3: (0.4, 0.7, 1)}[runs])]
        normal = Normal(make, Instrument(**given), depths, **how)
        memory = self.random.choice((0, 0, 0.7))
        write = lambda folder, random: normal.write(folder, random, noise, memory, materials)
        return Blind(family, name, truth, write, noise, {k: v for k, v in parameters.items() if k.split("/")[0] in truth})


NAMES = {"compliance": "instrument_compliance", "offset": "contact_point_offset", "drift": "thermal_drift", "tilt": "baseline_tilt",
         "creep": "creep", "yielding": "bulk_plasticity", "incipient": "bulk_plasticity", "greenwood_tripp": "roughness_compliance",
         "rough_sphere": "roughness_compliance", "adhesion": "adhesion", "radius": "effective_radius",
         "jumps": "pop_in", "nonlinear": "detector_nonlinearity", "clipped": "clipping", "coated": "film", "piezo": "actuator_hysteresis"}
AWAY = {"off_contact": 0.5}
HELD = {"hold": 20.0, "by_force": True, "duration": 2.0}


def normal_recordings(random, surfaces):
    draw = Normals(random, surfaces)
    noise = lambda: draw.between(0.002, 0.03)
    for runs in (1, 3):
        for kind in ("yielding", "incipient"):
            low = lambda: draw.between(0.002, 0.01 if kind == "incipient" else 0.03)
            yield draw.recording(OTHER_CODE, kind + "-load", kind, [NAMES[kind]], low(), runs=runs, unload=False)
            yield draw.recording(OTHER_CODE, kind + "-unload", kind, [NAMES[kind]], low(), runs=runs)
            yield draw.recording(OTHER_CODE, kind + "-hold", kind, [NAMES[kind]], low(), runs=runs, hold=10.0)
        for kind in ("greenwood_tripp", "rough_sphere"):
            for how in ({}, AWAY, {"hold": 10.0}):
                yield draw.recording(OTHER_CODE, kind, kind, [NAMES[kind]], draw.between(0.002, 0.01), runs=runs, **how)
        for kind in ("adhesion", "radius"):
            for how in (AWAY, AWAY):
                yield draw.recording("single", kind, kind, [NAMES[kind]], noise(), runs=runs, **how)
        for part, how in (("compliance", {}), ("offset", AWAY), ("drift", {"hold": 20.0}), ("tilt", AWAY), ("creep", HELD)):
            for _ in range(2):
                yield draw.recording("single", part, "elastic", [NAMES[part]], noise(), (part,), runs=runs, **how)
        for how in ({}, AWAY, {"hold": 20.0}, HELD, {"unload": False}):
            yield draw.recording("null", "noise", "elastic", [], noise(), runs=runs, **how)
        for kind, parts, how in (("coated", (), AWAY), ("elastic", ("jumps",), AWAY), ("elastic", ("nonlinear",), AWAY),
                                 ("elastic", ("clipped",), AWAY), ("elastic", ("nonlinear",), {"hold": 10.0})):
            name = parts[0] if parts else kind
            yield draw.recording("single", name, kind, [NAMES[name]], draw.between(0.002, 0.01), parts, runs=runs, **how)
        for _ in range(2):
            yield draw.recording("single", "piezo", "elastic", [NAMES["piezo"]], draw.between(0.002, 0.01), ("piezo",), runs=runs, **AWAY)
            yield draw.recording("unknown", "interference", "elastic", ["unknown"], draw.between(0.002, 0.01), ("interference",),
                                 runs=runs, **AWAY)
        for part, how in (("tilt", {}), ("drift", {"unload": False})):  # nothing off contact, no hold: these data cannot say
            yield draw.recording("cannot say", part, "elastic", [NAMES[part]], draw.between(0.002, 0.01), (part,), runs=runs, **how)
    for kind, how in (("adhesion", AWAY), ("yielding", AWAY), ("creep", HELD)):
        for part in ("compliance", "offset", "radius"):
            if (kind, part) == ("yielding", "radius"):
                continue  # the imprint of another radius: the same curve
            for runs in (1, 3):
                law = part if kind == "creep" and part == "radius" else "elastic" if kind == "creep" else kind
                parts = [p for p in (kind, part) if p in ("creep", "compliance", "offset")]
                if (kind, part) == ("adhesion", "radius"):
                    continue  # pull-off scales alike; creep and the instrument stand for pairs with a radius
                yield draw.recording("pair", kind + "+" + part, law, {NAMES[kind], NAMES[part]}, draw.between(0.002, 0.01), parts,
                                     runs=runs, **how)


class Laterals:
    """Draws recordings of sliding, rolling and torsion."""

    def __init__(self, random):
        self.random = random
        self.friction = Normals(random, ()).between(0.15, 0.5)
        self.between, self.sign = Normals(random, ()).between, Normals(random, ()).sign

    def loops(self, family, name, truth, noise, limit=None, parameters=None, loads=(50e-6, 100e-6, 200e-6), stroke=600e-9, **how):
        mu = self.friction
        loops = Loops(limit or (lambda load, *_: mu * load), loads, stroke, **how)
        memory = self.random.choice((0, 0, 0.7))
        return Blind(family, name, truth, lambda folder, random: loops.write(folder, random, noise, memory), noise, parameters)

    def change(self, kind):
        """What changes friction: limit, parameters, how."""
        mu = self.friction
        if kind == "adhesion_offset":
            pull = self.between(0.1, 0.4) * 1e-4
            return (lambda load, *_: mu * (load + pull)), {"adhesion_offset/adhesion_force": pull}, {}
        if kind == "area_proportional_friction":
            strength = mu * 1e-4 / (math.pi * contact_radius(1e-4) ** 2)
            return (lambda load, radius, *_: strength * math.pi * radius ** 2), {"area_proportional_friction/shear_strength": strength}, {}
        if kind == "run_in":
            change, cycles = self.sign() * self.between(0.15, 0.4), self.between(0.8, 2)
            return (lambda load, r, s, p, cycle, v: mu * load * (1 + change * math.exp(-cycle / cycles))), \
                {"run_in/change": change}, {"cycles": 8, "samples": 30}
        if kind == "static_friction_peak":
            ratio, length = self.between(1.15, 1.5), self.between(30e-9, 100e-9)
            return (lambda load, r, slip, *_: mu * load * (1 + (ratio - 1) / (1 + (slip / length) ** 2))), {}, {"samples": 100}
        if kind == "velocity_dependence":
            b = self.sign() * self.between(0.01, 0.04)
            return (lambda load, r, s, p, c, v: load * (mu + b * math.log(v / 1e-6))), {"velocity_dependence/coefficient": b}, \
                {"speeds": (1e-7, 1e-6, 1e-5), "cycles": 2}
        if kind == "stick_slip":
            drop = self.between(0.1, 0.25) * mu * 5e-5
            return (lambda load, *_: mu * load), {}, {"event": (drop, self.between(60e-9, 120e-9)), "samples": 120}
        return None, {}, {}

    def instrument(self, kind):
        mu = self.friction
        if kind == "lateral_compliance":
            value = self.between(20e-9, 80e-9) / (mu * 2e-4)
            return {"compliance": value}, {"lateral_compliance/compliance": value}
        if kind == "lateral_zero_offset":
            value = self.sign() * self.between(0.08, 0.3) * mu * 1e-4
            return {"offset": value}, {"lateral_zero_offset/offset": value}
        if kind == "surface_tilt":
            value = self.sign() * self.between(0.08, 0.3) * mu
            return {"tilt": value}, {"surface_tilt/angle": value}
        return {}, {}

    def hidden(self, family, names, noise):
        limit, parameters, how = None, {}, {}
        for name in names:
            own, own_parameters, own_how = self.change(name)
            given, given_parameters = self.instrument(name)
            limit, how = own or limit, {**how, **own_how, **given}
            parameters = {**parameters, **own_parameters, **given_parameters}
        return self.loops(family, "sliding " + "+".join(names), list(names), noise, limit, parameters, **how)


def rolling_table():
    rows = [r for r in table("05_rolling_table_hysteresis.csv") if r["pair_sphere/plane"] == "borosilicate/Si"]
    return {float(r["P_uN"]) * 1e-6: float(r["M_roll_over_alpha_Nm"]) for r in rows}


def torsion_table():
    rows = [r for r in table("04_torsion_table_loads.csv") if r["pair_sphere/plane"] == "borosilicate/Si"]
    return {float(r["P_uN"]) * 1e-6: float(r["M_full_slip_Nm"]) for r in rows}


def lateral_recordings(random):
    draw = Laterals(random)
    noise = lambda: draw.between(0.003, 0.03)
    for kind in ("adhesion_offset", "area_proportional_friction", "run_in", "static_friction_peak", "velocity_dependence", "stick_slip",
                 "lateral_compliance", "lateral_zero_offset", "surface_tilt"):
        for _ in range(2):
            yield draw.hidden("single", (kind,), noise())
    for _ in range(2):
        yield draw.loops("single", "sliding partial_slip", ["partial_slip"], draw.between(0.003, 0.01), stroke=12e-9, samples=60,
                         loads=(100e-6, 200e-6, 400e-6), partial=True)
        yield draw.hidden("null", (), noise())
        for names in (("run_in", "surface_tilt"), ("adhesion_offset", "lateral_compliance"), ("velocity_dependence", "lateral_zero_offset"),
                      ("static_friction_peak", "lateral_compliance")):
            yield draw.hidden("pair", names, draw.between(0.003, 0.015))
        level, torsion, rolling = draw.between(0.005, 0.03), torsion_table(), rolling_table()
        loss = draw.between(0.1, 0.3)
        twist = lambda load, speed: torsion[load] / RADIUS
        roll = lambda load, speed: loss * rolling[load] / RADIUS
        offset = draw.between(1e-5, 5e-5)
        plain = lambda load, speed: 5e-4 * load
        pulled = lambda load, speed: 5e-4 * (load + offset)
        for name, mode, force, truth, loads, given in (
                ("torsion", "torsion", twist, ["contact_radius_scaling"], torsion, {}),
                ("rolling", "rolling", roll, ["contact_radius_scaling"], rolling, {}),
                ("rolling", "rolling", pulled, ["rolling_adhesion_offset"], rolling,
                 {"rolling_adhesion_offset/adhesion_force": offset}),
                ("rolling", "rolling", plain, [], rolling, {})):
            rows = sorted(loads)[-5:]
            write = lambda folder, random, mode=mode, force=force, rows=rows, level=level: \
                write_series(folder, mode, force, rows, random, level)
            yield Blind("single" if truth else "null", name, truth, write, level, given)


def blind_recordings(seed, surfaces):
    """All of one seed; `surfaces`: files of rough_spheres/."""
    random = dice.Random(seed)
    return list(normal_recordings(random, surfaces)) + list(lateral_recordings(random))
