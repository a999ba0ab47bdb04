#include "core/experiment_declaration.h"

#include "core/error.h"
#include "core/motion.h"

namespace asperity {
namespace experiments {
std::vector<ExperimentDeclaration> make_all();  // generated from the files of experiments/
}
namespace {

std::string name_of_declared(const ExperimentDeclaration& experiment) { return experiment.name; }

/// `meant`: the experiment that the case asks for; null: none of these.
void refuse_entries_of_others(const ExperimentInput& e, const ExperimentDeclaration* meant) {
  for (const auto& entry : given_entries(parameters_of(declared_experiments()), e.parameters)) {
    if (meant && meant->takes(entry)) continue;
    std::vector<std::string> takers;
    for (const auto& other : declared_experiments())
      if (other.takes(entry)) takers.push_back(other.name);
    throw InputError("Experiment/" + entry +
                     " is given but Type is another; set Type = " + alternatives(takers) + ", or remove it");
  }
}

}  // namespace

const std::vector<ExperimentDeclaration>& declared_experiments() {
  static const auto list = [] {
    auto declared = with_registered_makers(experiments::make_all(), name_of_declared);
    for (const auto& experiment : declared)
      if (motion_named(experiment.name))
        throw std::logic_error("there are two experiments '" + experiment.name + "'");
    return declared;
  }();
  return list;
}

bool is_declared_experiment(const std::string& name) {
  const auto& all = declared_experiments();
  return std::any_of(all.begin(), all.end(), [&](const auto& known) { return known.name == name; });
}

void write_declared_program(ExperimentInput& e) {
  e.parameters = with_defaults(parameters_of(declared_experiments()), e.parameters);
  if (e.declared.empty()) return refuse_entries_of_others(e, nullptr);
  const auto& meant =
      entry_named(declared_experiments(), e.declared, name_of_declared, "there is no experiment");
  refuse_entries_of_others(e, &meant);
  if (const ParameterEntry* missing = first_missing(meant, e.parameters))
    throw InputError("Experiment/Type = " + meant.name + " needs Experiment/" + missing->entry +
                     (missing->if_missing.empty() ? "" : ": " + missing->if_missing));
  if (!e.program.empty())
    throw InputError("Experiment/Program is given but Type = " + meant.name +
                     " is a program by itself; remove Program, or set Type = program");
  e.program = meant.program(e, e.parameters);
}

}  // namespace asperity
