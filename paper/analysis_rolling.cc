// Rolling: the laws in roughness, and the slip in the mean offset (sec. 4.5, 4.6).

#include "core/printed.h"
#include "paper/analysis.h"
#include "paper/friction_series.h"

namespace asperity {

PaperSection series_section(const Published& p, const std::vector<FrictionPoint>& series) {
  const Hertz substrate = p.hertz("silicon"), indenter = p.hertz("diamond");
  const FrictionFit with_r = fit_friction(series, [](double) { return 1.0; });
  const FrictionFit with_a = fit_friction(series, [&](double f) {
    return (substrate.contact_radius(f) + indenter.contact_radius(f)) / 2 / p.radius();
  });
  PaperSection section{"Mean rolling friction of the series (eq:fs1b)", {}};
  const auto add = [&](const std::string& scale, const FrictionFit& fit) {
    const std::string remark =
        printed("correlation of both %.2f, reduced chi2 %.2f", fit.correlation, fit.chi2_reduced);
    section.numbers.push_back(
        not_printed("rolling friction, lambda = " + scale, display::none, fit.coefficient));
    section.numbers.push_back(
        not_printed("rolling offset, lambda = " + scale, display::uN, fit.offset, remark));
  };
  add("r", with_r);
  add("a", with_a);
  return section;
}

PaperSection rolling_section(const Published& p) {
  PaperSection section{"Rolling against roughness (sec. 4.6, eq:rofit)", {}};
  auto& rows = section.numbers;
  const RoughnessLaws laws = roughness_laws(p);
  const auto quoted = [&](const char* name, Dimension dimension) { return p.quoted(name, dimension); };
  rows.push_back({"eq:murofit b", display::none, quoted("murofit_b", Dimension::none), laws.rolling.b});
  rows.push_back({"eq:murofit c", display::none, quoted("murofit_c", Dimension::none), laws.rolling.c});
  rows.push_back({"eq:murofit d", display::nm, quoted("murofit_d", Dimension::length), laws.rolling.d});
  const Uncertain minus_c{-laws.offset.c.value, laws.offset.c.sd};
  rows.push_back({"eq:frofit b'", display::mN, quoted("frofit_b", Dimension::force), laws.offset.b,
                  "computed: through the three surfaces of Table 2, as for eq:murofit; the printed law "
                  "misses them by up to 6.8 sigma"});
  rows.push_back({"eq:frofit c'", display::mN, quoted("frofit_c", Dimension::force), minus_c});
  rows.push_back({"eq:frofit d'", display::nm, quoted("frofit_d", Dimension::length), laws.offset.d});
  for (const auto& s : p.surfaces) {
    rows.push_back({s.name + ": eq:murofit as printed", display::none, s.rolling_r,
                    Uncertain{laws.printed_rolling(s.rms.value)}});
    rows.push_back({s.name + ": eq:frofit as printed", display::uN, s.rolling_r_offset,
                    Uncertain{laws.printed_offset(s.rms.value)}, "does not reproduce Table 2"});
  }
  // eq:barhro with mu_s outside of the fraction, for equal contacts.
  const PublishedSurface& untreated = p.surfaces.front();
  const double mu = untreated.rolling_r.value, h = untreated.rolling_r_offset.value, factor = mu * p.radius();
  rows.push_back({"mean offset of two equal contacts, eq:barhro", display::uN, untreated.rolling_r_offset,
                  Uncertain{mean_rolling({factor, h}, {factor, h}).offset}});
  rows.push_back({"the same with eq:barhro as printed", display::uN, untreated.rolling_r_offset,
                  Uncertain{h * (1 + mu) / 2}, "mu_s belongs inside of the fraction"});
  const Hertz substrate = p.hertz("silicon"), indenter = p.hertz("diamond");
  for (const auto& s : p.surfaces)
    for (const double load : {1e-4, 1e-3, 3e-3}) {
      const double a_over_r =
          (substrate.contact_radius(load) + indenter.contact_radius(load)) / 2 / p.radius();
      const Uncertain ratio =
          propagate([&](const auto& x) { return x[0] * a_over_r * (load + x[1]) / (x[2] * (load + x[3])); },
                    {s.rolling_a, s.rolling_a_offset, s.rolling_r, s.rolling_r_offset});
      rows.push_back(not_printed(
          printed("%s: force with lambda = a over that with r, %g mN", s.name.c_str(), load * 1e3),
          display::none, ratio,
          load < 1e-3 ? "both fit the same data; the sd takes their parameters as independent" : ""));
    }
  return section;
}

}  // namespace asperity
