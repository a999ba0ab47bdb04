// Finite elements, reduced law, live engine and published measurement side by side: per mode, load and
// roughness, with ratios, verdicts, and the loads on which each simplification is good enough.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/compare/comparison.h"
#include "dem_compare/compare/engine_column.h"
#include "dem_compare/compare/measured_column.h"
#include "dem_compare/compare/row.h"
#include "dem_compare/compare/verdict.h"

namespace asperity {

struct SideBySide {
  double tolerance = 0;  ///< relative
  std::string engine;    ///< "LAMMPS"; "" if none was asked for
  std::string engine_version;
  std::string engine_failure;       ///< one sentence; "" if it did not fail
  std::vector<ComparisonRow> rows;  ///< of one contact after the other
  std::vector<LawVerdict> verdicts;
  std::vector<std::string> remarks;  ///< what is missing, in words
};

/// What is set side by side.
struct SideBySideInput {
  const CaseCollection& collection;
  const Comparison& with_hertz;
  /// Numbers for an engine, of one contact each (one roughness, say); they add rolling, torsion and rails.
  std::vector<ContactParameters> parameters{};
  std::optional<ContactParameters> indenter{};  ///< contact of particle and moving plate
};

/// tolerance: relative. Engines that fail leave their reason in the row.
SideBySide compare_side_by_side(const SideBySideInput& input, const MeasuredColumn& published,
                                EngineColumn& engine, double tolerance);

}  // namespace asperity
