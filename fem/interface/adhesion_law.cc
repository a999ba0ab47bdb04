#include "fem/interface/adhesion_law.h"

#include "adhesion_files.h"  // all of adhesion/; what they declare is linked for being included here
#include "core/error.h"

namespace asperity::fem {

const std::vector<AdhesionLawDeclaration>& adhesion_laws() { return declared_laws<AdhesionLawDeclaration>(); }

ParameterEntry adhesion_range(const std::string& symbol) {
  ParameterEntry range{
      "Adhesion range", {symbol}, Dimension::length, "The length {symbols} of the law of adhesion.", "0 m"};
  range.if_missing = "give the length over which attraction falls, e.g. Adhesion range = 0.5 nm";
  return range;
}

namespace {

/// Throws InputError where there is none of that name, or where it lacks an entry.
const AdhesionLawDeclaration& declared(const std::string& name, const LawValues& values) {
  std::string names;
  for (const auto& law : adhesion_laws()) {
    names += (names.empty() ? "" : ", ") + law.name;
    if (law.name != name) continue;
    if (const ParameterEntry* missing = first_missing(law, values))
      throw InputError("Interface/" + missing->entry + " is 0: " + missing->if_missing);
    return law;
  }
  throw InputError("'" + name + "' is no law of adhesion; use one of " + names);
}

/// Throws InputError where an entry is given that the law has no use for.
void require_own_entries(const AdhesionLawDeclaration& law, const LawValues& values) {
  const auto parameters = parameters_of(adhesion_laws());
  for (const auto& entry : given_entries(parameters, with_defaults(parameters, values)))
    if (!law.takes(entry))
      throw InputError("Interface/" + entry + " is given, and Adhesion law = " + law.name +
                       " does not take it; leave it out, or name the law that does");
}

}  // namespace

std::unique_ptr<AdhesionLaw> make_adhesion_law(const std::string& name, double work,
                                               const LawValues& values) {
  const AdhesionLawDeclaration& law = declared(name, values);
  return law.make(work, with_defaults(law.parameters, values));
}

AdhesionWork work_of_adhesion(const InterfaceInput& input) {
  for (const auto& law : adhesion_laws()) {
    if (law.name != input.adhesion_law || !law.own_work) continue;
    if (input.work_of_adhesion > 0 || input.work_of_separation > 0)
      throw InputError("Interface/Adhesion law = " + law.name +
                       " has a work of adhesion that follows from its own entries; leave out Work of "
                       "adhesion and Work of adhesion on separation");
    return declared(law.name, input.parameters).own_work(with_defaults(law.parameters, input.parameters));
  }
  return {input.work_of_adhesion,
          input.work_of_separation == 0 ? input.work_of_adhesion : input.work_of_separation};
}

std::map<std::string, std::string> work_entries_of_law(const InterfaceInput& input) {
  AdhesionWork work;
  try {
    work = work_of_adhesion(input);
  } catch (const InputError&) {
    return {};
  }
  constexpr int digits = 9;
  std::map<std::string, std::string> entries;
  const auto say = [&](const char* entry, double value) {
    entries[entry] = format_quantity(value, Dimension::surface_energy, digits);
  };
  if (work.closing != input.work_of_adhesion) say("Interface/Work of adhesion", work.closing);
  if (work.opening != work.closing && work.opening != input.work_of_separation)
    say("Interface/Work of adhesion on separation", work.opening);
  return entries;
}

AdhesionLaws make_adhesion_laws(const InterfaceInput& input) {
  AdhesionLaws laws;
  for (const auto& law : adhesion_laws())
    if (law.name == input.adhesion_law) require_own_entries(law, input.parameters);
  const AdhesionWork work = work_of_adhesion(input);
  if (work.opening == 0) return laws;
  laws.closing = make_adhesion_law(input.adhesion_law, work.closing, input.parameters);
  laws.opening = work.opening == work.closing
                     ? laws.closing
                     : make_adhesion_law(input.adhesion_law, work.opening, input.parameters);
  return laws;
}

}  // namespace asperity::fem
