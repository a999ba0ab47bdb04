// Series of steady lateral forces: rolling between substrate and indenter, rolling in a V-groove, spinning
// about the normal.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/hertz.h"
#include "diagnosis/conceal/sphere.h"
#include "diagnosis/conceal/world.h"

namespace asperity::hidden {
namespace {

const ElasticBody borosilicate{71e9, 0.17}, silicon{179e9, 0.25}, diamond{1140e9, 0.07};
constexpr double radius = 8.5e-6;

struct Row {
  double load = 0, speed = 0, rms = 0, angle = 0;
  int direction = 1;
};

std::vector<Row> rows_of(const WorldRequest& request, Random& random) {
  const bool adheres = request.asks_for("rolling_adhesion_hysteresis");
  const double largest = adheres ? between(random, 200e-6, 500e-6) : between(random, 2e-3, 4e-3);
  std::vector<double> loads, speeds{1e-6}, roughness{0.3e-9}, angles{0};
  const bool few_loads = request.asks_for("roughness_dependent_rolling") ||
                         request.asks_for("viscous_rolling") || request.mode == Motion::rail;
  const int count = few_loads ? 7 : adheres ? 12 : 24;
  for (int i = 0; i < count; ++i) loads.push_back(largest * (i + 1) / count);
  if (request.asks_for("viscous_rolling")) speeds = {1e-6, 5e-6, 20e-6, 50e-6};
  if (request.asks_for("roughness_dependent_rolling"))
    roughness = {0.3e-9, 0.8e-9, 1.5e-9, 2.7e-9, 4e-9, 6e-9};
  if (request.mode == Motion::rail) angles = {25 * pi / 180, 45 * pi / 180, 60 * pi / 180};
  // Both directions of rolling, as loops give them: what keeps its sign belongs to the instrument.
  const std::vector<int> directions =
      request.mode == Motion::rolling ? std::vector<int>{1, -1} : std::vector<int>{1};
  std::vector<Row> rows;
  for (const double angle : angles)
    for (const double rms : roughness)
      for (const double speed : speeds)
        for (const double load : loads)
          for (const int direction : directions) rows.push_back({load, speed, rms, angle, direction});
  return rows;
}

void choose_series_parameters(World& world, const WorldRequest& request, const std::vector<Row>& rows,
                              double friction, Random& random) {
  double largest = 0, fastest = 0;
  for (const auto& row : rows) largest = std::max(largest, row.load), fastest = std::max(fastest, row.speed);
  for (const auto& id : request.effects) {
    if (id == "rolling_adhesion_offset")
      world.hide(id, "constant attraction at every contact", "adhesion_force",
                 between(random, 0.15, 0.5) * largest);
    else if (id == "rolling_adhesion_hysteresis")
      world.hide(id, "work lost over the width of a true sphere's contacts (Sneddon 1965)", "work_lost",
                 between(random, 0.03, 0.12));
    else if (id == "adhesion_offset")
      world.hide(id, "constant attraction that widens the contact (Derjaguin, Muller & Toporov 1975)",
                 "adhesion_force", between(random, 0.05, 0.2) * largest);
    else if (id == "contact_radius_scaling") {
      const double a =
          Sphere{reduced_modulus(borosilicate, silicon), radius}.contact_radius_at_force(largest / 2);
      if (request.mode == Motion::torsion)
        world.hide(id,
                   "moment of the pressure of a Hertzian contact that slips everywhere, summed over rings",
                   "rolling_friction", friction * radius / a);
      else
        world.hide(id, "radii of contact of a true sphere (Sneddon 1965)", "rolling_friction",
                   friction * radius / a);
    } else if (id == "roughness_dependent_rolling") {
      const char* model = "exponential in the roughness of each substrate";
      world.hide(id, model, "b", friction * between(random, 0.3, 0.5));
      world.hide(id, model, "c", friction * between(random, 0.6, 1.2));
      world.hide(id, model, "decay_length", between(random, 0.8e-9, 2e-9));
    } else if (id == "viscous_rolling")
      world.hide(id, "delayed part of a Maxwell-Kelvin contact at small Deborah number", "coefficient",
                 between(random, 0.3, 1) * friction / fastest);
    else if (id == "torsion_resistance")
      world.hide(id, "power of the moments as vectors at three contacts", "torsion_friction",
                 between(random, 2, 8) * friction);
    else if (id == "resistance_peak") {
      world.hide(id, "resistance is larger near one load", "share", between(random, 0.3, 0.6), false);
      world.hide(id, "", "place", between(random, 0.3, 0.6) * largest, false);
    }
  }
}

/// Lateral force at the plate of a sphere that rolls in a groove, by its power: the sphere turns about y; the
/// plate resists with its moment, each slope with a rolling moment across its normal and a torsion moment
/// along it.
double groove_force(double angle, double plate_moment, double slope_rolling, double slope_torsion) {
  using Vector = Eigen::Vector3d;
  const Vector rotation = Vector::UnitY();
  double power = plate_moment;  // of unit rotation
  for (const double side : {-1.0, 1.0}) {
    const Vector normal(0, side * std::sin(angle), std::cos(angle));
    const double spin = rotation.dot(normal);
    const Vector rolling = rotation - spin * normal;
    power += slope_rolling * rolling.norm() + slope_torsion * std::abs(spin);
  }
  // The sphere turns about the line through both slopes' contacts, a distance r cos(theta) below the centre.
  const double lever = radius * (1 + std::cos(angle));
  return power / lever;
}

class SeriesLaw {
 public:
  SeriesLaw(const World& world, double friction, bool with_effects)
      : world_(world), friction_(friction), with_effects_(with_effects) {}

