// result.json of a solved case ("asperity-result/1").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "fem/case_setup.h"
#include "half_space/case_contact.h"
#include "results/history.h"

namespace asperity::fem {

struct ResultSummary {
  Provenance provenance;
  double wall_time = 0, peak_memory = 0;  ///< [s], [byte]
  int ranks = 1;
  unsigned threads = 1;
  long cells = 0, unknowns = 0, contact_nodes = 0;
  double far_field = 0;          ///< compliance of the finite bodies taken out of the approach [m/N]
  double lateral_far_field = 0;  ///< the same of the shift [m/N]
  double lateral_stiffness = 0,
         torsion_stiffness = 0;  ///< without slip, half-spaces [N/m], [N m/rad]; 0 if not known
  double stiffness_at_peak = 0;  ///< elastic stiffness at the largest load, half-spaces [N/m]; 0 if not known
  std::optional<half_space::CaseContact>
      half_space;  ///< the same contact by boundary elements, where they solve it
};

std::string result_json(const CaseInput& input, const CaseSetup& setup,
                        const std::vector<HistoryRow>& records, const ResultSummary& summary);

}  // namespace asperity::fem
