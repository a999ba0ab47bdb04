// The reduced laws by name: equation, source, parameters with units and bounds, and where each law stops
// being valid; and the laws themselves, made from these names. A law registers itself at the end of its own
// header, so that factory, limits and manual page cannot drift apart; the build finds every header of this
// folder, and a new law touches no other file.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/registry.h"
#include "core/typeset.h"
#include "dem_compare/laws/normal_law.h"
#include "dem_compare/laws/rolling_law.h"
#include "dem_compare/laws/sliding_law.h"
#include "dem_compare/laws/steady_slip_law.h"
#include "dem_compare/laws/torsion_law.h"
#include "dem_compare/laws/viscous_law.h"

namespace asperity {

/// One parameter of a law, values in `unit`.
struct LawParameter {
  std::string name, unit, meaning;
  double low = 0, high = std::numeric_limits<double>::infinity();  ///< admissible values, both ends included
  double otherwise = std::numeric_limits<double>::quiet_NaN();     ///< where it is not given; NaN: it must be
  std::vector<std::string> choices{};  ///< names of the values 0, 1, ...; empty: it is a number

  bool is_needed() const { return std::isnan(otherwise); }
};
/// A parameter that is zero where it is not given.
inline LawParameter zero_otherwise(LawParameter parameter) {
  parameter.otherwise = 0;
  return parameter;
}

/// What a law says of itself.
struct LawDescription {
  std::string name;  ///< "jkr"
  std::string equation, source, validity;
  std::string mode{};  ///< "normal", "sliding", "rolling", "torsion", "viscous" or "steady slip"
  std::vector<LawParameter> parameters{};
};

/// Parameters by name [SI]; a choice by its number.
using LawValues = std::map<std::string, double>;

/// A law behind the interface of its mode.
using ReducedLaw = std::variant<NormalLaw, SlidingLaw, RollingLaw, TorsionLaw, ViscousLaw, SteadySlipLaw>;

/// A law and what makes it from values of its parameters.
struct RegisteredLaw {
  LawDescription description;
  std::function<ReducedLaw(const LawValues&)> make;
};

/// All laws, by mode and name.
std::vector<LawDescription> reduced_laws();
/// Throws InputError with the nearest name.
LawDescription reduced_law(const std::string& name);
/// Throws InputError with the nearest name.
const LawParameter& law_parameter(const LawDescription& law, const std::string& name);
/// Throws InputError for an unknown law or parameter, a value out of bounds, or a parameter that is missing.
ReducedLaw make_reduced_law(const std::string& name, const LawValues& values);
/// The same for a law of one mode; throws InputError for one of another mode.
template <class Mode>
LawOf<Mode> make_law(const std::string& name, const LawValues& values);
/// The manual page of all laws in Markdown.
std::string reduced_laws_manual(Equations equations = Equations::plain);

namespace law_registry_detail {
/// The value of a parameter of the law among those given.
/// In SI. Throws InputError where it is missing or not admissible.
double value_of(const LawParameter& parameter, const std::string& law, const LawValues& values);
/// Throws InputError: the law is none of that mode.
[[noreturn]] void refuse_mode(const std::string& law, const std::string& mode);
}  // namespace law_registry_detail

template <class Mode>
LawOf<Mode> make_law(const std::string& name, const LawValues& values) {
  if (reduced_law(name).mode != Mode::name) law_registry_detail::refuse_mode(name, Mode::name);
  return std::get<LawOf<Mode>>(make_reduced_law(name, values));
}

/// A parameter and what sets the member of the law, or of a part of it, that holds it.
template <class Law>
struct LawField {
  template <class Member>
  LawField(LawParameter described, Member Law::*member)
      : parameter(std::move(described)),
        set([member](Law& law, double value) { law.*member = static_cast<Member>(value); }) {}
  template <class Part, class Member>
  LawField(LawParameter described, Part Law::*part, Member Part::*member)
      : parameter(std::move(described)),
        set([=](Law& law, double value) { law.*part.*member = static_cast<Member>(value); }) {}

  LawParameter parameter;
  std::function<void(Law&, double)> set;
};

/// The registration of one law. `more` fields are those that it shares with other laws.
template <class Law, class Mode>
struct LawEntry {
  using Fields = std::vector<LawField<Law>>;

  LawEntry(LawDescription description, Fields fields, const Fields& more = {}) {
    fields.insert(fields.end(), more.begin(), more.end());
    description.mode = Mode::name;
    for (const auto& field : fields) description.parameters.push_back(field.parameter);
    const Registered<RegisteredLaw> add(
        {description, [description, fields](const LawValues& values) {
           Law law{};
           for (std::size_t i = 0; i < fields.size(); ++i)
             fields[i].set(
                 law, law_registry_detail::value_of(description.parameters[i], description.name, values));
           return ReducedLaw(LawOf<Mode>(law));
         }});
  }
};

}  // namespace asperity
