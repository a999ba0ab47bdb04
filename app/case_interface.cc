#include "app/case_interface.h"

#include "app/case_entry_kinds.h"
#include "fem/interface/adhesion_law.h"
#include "fem/interface/friction_law.h"

namespace asperity {

void add_interface(std::vector<CaseEntry>& entries) {
  const Member<LawValues> values = [](CaseInput& input) -> LawValues& { return input.interface.parameters; };
  for (const auto& parameter : parameters_of(fem::friction_laws()))
    entries.push_back(law_entry("Interface", parameter, values));
  entries.push_back(quantity(
      "Interface", "Work of adhesion", [](CaseInput& c) -> double& { return c.interface.work_of_adhesion; },
      Dimension::surface_energy, not_negative, "0 J/m^2", "",
      "Work of adhesion on approach: work per area of attraction as the surfaces close; 0: they do not "
      "attract before they touch."));
  entries.push_back(quantity(
      "Interface", "Work of adhesion on separation",
      [](CaseInput& c) -> double& { return c.interface.work_of_separation; }, Dimension::surface_energy,
      not_negative, "0 J/m^2", "",
      "Work per area to separate surfaces that were in contact (adhesion hysteresis), not below Work of "
      "adhesion; 0: the same as on approach."));
  std::vector<std::pair<std::string, std::string>> names;
  std::vector<std::string> falls;
  for (const auto& law : fem::adhesion_laws()) {
    names.emplace_back(law.name, law.name);
    falls.push_back(law.fall);
  }
  entries.push_back(choice<std::string>(
      "Interface", "Adhesion law", [](CaseInput& c) -> std::string& { return c.interface.adhesion_law; },
      names, InterfaceInput().adhesion_law,
      "How attraction falls with the gap: " + alternatives(falls, ", or ") + "."));
  for (const auto& parameter : parameters_of(fem::adhesion_laws()))
    entries.push_back(law_entry("Interface", parameter, values));
  CaseEntry attraction = quantity(
      "Interface", "Attraction force", [](CaseInput& c) -> double& { return c.interface.attraction_force; },
      Dimension::force, not_negative, "0 N", "",
      "Attraction of the surfaces beyond their contact, as one force whatever the gap, which acts like more "
      "load: 2 pi w R of smooth spheres in the limit of Derjaguin, Muller & Toporov (1975), or what a "
      "measurement says. Under control by force; beside it a law of adhesion can act at each point.");
  attraction.counts_if_given = true;
  entries.push_back(std::move(attraction));
}

}  // namespace asperity
