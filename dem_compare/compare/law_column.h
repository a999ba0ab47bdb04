// What reduced laws say: the second column of the comparison; and what an engine is asked to do with the same
// numbers. SI units.
//   normal   Hertz 1882: delta(F), k_n = 2 E* a
//   sliding  Mindlin 1949 without slip: k_l = 8 G* a; Mindlin & Deresiewicz 1953 with equal work up to
//   sliding: (5/6) 8 G* a;
//            Coulomb with offset: mu (1 + h/F)
//   rolling  a spring and slider with offset: mu_ro (lambda/r) (1 + h/F), k_ro
//   torsion  Reissner & Sagoci 1944: k_to = (16/3) Gt a^3; the assumption 8 G* a r^2 of Fuchs, Weinhart et
//   al. 2014, sec. 3.2;
//            full slip (3 pi/16) mu a/r (Lubkin 1951)
//   rail     eq:murail and h_rail of the same paper
#pragma once

#include <vector>

#include "dem_compare/compare/engine_request.h"
#include "dem_compare/compare/row.h"

namespace asperity {

/// A law's value, and what an engine is asked to check it.
struct LawValue : ComparedValue {
  std::optional<EngineRequest> engine;
  std::string no_engine;  ///< why there is no request
};

/// One or more laws; one without a value says why. `rail` is needed for rails alone.
std::vector<LawValue> law_values(Quantity quantity, const ComparedContact& contact, double load,
                                 const RailCase* rail = nullptr);

}  // namespace asperity