  double rolling(const Row& row) const {
    const double below = length(reduced_modulus(borosilicate, silicon), row.load),
                 above = length(reduced_modulus(borosilicate, diamond), row.load);
    const double mu = coefficient(row), borne = row.load + of("rolling_adhesion_offset", "adhesion_force");
    return peak(row) * (mu * (below + above) * borne / (2 * radius) + lost_work(row));
  }

  double rail(const Row& row) const {
    const double slope = row.load / (2 * std::cos(row.angle)),
                 h = of("rolling_adhesion_offset", "adhesion_force");
    const double mu = coefficient(row), torsion = of("torsion_resistance", "torsion_friction");
    return groove_force(row.angle, mu * radius * (row.load + h), mu * radius * (slope + h),
                        torsion * radius * (slope + h));
  }

  /// Moment over the particle's radius.
  double torsion(const Row& row) const {
    if (!has("contact_radius_scaling")) return friction_ * row.load;
    // mu_local p(r) r summed over rings; (3 pi/16) of mu_local makes the catalogue's coefficient.
    const double pressed = row.load + of("adhesion_offset", "adhesion_force"),
                 a = Sphere{reduced_modulus(borosilicate, silicon), radius}.contact_radius_at_force(pressed);
    const double local = of("contact_radius_scaling", "rolling_friction") / (3 * pi / 16),
                 peak = 1.5 * pressed / (pi * a * a);
    constexpr int rings = 400;
    double moment = 0;
    for (int i = 0; i < rings; ++i) {
      const double x = (i + 0.5) / rings;
      moment += local * peak * std::sqrt(1 - x * x) * (x * a) * 2 * pi * x * a * (a / rings);
    }
    return moment / radius;
  }

 private:
  bool has(const char* id) const { return with_effects_ && world_.hides(id); }
  double of(const char* id, const char* parameter) const {
    return with_effects_ ? world_.value(id, parameter) : 0;
  }
  double length(double modulus, double load) const {
    return has("contact_radius_scaling") ? Sphere{modulus, radius}.contact_radius_at_force(load) : radius;
  }
  /// Mean over both contacts, which open over their width.
  double lost_work(const Row& row) const {
    if (!has("rolling_adhesion_hysteresis")) return 0;
    const Sphere sphere{reduced_modulus(borosilicate, silicon), radius};
    return of("rolling_adhesion_hysteresis", "work_lost") * 2 * sphere.contact_radius_at_force(row.load);
  }
  double peak(const Row& row) const {
    if (!has("resistance_peak")) return 1;
    constexpr double width = 0.25;  // of the logarithm of load
    const double x = std::log(row.load / of("resistance_peak", "place")) / width;
    return 1 + of("resistance_peak", "share") * std::exp(-x * x / 2);
  }
  double coefficient(const Row& row) const {
    if (has("rolling_adhesion_hysteresis")) return 0;  // smooth elastic bodies lose nothing else
    double mu = friction_;
    if (has("contact_radius_scaling")) mu = of("contact_radius_scaling", "rolling_friction");
    if (has("roughness_dependent_rolling"))
      mu = of("roughness_dependent_rolling", "b") +
           of("roughness_dependent_rolling", "c") *
               std::exp(-row.rms / of("roughness_dependent_rolling", "decay_length"));
    return mu + of("viscous_rolling", "coefficient") * row.speed;
  }

  const World& world_;
  double friction_;
  bool with_effects_;
};

}  // namespace

World series_world(const WorldRequest& request) {
  Random random(request.seed);
  World world;
  world.recording = paper_bodies(request.mode, "concealed series, " + name_of(request.mode));
  const std::vector<Row> rows = rows_of(request, random);
  const double friction = between(random, 4e-4, 2e-3);
  choose_series_parameters(world, request, rows, friction, random);
  const std::string name = request.mode == Motion::torsion ? "torsion_friction" : "rolling_friction";
  world.coefficients[name] = friction;
  if (request.mode == Motion::torsion && world.hides("contact_radius_scaling"))
    world.coefficients["sliding_friction"] =  // local
        world.value("contact_radius_scaling", "rolling_friction") / (3 * pi / 16);
  if (world.hides("rolling_adhesion_hysteresis")) world.recording.indenter = world.recording.substrate;
  world.recording.simulation_is_given = true;
  if (request.mode == Motion::torsion) world.recording.simulation.torsion = "constant";
  world.recording.simulation.parameters[name] = {friction * between(random, 0.7, 1.4), true};

  RecordingTable table;
  table.file = "series.csv";
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.response = "lateral_force";
  const bool several_speeds = rows.front().speed != rows.back().speed,
             several_rms = rows.front().rms != rows.back().rms;
  const SeriesLaw with(world, friction, true), plain(world, friction, false);
  std::vector<double> without;
  for (const auto& row : rows) {
    table.columns["normal_force"].push_back(row.load);
    if (several_speeds) table.columns["speed"].push_back(row.speed);
    if (several_rms) table.columns["rms_roughness"].push_back(row.rms);
    if (request.mode == Motion::rail) table.columns["rail_angle"].push_back(row.angle);
    const auto force = [&](const SeriesLaw& law) {
      return row.direction * (request.mode == Motion::rolling ? law.rolling(row)
                              : request.mode == Motion::rail  ? law.rail(row)
                                                              : law.torsion(row));
    };
    if (request.mode == Motion::rolling) table.segment.push_back(row.direction > 0 ? "forward" : "backward");
    table.columns["lateral_force"].push_back(force(with));
    without.push_back(force(plain));
  }
  world.recording.tables = {table};
  world.without_effects = {without};
  return world;
}

}  // namespace asperity::hidden
