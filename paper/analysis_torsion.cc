// Torsion in the rails (sec. 3.2.4, 4.7, 4.8).

#include "core/printed.h"
#include "core/shear_moduli.h"
#include "dem_compare/laws/hertzian_torsion.h"
#include "paper/analysis.h"
#include "paper/friction_series.h"

namespace asperity {
namespace {

/// The two length scales of the coefficient.
void add_length_scales(std::vector<PaperNumber>& rows, const Published& p) {
  const Hertz hertz = p.hertz("silicon");
  const double R = p.radius();
  const Uncertain with_r = p.quoted("torsion_r"), with_a = p.quoted("torsion_a");
  for (const double f : {1e-4, 5e-4, 1e-3, 3e-3}) {
    const double a_over_r = hertz.contact_radius(f) / R;
    rows.push_back({printed("0.064 a/r at %g mN", f * 1e3), display::none, with_r,
                    Uncertain{with_a.value * a_over_r, with_a.sd * a_over_r},
                    f == 1e-4 ? "the two scalings are not equivalent over the measured loads" : ""});
  }
  const double equal_a = with_r.value / with_a.value * R;  // f = (4/3) E* a^3/R
  rows.push_back(not_printed("load at which both scalings agree", display::mN,
                             Uncertain{4.0 / 3 * hertz.reduced_modulus * equal_a * equal_a * equal_a / R}));
}

/// The torsion force of eq:muto2 from the published lines, all rails together, fitted with both length
/// scales.
void add_fits_of_torsion(std::vector<PaperNumber>& rows, const Published& p) {
  const Hertz hertz = p.hertz("silicon");
  const double R = p.radius();
  const double load = p.quoted("loop_load", Dimension::force).value;
  const Uncertain with_r = p.quoted("torsion_r"), with_a = p.quoted("torsion_a");
  const RoughnessLaws laws = roughness_laws(p);
  std::vector<FrictionPoint> series;
  for (const auto& rail : p.rails) {
    constexpr int points = 30;
    const double c = std::cos(rail.angle.value),
                 high = p.quoted("largest_load", Dimension::force).value / (2 * c), low = load / (2 * c);
    for (int i = 0; i < points; ++i) {
      const double f = low + (high - low) * i / (points - 1),
                   lateral = rail.friction.value * (f + rail.offset.value);
      series.push_back({f,
                        {torsion_force(rail.angle.value, lateral, f, laws.printed_rolling(rail.rms.value),
                                       laws.printed_offset(rail.rms.value))}});
    }
  }
  const std::string how =
      "computed: eq:muto2 on the published lines of all three rails at 30 loads each, offset fitted too";
  rows.push_back({"mu_to of eq:muto2, lambda = r", display::none, with_r,
                  Uncertain{fit_friction(series, [](double) { return 1.0; }).coefficient.value}, how});
  rows.push_back(
      {"mu_to of eq:muto2, lambda = a", display::none, with_a,
       Uncertain{
           fit_friction(series, [&](double f) { return hertz.contact_radius(f) / R; }).coefficient.value},
       how});
}

/// The sphere glued into a rail: sliding friction there; returned.
Uncertain add_glued_sphere(std::vector<PaperNumber>& rows, const Published& p) {
  const double f_slope =
      p.quoted("glued_rail_load", Dimension::force).value / (2 * std::cos(p.rails.front().angle.value));
  const Uncertain force = p.quoted("glued_rail_force", Dimension::force),
                  rough_offset = p.surfaces.back().sliding_offset;
  const double low = p.quoted("rail_sliding_friction_low").value,
               high = p.quoted("rail_sliding_friction_high").value;
  const Uncertain expected{(low + high) / 2, (high - low) / 2};
  const Uncertain mu_glued{force.value / (2 * f_slope), force.sd / (2 * f_slope)};
  rows.push_back({"mu_l of the glued sphere in the 25 deg rail", display::none, expected, mu_glued,
                  "26 uN at 100 uN on the plate, 55.2 uN on each slope: far below the 0.63 to 0.72 "
                  "extrapolated from the wafers"});
  rows.push_back(
      {"the same with h_l = 7.76 uN", display::none, expected,
       propagate([&](const auto& x) { return x[0] / (2 * (f_slope + x[1])); }, {force, rough_offset})});
  const std::string per_slope = "mu_l of the glued sphere if 26 uN is the force on one slope";
  rows.push_back({per_slope, display::none, expected, Uncertain{force.value / f_slope, force.sd / f_slope},
                  "nor does it reach the extrapolated one if the force is one slope's"});
  rows.push_back({per_slope + ", with h_l = 7.76 uN", display::none, expected,
                  propagate([&](const auto& x) { return x[0] / (f_slope + x[1]); }, {force, rough_offset})});
  rows.push_back({"lateral force that mu_l = 0.63 gives", display::uN, force,
                  Uncertain{2 * low * (f_slope + rough_offset.value)}});
  rows.push_back({"lateral force that mu_l = 0.72 gives", display::uN, force,
                  Uncertain{2 * high * (f_slope + rough_offset.value)}});
  return mu_glued;
}

/// How far torsion friction lies below what sliding friction lets expect.
void add_gap_to_sliding(std::vector<PaperNumber>& rows, const Published& p, const Uncertain& mu_glued) {
  const Uncertain with_a = p.quoted("torsion_a");
  constexpr double tomas = 2.0 / 3;
  rows.push_back({"(2/3) mu_l over mu_to, mu_l of the glued sphere", display::none, p.quoted("torsion_gap"),
                  Uncertain{tomas * mu_glued.value / with_a.value},
                  "uniform pressure (Tomas); not seven times with the friction measured in the rail itself"});
  rows.push_back({"(3 pi/16) mu_l over mu_to, mu_l of the glued sphere", display::none,
                  p.quoted("torsion_gap"),
                  Uncertain{full_slip_torsion_coefficient(mu_glued.value) / with_a.value},
                  "Hertz pressure, full slip (Dintwa): 2/3 is 13 % above it"});
  constexpr double rough_wafer = 0.65;
  rows.push_back({"(2/3) mu_l over mu_to, mu_l = 0.65", display::none, p.quoted("torsion_gap"),
                  Uncertain{tomas * rough_wafer / with_a.value}});
  rows.push_back({"(3 pi/16) mu_l over mu_to, mu_l = 0.65", display::none, p.quoted("torsion_gap"),
                  Uncertain{full_slip_torsion_coefficient(rough_wafer) / with_a.value}});
}

void add_torsion_stiffness(std::vector<PaperNumber>& rows, const Published& p) {
  const Hertz hertz = p.hertz("silicon");
  const double R = p.radius();
  const double load = p.quoted("loop_load", Dimension::force).value;
  const double a = hertz.contact_radius(load),
               k = 8 * reduced_shear_modulus(p.particle().elasticity, p.body("silicon").elasticity) * a;
  const double no_slip =
      no_slip_torsion_stiffness(torsion_modulus(p.particle().elasticity, p.body("silicon").elasticity), a);
  rows.push_back(not_printed("k_to = 8 G* a with the lever r", display::Nm_per_rad, Uncertain{k * R * R}));
  rows.push_back(not_printed("no-slip torsion (16/3) G a^3", display::Nm_per_rad, Uncertain{no_slip},
                             "1/G = 1/G1 + 1/G2 (Mindlin 1949; Reissner and Sagoci 1944)"));
  rows.push_back(not_printed("ratio of both", display::none, Uncertain{k * R * R / no_slip},
                             "a choice of the simulation: finite elements are not to be compared with it"));
  rows.push_back(
      not_printed("k_to = 8 G* a with lambda = a and lever r", display::Nm_per_rad, Uncertain{k * a * R}));
  rows.push_back(not_printed("k_to = 8 G* a with lambda = a, over no-slip torsion", display::none,
                             Uncertain{k * a * R / no_slip}));
}

}  // namespace

PaperSection torsion_section(const Published& p) {
  PaperSection section{"Torsion: length scale, gap to sliding, stiffness (sec. 3.2.4, 4.7, 4.8)", {}};
  auto& rows = section.numbers;
  add_length_scales(rows, p);
  add_fits_of_torsion(rows, p);
  const Uncertain mu_glued = add_glued_sphere(rows, p);
  add_gap_to_sliding(rows, p, mu_glued);
  add_torsion_stiffness(rows, p);
  return section;
}

}  // namespace asperity
