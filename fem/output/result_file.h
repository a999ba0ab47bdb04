// result.json of a solved case ("asperity-result/1").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "fem/case/case_setup.h"
#include "fem/output/measured_stiffness.h"
#include "half_space/case_contact.h"
#include "results/history.h"

namespace asperity::fem {

/// What the file says beside case and history.
struct ResultSummary {
  Provenance provenance;
  double wall_time = 0, peak_memory = 0;  ///< [s], [byte]
  int ranks = 1;
  unsigned threads = 1;
  long cells = 0, unknowns = 0, contact_nodes = 0;
  MeasuredStiffness stiffness;
  std::optional<half_space::CaseContact>
      half_space;  ///< the same contact by boundary elements, where they solve it
};

/// The file's text.
std::string result_json(const CaseInput& input, const CaseSetup& setup,
                        const std::vector<HistoryRow>& records, const ResultSummary& summary);

}  // namespace asperity::fem
