// A reduced law of somebody's own, all of it: a sphere on an elastic foundation (Johnson 1985, sec. 4.3),
//   f_n = pi k R delta^2,   a = (2 R delta)^(1/2),   k: pressure over sinking [Pa/m].
#include <cmath>

#include "dem_compare/laws/law_registry.h"

namespace asperity {
namespace {

struct ElasticFoundation {
  double foundation_modulus = 0;  ///< k [Pa/m]
  double radius = 0;              ///< R [m]

  NormalState advance(const NormalState&, double approach) const {
    if (approach <= 0) return {approach, 0, 0, 0, false};
    return {approach, factor() * approach * approach, std::sqrt(2 * radius * approach),
            2 * factor() * approach, true};
  }
  double approach(double force) const { return std::sqrt(force / factor()); }

 private:
  double factor() const { return M_PI * foundation_modulus * radius; }
};

const LawEntry<ElasticFoundation, NormalMode> entry{
    {"elastic_foundation", "f_n = pi k R delta^2, a = (2 R delta)^(1/2)", "Johnson 1985, sec. 4.3",
     "a thin layer on a stiff body"},
    {{{"foundation_modulus", "Pa/m", "k"}, &ElasticFoundation::foundation_modulus},
     {{"radius", "m", "R"}, &ElasticFoundation::radius}}};

}  // namespace
}  // namespace asperity
