// The curves of the paper's figures, from its published numbers.
#include <algorithm>
#include <cmath>

#include "core/shear_moduli.h"
#include "paper/analysis.h"

namespace asperity {
namespace {

constexpr int points = 121;

std::vector<double> spaced(double from, double to) {
  std::vector<double> values;
  for (int i = 0; i < points; ++i) values.push_back(from + (to - from) * i / (points - 1));
  return values;
}

template <class F>
std::vector<double> along(const std::vector<double>& x, const F& f) {
  std::vector<double> y;
  for (const double value : x) y.push_back(f(value));
  return y;
}

/// One branch of a friction loop from -limit to limit; s: travel since the reversal. No slip: a straight
/// line.
double no_slip_branch(double s, double stiffness, double limit) {
  return std::min(-limit + stiffness * s, limit);
}

/// Mindlin and Deresiewicz 1953: f = -mu P + 2 mu P (1 - (1 - s/(2 s0))^(3/2)), s0 = 3 mu P/(2 k), the travel
/// of full slip.
double partial_slip_branch(double s, double stiffness, double limit) {
  const double full = 3 * limit / (2 * stiffness), rest = std::max(0.0, 1 - s / (2 * full));
  return limit - 2 * limit * rest * std::sqrt(rest);
}

PaperCurve friction_loop(const Published& p) {
  const double load = p.quoted("loop_load", Dimension::force).value,
               a = p.hertz("silicon").contact_radius(load);
  const double k = 8 * reduced_shear_modulus(p.particle().elasticity, p.body("silicon").elasticity) * a;
  const double k_fit = p.quoted("fitted_lateral_stiffness", Dimension::stiffness).value,
               limit = p.surfaces.front().sliding.value * load;
  constexpr double half_way = 1e-6, near_reversal = 30e-9;
  std::vector<double> travel = spaced(0, near_reversal);
  for (const double far : spaced(near_reversal, 2 * half_way)) travel.push_back(far);
  PaperCurve curve{"fig_slide",
                   "sliding loop at 100 uN: no slip (HM), partial slip (HMD), no slip with the fitted slope",
                   {"displacement [m]", "no_slip [N]", "partial_slip [N]", "fitted_slope [N]"},
                   std::vector<std::vector<double>>(4)};
  for (const int direction : {1, -1})
    for (const double s : travel) {
      const double row[] = {direction * (s - half_way), direction * no_slip_branch(s, k, limit),
                            direction * partial_slip_branch(s, k, limit),
                            direction * no_slip_branch(s, k_fit, limit)};
      for (std::size_t column = 0; column < 4; ++column) curve.values[column].push_back(row[column]);
    }
  return curve;
}

PaperCurve lines(const std::string& name, const std::string& title, const std::vector<double>& forces,
                 const std::vector<std::pair<std::string, std::pair<Uncertain, Uncertain>>>& fits) {
  PaperCurve curve{name, title, {"normal_force [N]"}, {forces}};
  for (const auto& named : fits) {
    const std::string& label = named.first;
    const auto& fit = named.second;  // C++17 lambdas take no structured binding
    std::vector<double> sd;
    curve.columns.push_back(label + " [N]");
    curve.values.push_back(along(forces, [&](double f) { return fit.first.value * (f + fit.second.value); }));
    if (!fit.first.has_sd() || !fit.second.has_sd()) continue;
    curve.columns.push_back(label + "_sd [N]");
    curve.values.push_back(along(forces, [&](double f) {
      return propagate([&](const auto& x) { return x[0] * (f + x[1]); }, {fit.first, fit.second}).sd;
    }));
  }
  return curve;
}

PaperCurve law_in_roughness(const std::string& name, const std::string& title, const std::string& column,
                            const std::string& unit, const ExponentialLaw& printed,
                            const ExponentialFit& refit) {
  constexpr double roughest = 5e-9;
  const auto rms = spaced(0, roughest);
  return {
      name,
      title,
      {"rms [m]", column + "_printed" + unit, column + "_refitted" + unit, column + "_refitted_sd" + unit},
      {rms, along(rms, printed), along(rms, refit.law),
       along(rms, [&](double x) { return refit.at({x}).sd; })}};
}

/// A sphere on fused quartz, with its radius and with the fitted one.
PaperCurve normal_force_curve(const Published& p) {
  const Hertz quartz = p.hertz("fused quartz");
  constexpr double probe_load = 10e-3;
  const Hertz fitted{quartz.reduced_modulus, p.quoted("hertz_fit_radius", Dimension::length).value};
  const auto approach = spaced(0, quartz.approach(probe_load));
  return {"fig_normal_1",
          "normal force against displacement, sphere on fused quartz, R = 8.5 and 9 um",
          {"displacement [m]", "normal_force_R_8.5um [N]", "normal_force_R_9um [N]"},
          {approach, along(approach, [&](double d) { return quartz.force(d); }),
           along(approach, [&](double d) { return fitted.force(d); })}};
}

/// Friction of a rail of the untreated wafer's roughness against its inclination.
PaperCurve inclination_curve(const Published& p) {
  const double quarter = M_PI_2, rolling_here = p.surfaces.front().rolling_r.value;
  const auto angles = spaced(0, quarter);
  return {"fig_rail_3",
          "rail friction against inclination at a constant RMS of 0.3 nm",
          {"rail_angle [rad]", "no_torsion", "torsion_as_rolling"},
          {angles,
           along(angles,
                 [&](double t) {
                   return rail_friction(t, {rolling_here, 0, 0, 0});
                 }),
           along(angles, [&](double t) {
             return rail_friction(t, {rolling_here, rolling_here, 0, 0});
           })}};
}

PaperCurve torsion_curve(const Published& p, const RoughnessLaws& laws, const std::vector<double>& loads) {
  const double R = p.radius(), mu_to = p.quoted("torsion_r").value, mu_to_a = p.quoted("torsion_a").value;
  const Hertz silicon = p.hertz("silicon");
  PaperCurve torsion{"fig_rail_2",
                     "torsion's part of the lateral force, eq:muto2, and its fits",
                     {"normal_force [N]"},
                     {loads}};
  for (const auto& rail : p.rails) {
    torsion.columns.push_back(
        "rail_" + std::to_string(std::lround(rail.angle.value / display::degree.factor)) + "_deg [N]");
    torsion.values.push_back(along(loads, [&](double f) {
      return torsion_force(rail.angle.value, rail.friction.value * (f + rail.offset.value), f,
                           laws.printed_rolling(rail.rms.value), laws.printed_offset(rail.rms.value));
    }));
  }
  torsion.columns.insert(torsion.columns.end(), {"fit_lambda_r [N]", "fit_lambda_a [N]"});
  torsion.values.push_back(along(loads, [&](double f) { return mu_to * f; }));
  torsion.values.push_back(
      along(loads, [&](double f) { return mu_to_a * silicon.contact_radius(f) / R * f; }));
  return torsion;
}

PaperCurve rail_curve(const Published& p, const RoughnessLaws& laws) {
  const double mu_to = p.quoted("torsion_r").value;
  PaperCurve rail{"fig_rail",
                  "rail friction: measured, and eq:murail with and without torsion at each rail's roughness",
                  {"rail_angle [rad]", "rms [m]", "measured", "measured_sd", "with_torsion", "no_torsion"},
                  std::vector<std::vector<double>>(6)};
  for (const auto& r : p.rails) {
    const double mu_ro = laws.printed_rolling(r.rms.value);
    const double row[] = {r.angle.value,
                          r.rms.value,
                          r.friction.value,
                          r.friction.sd,
                          rail_friction(r.angle.value, {mu_ro, mu_to, 0, 0}),
                          rail_friction(r.angle.value, {mu_ro, 0, 0, 0})};
    for (std::size_t column = 0; column < 6; ++column) rail.values[column].push_back(row[column]);
  }
  return rail;
}

}  // namespace

std::vector<PaperCurve> paper_curves(const Published& p) {
  const double largest = p.quoted("largest_load", Dimension::force).value,
               smallest = p.quoted("loop_load", Dimension::force).value;
  const double R = p.radius();
  const Hertz silicon = p.hertz("silicon");
  const RoughnessLaws laws = roughness_laws(p);
  std::vector<PaperCurve> curves;

  const auto loads = spaced(0, largest);
  curves.push_back({"fig_a",
                    "contact radius over particle radius, sphere on silicon",
                    {"normal_force [N]", "a_over_r"},
                    {loads, along(loads, [&](double f) { return silicon.contact_radius(f) / R; })}});

  curves.push_back(normal_force_curve(p));

  std::vector<std::pair<std::string, std::pair<Uncertain, Uncertain>>> sliding, rolling, rails;
  for (const auto& s : p.surfaces) {
    sliding.push_back({s.name, {s.sliding, s.sliding_offset}});
    rolling.push_back({s.name, {s.rolling_r, s.rolling_r_offset}});
  }
  rails.push_back({"0 deg (untreated)", {p.surfaces.front().rolling_r, p.surfaces.front().rolling_r_offset}});
  for (const auto& rail : p.rails)
    rails.push_back({std::to_string(std::lround(rail.angle.value / display::degree.factor)) + " deg",
                     {rail.friction, rail.offset}});
  curves.push_back(lines("fig_sliding_1", "lateral force of sliding, Table 2", spaced(0, smallest), sliding));
  curves.push_back(friction_loop(p));
  curves.push_back(lines("fig_rolling_1", "lateral force of rolling, Table 2", loads, rolling));
  curves.push_back(law_in_roughness("fig_rolling_2_friction",
                                    "rolling friction against RMS roughness, eq:murofit", "rolling_friction",
                                    "", laws.printed_rolling, laws.rolling));
  curves.push_back(law_in_roughness("fig_rolling_2_offset", "rolling offset against RMS roughness, eq:frofit",
                                    "rolling_offset", " [N]", laws.printed_offset, laws.offset));
  curves.push_back(lines("fig_rail_1", "lateral force at one slope of a rail, Table 2", loads, rails));

  curves.push_back(inclination_curve(p));
  curves.push_back(torsion_curve(p, laws, loads));
  curves.push_back(rail_curve(p, laws));
  return curves;
}

}  // namespace asperity
