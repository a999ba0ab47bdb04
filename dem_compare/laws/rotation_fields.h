// Parameters that laws of rolling and torsion share.
#pragma once

#include <vector>

#include "dem_compare/laws/law_registry.h"

namespace asperity {

/// Of a law with the member `stiffness`.
template <class Law>
std::vector<LawField<Law>> spring_fields() {
  return {{{"stiffness", "N m/rad, N/rad or Pa", "K, K/a, G* or Gt, as stiffness_law has it"},
           &Law::stiffness,
           &RotationalStiffness::value},
          {{"stiffness_law",
            "",
            "constant K; K/a with_radius; K = 8 G* a lambda r; K = (16/3) Gt a^3",
            0,
            3,
            0,
            {"constant", "with_radius", "tangential_spring", "no_slip_torsion"}},
           &Law::stiffness,
           &RotationalStiffness::kind}};
}

/// Of a law mu lambda (f_n + h) with such a spring.
template <class Law>
std::vector<LawField<Law>> resistance_fields() {
  std::vector<LawField<Law>> fields{
      {{"coefficient", "", "mu"}, &Law::coefficient},
      {zero_otherwise({"adhesion_force", "N", "offset h"}), &Law::adhesion_force},
      {{"length",
        "",
        "lambda; with none, mu is a length [m]",
        0,
        2,
        1,
        {"none", "particle_radius", "contact_radius"}},
       &Law::length}};
  for (const auto& field : spring_fields<Law>()) fields.push_back(field);
  return fields;
}

}  // namespace asperity
