#include "app/case_times.h"

#include "app/case_entry_kinds.h"

namespace asperity {

void add_times(std::vector<CaseEntry>& entries) {
  const auto add = [&](const char* name, double ExperimentInput::*member, Dimension dimension,
                       const char* none, const char* documentation) {
    CaseEntry entry = quantity(
        "Experiment", name, [=](CaseInput& input) -> double& { return input.experiment.*member; }, dimension,
        not_negative, none, "", documentation);
    entry.counts_if_given = true;
    entries.push_back(std::move(entry));
  };
  add("Speed", &ExperimentInput::speed, Dimension::speed, "0 m/s",
      "Of the motion along its path, of torsion at the rim of Hertz' contact; for laws that know time. 0: "
      "each "
      "step lasts a second.");
  add("Load time", &ExperimentInput::load_time, Dimension::time, "0 s",
      "From zero to the largest load, and from there back, each in equal times of its steps; 0: each step "
      "lasts a second.");
  add("Hold time", &ExperimentInput::hold_time, Dimension::time, "0 s",
      "Of all Hold steps together; 0: each lasts a second.");
}

}  // namespace asperity
