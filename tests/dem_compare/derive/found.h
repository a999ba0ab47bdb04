// What a derivation found, by the type of the fact.
#pragma once

#include "dem_compare/derive/derivation.h"

namespace asperity::test {

template <class F>
const F* found(const LawFindings& findings) {
  for (const auto& fact : findings.found)
    if (const auto* one = std::get_if<F>(&fact)) return one;
  return nullptr;
}

inline const OpenQuestion* asked(const LawFindings& findings, OpenQuestion::About about) {
  for (const auto& question : findings.open)
    if (question.about == about) return &question;
  return nullptr;
}

inline const Origin* origin(Derivation derivation, Derivation::Member member, Origin::From from) {
  static std::vector<Origin> kept;
  kept = derivation.origin_of(member);
  for (const auto& one : kept)
    if (one.from == from) return &one;
  return nullptr;
}

}  // namespace asperity::test
