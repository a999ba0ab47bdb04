// Tables 1 and 2 as they stand, with what the paper's own fits and balances give beside them.
#include "paper/analysis.h"
#include "paper/friction_series.h"

namespace asperity {
namespace {

/// A published straight line f_l = mu (f + h), taken at equally spaced loads, as a series.
std::vector<FrictionPoint> line_as_series(const Uncertain& mu, const Uncertain& h, double low, double high) {
  constexpr int points = 30;
  std::vector<FrictionPoint> series;
  for (int i = 0; i < points; ++i) {
    const double f = low + (high - low) * i / (points - 1);
    series.push_back({f, {mu.value * (f + h.value)}});
  }
  return series;
}

void add_surfaces(std::vector<PaperNumber>& rows, const Published& p) {
  const RoughnessLaws laws = roughness_laws(p);
  const double low = p.quoted("loop_load", Dimension::force).value,
               high = p.quoted("largest_load", Dimension::force).value;
  const Hertz substrate = p.hertz("silicon"), indenter = p.hertz("diamond");
  const auto mean_a_over_r = [&](double f) {
    return (substrate.contact_radius(f) + indenter.contact_radius(f)) / 2 / p.radius();
  };
  for (const auto& s : p.surfaces) {
    const std::string of = s.name + ": ";
    rows.push_back({of + "RMS roughness", display::nm, s.rms});
    rows.push_back({of + "peak-to-valley", display::nm, s.peak_to_valley});
    rows.push_back({of + "AFM pull-off force h_n", display::uN, s.pull_off});
    rows.push_back({of + "sliding friction mu_l", display::none, s.sliding});
    rows.push_back({of + "sliding offset h_l", display::uN, s.sliding_offset});
    rows.push_back({of + "rolling friction, lambda = r", display::none, s.rolling_r,
                    Uncertain{laws.printed_rolling(s.rms.value)},
                    "computed: eq:murofit with the printed b, c, d"});
    rows.push_back({of + "rolling offset, lambda = r", display::uN, s.rolling_r_offset,
                    Uncertain{laws.printed_offset(s.rms.value)},
                    "computed: eq:frofit with the printed b', c', d', which do not go through these points"});
    const FrictionFit fit =
        fit_friction(line_as_series(s.rolling_r, s.rolling_r_offset, low, high), mean_a_over_r);
    rows.push_back({of + "rolling friction, lambda = a", display::none, s.rolling_a,
                    Uncertain{fit.coefficient.value},
                    "computed: the published line of lambda = r at 30 loads from 100 uN to 3 mN, fitted with "
                    "lambda = a"});
    rows.push_back({of + "rolling offset, lambda = a", display::mN, s.rolling_a_offset,
                    Uncertain{fit.offset.value}, "the same"});
  }
}

void add_rails(std::vector<PaperNumber>& rows, const Published& p) {
  const RoughnessLaws laws = roughness_laws(p);
  for (const auto& rail : p.rails) {
    const std::string of = "rail " + whole_degrees(rail.angle.value) + ": ";
    const bool differs = whole_degrees(rail.angle.value) != whole_degrees(rail.printed_angle);
    rows.push_back({of + "inclination", display::degree, Uncertain{rail.printed_angle, rail.angle.sd},
                    differs ? std::optional<Uncertain>(rail.angle) : std::nullopt,
                    differs ? "text and figures say " + whole_degrees(rail.angle.value) +
                                  "; the torque balance agrees with that, and eq:muto2's assumption is exact "
                                  "where 2 cos(theta) = 1"
                            : ""});
    rows.push_back({of + "RMS roughness", display::nm, rail.rms});
    const RailFriction friction{laws.printed_rolling(rail.rms.value), p.quoted("torsion_r").value,
                                laws.printed_offset(rail.rms.value), 0};
    rows.push_back({of + "rail friction", display::none, rail.friction,
                    Uncertain{rail_friction(rail.angle.value, friction)}, "computed: eq:murail, see below"});
    rows.push_back({of + "rail offset", display::uN, rail.offset,
                    Uncertain{rail_offset(rail.angle.value, friction)},
                    "computed: h_rail without torsion's own offset, see below"});
  }
}

}  // namespace

PaperSection table_1(const Published& p) {
  PaperSection section{"Table 1: material properties", {}};
  for (const auto& body : p.bodies) {
    section.numbers.push_back({body.name + " (" + body.role + "): Young's modulus", display::GPa,
                               Uncertain{body.elasticity.youngs_modulus}});
    section.numbers.push_back(
        {body.name + ": Poisson's ratio", display::none, Uncertain{body.elasticity.poisson_ratio}});
    if (std::isfinite(body.rms.value))
      section.numbers.push_back({body.name + ": RMS roughness", display::nm, body.rms});
    if (std::isfinite(body.radius))
      section.numbers.push_back({body.name + ": radius",
                                 display::um,
                                 Uncertain{body.radius},
                                 {},
                                 "bought as 17.3 ± 1.0 um in diameter (8.65 um), called about 10 um in the "
                                 "text; the authors' published simulation takes 10 um"});
  }
  return section;
}

PaperSection table_2(const Published& p) {
  PaperSection section{"Table 2: contact properties of silicon surfaces and rails", {}};
  add_surfaces(section.numbers, p);
  add_rails(section.numbers, p);
  section.numbers.push_back({"torsion friction, lambda = r",
                             display::none,
                             p.quoted("torsion_r"),
                             {},
                             "printed with index i; the indenter has no torsion: it is the substrate's"});
  section.numbers.push_back({"torsion friction, lambda = a", display::none, p.quoted("torsion_a")});
  section.numbers.push_back({"torsion friction, lambda = a, as the conclusion has it", display::none,
                             p.quoted("torsion_a_conclusion"), p.quoted("torsion_a"),
                             "the conclusion says 0.065; text and this table say 0.064"});
  return section;
}

}  // namespace asperity
