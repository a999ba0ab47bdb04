// Statements of the text about orders of magnitude (sec. 4.3, 4.5, 4.7, 5).

#include "core/printed.h"
#include "paper/analysis.h"

namespace asperity {

PaperSection magnitudes_section(const Published& p) {
  PaperSection section{"Orders of magnitude in the text (sec. 4.3, 4.5, 4.7, 5)", {}};
  auto& rows = section.numbers;
  for (const auto& s : p.surfaces) {
    for (const double load : {1e-4, 3e-3}) {
      const Uncertain ratio =
          propagate([&](const auto& x) { return x[0] * (load + x[1]) / (x[2] * (load + x[3])); },
                    {s.sliding, s.sliding_offset, s.rolling_r, s.rolling_r_offset});
      rows.push_back(not_printed(
          printed("%s: sliding over rolling force at %g mN", s.name.c_str(), load * 1e3), display::none,
          ratio, load < 1e-3 ? "'2-3 orders of magnitude': below two at the lowest load" : ""));
    }
    const Uncertain orders =
        propagate([](const auto& x) { return std::log10(x[0] / x[1]); }, {s.rolling_r_offset, s.pull_off});
    rows.push_back(not_printed(s.name + ": orders of magnitude between h_ro and h_n", display::none, orders,
                               "'2.5 orders'"));
    const Uncertain times =
        propagate([](const auto& x) { return x[0] / x[1]; }, {s.sliding_offset, s.pull_off});
    rows.push_back(not_printed(s.name + ": h_l over h_n", display::none, times,
                               "'about 4, decreasing': h_l is not monotonic in roughness"));
  }
  const PublishedSurface& s = p.surfaces.front();
  const double load = p.quoted("loop_load", Dimension::force).value;
  const Uncertain rolling =
      propagate([&](const auto& x) { return x[0] * (load + x[1]); }, {s.rolling_r, s.rolling_r_offset});
  const Uncertain sliding =
      propagate([&](const auto& x) { return x[0] * (load + x[1]); }, {s.sliding, s.sliding_offset});
  rows.push_back(not_printed("lateral force of rolling at 100 uN, untreated", display::uN, rolling));
  rows.push_back(not_printed("lateral force of sliding at 100 uN, untreated", display::uN, sliding));
  rows.push_back(not_printed(
      "friction at the diamond below which it would slide first", display::none,
      Uncertain{rolling.value / load, rolling.sd / load},
      "the fitted law gives no threshold of 100 uN for rolling: the diamond would have to be this slippery"));
  return section;
}

PaperSection equations_section() {
  return {
      "Signs and labels of equations (sec. 3.1, 3.2, 4.6, 4.8)",
      {remark_alone("elastic force of sliding, rolling and torsion",
                    "printed f_el = +k delta, which would drive the motion; 'act against' and df/dx = -k of "
                    "the loop need -k delta"),
       remark_alone("normal relative velocity",
                    "printed v.n = d delta/dt; with n from contact to particle and delta = R - r it is -d "
                    "delta/dt, as the dissipative force has it"),
       remark_alone("after eq:torques1b", "printed f_i^l = -f_i^s; it is -f_s^l"),
       remark_alone("before eq:muto", "cites eq:barlaro; it uses eq:barmuro"),
       remark_alone("caption of fig. rail", "printed lambda = r_s^to; it is r_s"),
       remark_alone("Table 2, torsion friction",
                    "printed mu_i^to; it is mu_s^to, as the indenter has no torsion"),
       remark_alone("assumption before eq:muto2, 'for 60 deg it can be proven'",
                    "it holds where 2 cos(theta) = 1: the third rail has 60 deg, not the 65 deg of Table 2"),
       remark_alone("the authors' published simulation (MercuryDPM, Drivers/Papers/SlidingRollingTorsion)",
                    "has R = 10 um, a linear spring, mu_ro = 0.00103, mu_to = 0.005, nu = 0.17 for silicon, "
                    "and no partial slip: it does not give the figures")}};
}

}  // namespace asperity
