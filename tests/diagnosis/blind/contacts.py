"""Normal contacts that the diagnosing program does not know: tables of other codes, and laws of other authors.

A contact gives the force [N] at its own approach [m] along a path of loading and unloading. SI units.
"""

import bisect
import csv
import math
import pathlib

TABLES = pathlib.Path(__file__).resolve().parents[2] / "data" / "references"
ROUGH = pathlib.Path(__file__).resolve().parent / "rough_spheres"


def table(name):
    with open(TABLES / name) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def reduced_modulus(one, other):
    return 1 / ((1 - one[1] ** 2) / one[0] + (1 - other[1] ** 2) / other[0])


class Curve:
    """Cubic Hermite curve through points with rising places; straight on beyond them."""

    def __init__(self, x, y):
        self.x, self.y = list(x), list(y)
        n = len(self.x)
        secants = [(self.y[i + 1] - self.y[i]) / (self.x[i + 1] - self.x[i]) for i in range(n - 1)]
        self.slopes = [secants[0]] + [0.0] * (n - 2) + [secants[-1]]
        for i in range(1, n - 1):
            left, right = self.x[i] - self.x[i - 1], self.x[i + 1] - self.x[i]
            self.slopes[i] = (right * secants[i - 1] + left * secants[i]) / (left + right)

    def __call__(self, x):
        i = min(max(bisect.bisect_right(self.x, x) - 1, 0), len(self.x) - 2)
        if x < self.x[0]:
            return self.y[0] + self.slopes[0] * (x - self.x[0])
        if x > self.x[-1]:
            return self.y[-1] + self.slopes[-1] * (x - self.x[-1])
        h = self.x[i + 1] - self.x[i]
        t = (x - self.x[i]) / h
        return (self.y[i] * (1 + 2 * t) * (1 - t) ** 2 + self.y[i + 1] * t * t * (3 - 2 * t)
                + h * t * (1 - t) * (self.slopes[i] * (1 - t) - self.slopes[i + 1] * t))


class Elastic:
    """Hertz 1882."""

    def __init__(self, modulus, radius):
        self.factor = 4 / 3 * modulus * math.sqrt(radius)

    def force(self, approach):
        return self.factor * max(0.0, approach) ** 1.5


class Yielding:
    """Axisymmetric finite elements, elastic-perfectly plastic, frictionless (02_elastoplastic_table_ownFE, _unloading)."""

    def __init__(self, modulus, radius, yield_stress):
        pressure = next(float(row["p0_over_Y_first_yield"]) for row in table("01_hertz_table_yield_vs_nu.csv")
                        if row["nu"] == "0.17") * yield_stress
        self.approach = (math.pi * pressure / (2 * modulus)) ** 2 * radius
        self.unit = 4 / 3 * modulus * math.sqrt(radius) * self.approach ** 1.5
        rows = [row for row in table("02_elastoplastic_table_ownFE.csv") if row["F/Fc_nu0.17"] != "nan"]
        self.loading = Curve([math.log(float(r["w/wc"])) for r in rows], [math.log(float(r["F/Fc_nu0.17"])) for r in rows])
        rows = [r for r in table("02_elastoplastic_table_unloading.csv") if r["nu"] == "0.17"]
        places = [0.0] + [math.log(float(r["w_max/wc"])) for r in rows]
        self.residual = Curve(places, [0.0] + [float(r["w_res/w_max_ownFE"]) for r in rows])
        self.exponent = Curve(places, [1.5] + [float(r["unloading_exponent_fit_ownFE"]) for r in rows])
        self.deepest = 0.0

    def virgin(self, approach):
        w = approach / self.approach
        return self.unit * (w ** 1.5 if w < 1 else math.exp(self.loading(math.log(w))))

    def force(self, approach):
        if approach >= self.deepest:
            self.deepest = max(0.0, approach)
            return self.virgin(approach) if approach > 0 else 0.0
        if self.deepest <= self.approach:
            return self.virgin(approach) if approach > 0 else 0.0
        place = math.log(self.deepest / self.approach)
        left = self.residual(place) * self.deepest
        if approach <= left:
            return 0.0
        return self.virgin(self.deepest) * ((approach - left) / (self.deepest - left)) ** self.exponent(place)


class Rough:
    """From a table of layer displacement over the logarithm of force; zero of the approach: first touch, at `touch` of the largest force."""

    def __init__(self, modulus, radius, log_force, layer, largest, touch=1e-3):
        self.factor = 4 / 3 * modulus * math.sqrt(radius)
        self.layer = Curve(log_force, layer)
        self.first = math.log(touch * largest)
        steps = 400
        self.places = [self.first + (math.log(1.5 * largest) - self.first) * i / steps for i in range(steps + 1)]
        self.approaches = [self.approach(f) - self.approach(self.first) for f in self.places]

    def approach(self, log_force):
        return (math.exp(log_force) / self.factor) ** (2 / 3) + self.layer(log_force)

    def force(self, approach):
        if approach <= 0:
            return 0.0
        i = min(bisect.bisect_right(self.approaches, approach), len(self.places) - 1)
        part = (approach - self.approaches[i - 1]) / (self.approaches[i] - self.approaches[i - 1])
        return math.exp(self.places[i - 1] + part * (self.places[i] - self.places[i - 1]))


