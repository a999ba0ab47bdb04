// The modulus E* of two bodies one of which relaxes: its shear modulus falls as
//   G(t) = G [1 - g + g exp(-t/tau)]  (standard linear solid, Zener 1948)
// and its bulk modulus K stays. With its plane-strain modulus M = E/(1 - nu^2) as that of shear and bulk,
//   1/M = 1/(4 G) + 3/(4 (3 K + G)),   1/E* = 1/M + (1 - nu_2^2)/E_2,
// where G is its transform G [1 - g/(1 + tau s)] (correspondence principle, Lee & Radok 1960), 1/E* has two
// retardation times and E*(t) two relaxation times:
//   E*(t) = E* [1 - sum_k g_k (1 - exp(-t/tau_k))].
// SI units.
#pragma once

#include <vector>

#include "core/hertz.h"

namespace asperity {

/// Part of a modulus that relaxes, with its time constant.
struct RelaxingPart {
  double share = 0;  ///< g, of the modulus of fast loading [-]
  double time = 0;   ///< tau [s]
};

/// E*(t)/E* by its parts; none: it stays.
using RelaxingModulus = std::vector<RelaxingPart>;

/// E* of the pair where the shear modulus of one body relaxes by `shear`; Poisson's ratio below 1/2.
RelaxingModulus relaxing_modulus(const ElasticBody& relaxing, const RelaxingPart& shear,
                                 const ElasticBody& other);

/// One part that stands for all: with the same modulus in the end and the same lag behind slow loading, sum
/// g_k tau_k.
RelaxingPart as_one_part(const RelaxingModulus& modulus);

/// The shear modulus of the body that makes E* of the pair relax by `pair`, in the sense of as_one_part().
RelaxingPart relaxing_shear(const ElasticBody& relaxing, const RelaxingPart& pair, const ElasticBody& other);

}  // namespace asperity
