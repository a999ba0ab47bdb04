// A body whose shear modulus relaxes with time, and that does not yield.
#pragma once

#include "fem/materials/material_law.h"

namespace asperity::fem {

inline const Registered<MaterialDeclaration> standard_linear_solid{
    {{"Standard linear solid",
      "G(t) = G [1 - g (1 - exp(-t/tau))]",
      "Zener (1948)",
      "small strain, about a decade of time; the bulk modulus stays, and the body does not yield. "
      "Experiment/Load time, Hold time and Speed say how fast",
      {{"Relaxing share",
        {"g"},
        Dimension::none,
        "g, part of the shear modulus that relaxes under a held strain; Young modulus and Poisson ratio are "
        "those of fast loading. 0: none does.",
        "0",
        below_one},
       {"Relaxation time",
        {"tau"},
        Dimension::time,
        "tau, after which 1/e of the relaxing share is left; 0: none relaxes.",
        "0 s"}}},
     [](const LawValues& values) -> MaterialLaw {
       MaterialLaw elastic{default_of(yield_stress_parameter())};
       elastic.relaxation = {values.at("Relaxing share"), values.at("Relaxation time")};
       return elastic;
     },
     [](double, const LawValues& values) -> MaterialObjection {
       const bool has_share = values.at("Relaxing share") > 0;
       if (has_share == (values.at("Relaxation time") > 0)) return {};
       return {has_share ? "Relaxing share" : "Relaxation time",
               "'s relaxation needs both Relaxing share and Relaxation time above 0; set both or neither"};
     }}};

}  // namespace asperity::fem