def greenwood_tripp(modulus, radius, rms, asperities, largest):
    """Greenwood & Tripp 1967, asperities on a sphere, as solved in 07_rough_table_greenwood_tripp; mu of 1, 4, 17, 50."""
    rows = [r for r in table("07_rough_table_greenwood_tripp.csv")
            if float(r["mu_GT=(8/3)eta*sigma*sqrt(2R*beta)"]) == asperities]
    rows.sort(key=lambda r: -float(r["alpha=sigma*R/a_H^2"]))
    force, layer = [], []
    for row in rows:
        alpha = float(row["alpha=sigma*R/a_H^2"])
        distance = float(row["d/sigma(separation_of_mean_planes_at_r=0_before_bulk_deformation)"])
        force.append(math.log(4 / 3 * modulus * math.sqrt(radius) * (rms / alpha) ** 1.5))
        layer.append(rms * (-distance - 1 / alpha))
    return Rough(modulus, radius, force, layer, largest)


def rough_sphere(name, modulus, radius, largest):
    """Boundary elements (half_space/): loads and approaches in files of rough_spheres/, made by make_rough_spheres."""
    with open(ROUGH / name) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    force = [float(r["normal_force [N]"]) for r in rows]
    factor = 4 / 3 * modulus * math.sqrt(radius)
    layer = [float(r["approach [m]"]) - (f / factor) ** (2 / 3) for r, f in zip(rows, force)]
    return Rough(modulus, radius, [math.log(f) for f in force], layer, largest, touch=2e-3)


class Adhesive:
    """Maugis 1992 (J. Colloid Interface Sci. 150, 243), lambda given; jumps at the ends of its stable branch under fixed approach."""

    def __init__(self, modulus, radius, pull_off, parameter):
        stiffness = 4 / 3 * modulus
        points = [self.point(parameter, 1 + 10 ** (-4.5 + 8.5 * i / 3000)) for i in range(3001)]
        points = sorted((a, p, d) for a, p, d in points if a > 0)
        least = min(range(len(points)), key=lambda i: points[i][2])
        points = points[least:]
        self.coefficient = -min(p for _, p, _ in points)
        work = pull_off / (self.coefficient * math.pi * radius)
        unit = math.pi * work * radius
        length = (math.pi ** 2 * work ** 2 * radius / stiffness ** 2) ** (1 / 3)
        self.approaches = [d * length for _, _, d in points]
        self.forces = [p * unit for _, p, _ in points]
        self.elastic = Elastic(modulus, radius)
        self.touching = False

    @staticmethod
    def point(parameter, m):
        """Radius, force and approach at the ratio m of the cohesive zone's radius to the contact's."""
        root, angle = math.sqrt(m * m - 1), math.acos(1 / m)
        square = parameter / 2 * (root + (m * m - 2) * angle)
        line = 4 / 3 * parameter ** 2 * (root * angle - m + 1)
        a = (-line + math.sqrt(line * line + 4 * square)) / (2 * square)
        return a, a ** 3 - parameter * a * a * (root + m * m * angle), a * a - 4 / 3 * parameter * a * root

    def force(self, approach):
        self.touching = approach >= (self.approaches[0] if self.touching else 0)
        if not self.touching:
            return 0.0
        i = bisect.bisect_right(self.approaches, approach)
        if i >= len(self.approaches):
            return self.elastic.force(approach) - (self.elastic.force(self.approaches[-1]) - self.forces[-1])
        part = (approach - self.approaches[i - 1]) / (self.approaches[i] - self.approaches[i - 1])
        return self.forces[i - 1] + part * (self.forces[i] - self.forces[i - 1])


class Coated:
    """A thin soft film: modulus of the half-space weighted by exp(-t/a) (King 1987; Saha & Nix 2002)."""

    def __init__(self, modulus, radius, softer, thickness):
        self.modulus, self.radius, self.softer, self.thickness = modulus, radius, softer, thickness

    def force(self, approach):
        if approach <= 0:
            return 0.0
        weight = math.exp(-self.thickness / math.sqrt(self.radius * approach))
        of_film = 1 / (self.softer * self.modulus)
        modulus = 1 / (of_film + (1 / self.modulus - of_film) * weight)
        return 4 / 3 * modulus * math.sqrt(self.radius) * approach ** 1.5
