// Rolling in the rails, and the torsion that it asks for (sec. 4.8).

#include "paper/analysis.h"
#include "paper/friction_series.h"

namespace asperity {
namespace {

/// The printed law at the rail's roughness; its sd from the rail's RMS and, for the law itself, from the
/// refit.
Uncertain at_rail(const ExponentialLaw& printed, const ExponentialFit& refit, const Uncertain& rms) {
  return {printed(rms.value), refit.at(rms).sd};
}

}  // namespace

PaperSection rail_section(const Published& p) {
  PaperSection section{"Rails: rolling and torsion (sec. 4.8, eq:murail)", {}};
  auto& rows = section.numbers;
  const RoughnessLaws laws = roughness_laws(p);
  const Uncertain torsion = p.quoted("torsion_r");
  std::vector<double> inverted, variances;
  for (const auto& rail : p.rails) {
    const std::string of = whole_degrees(rail.angle.value) + ": ";
    const Uncertain rolling = at_rail(laws.printed_rolling, laws.rolling, rail.rms);
    const Uncertain offset = at_rail(laws.printed_offset, laws.offset, rail.rms);
    rows.push_back(not_printed(of + "mu_ro at the rail's roughness, eq:murofit", display::none, rolling));
    const auto friction = [](const std::vector<double>& x) {
      return rail_friction(x[0], {x[1], x[2], 0, 0});
    };
    const Uncertain predicted = propagate(friction, {rail.angle, rolling, torsion});
    rows.push_back({of + "mu_rail, eq:murail with mu_to = 0.0056", display::none, rail.friction, predicted});
    rows.push_back({of + "mu_rail without torsion", display::none, rail.friction,
                    propagate(friction, {rail.angle, rolling, Uncertain{0}})});
    const auto back = [](const std::vector<double>& x) { return torsion_from_rail(x[0], x[1], x[2]); };
    if (rail.printed_angle != rail.angle.value) {
      const Uncertain printed{rail.printed_angle, rail.angle.sd};
      rows.push_back(
          {of + "mu_rail at " + whole_degrees(rail.printed_angle) + ", as Table 2 prints the angle",
           display::none, rail.friction, propagate(friction, {printed, rolling, torsion}),
           "the angle of the text agrees with the measurement, that of the table does not"});
      rows.push_back({of + "mu_to from mu_rail at " + whole_degrees(rail.printed_angle), display::none,
                      torsion, propagate(back, {printed, rail.friction, rolling})});
    }
    const Uncertain mu_to = propagate(back, {rail.angle, rail.friction, rolling});
    rows.push_back({of + "mu_to from mu_rail", display::none, torsion, mu_to});
    inverted.push_back(mu_to.value);
    variances.push_back(mu_to.sd * mu_to.sd);
    const auto h_rail = [](const std::vector<double>& x) { return rail_offset(x[0], {x[1], x[2], x[3], 0}); };
    rows.push_back({of + "h_rail with h_to = 0", display::uN, rail.offset,
                    propagate(h_rail, {rail.angle, rolling, torsion, offset}), "with eq:frofit as printed"});
    rows.push_back({of + "h_rail with h_to = 0 and eq:frofit refitted", display::uN, rail.offset,
                    propagate(h_rail, {rail.angle, rolling, torsion, laws.offset.at(rail.rms)})});
    const auto h_to = [&](const std::vector<double>& x) {
      return torsion_offset_from_rail(x[0], x[4], rail.offset.value, {x[1], x[2], x[3], 0});
    };
    const Uncertain implied = propagate(h_to, {rail.angle, rolling, torsion, offset, rail.friction});
    rows.push_back(not_printed(
        of + "h_to that h_rail asks for", display::uN, implied,
        implied.value < 0 ? "a negative offset has no meaning: the paper's 'cannot be defined'" : ""));
  }
  const double count = static_cast<double>(inverted.size());
  Uncertain mean{0, 0};
  for (std::size_t i = 0; i < inverted.size(); ++i) {
    mean.value += inverted[i] / count;
    mean.sd += variances[i];
  }
  mean.sd = std::sqrt(mean.sd) / count;
  rows.push_back({"mean mu_to from the three rails", display::none, torsion, mean});
  return section;
}

}  // namespace asperity
