// Columns of the history that a file of its own adds: a file NAME.cc of columns/ that defines
//   namespace asperity::columns { fem::AddedColumn make_NAME(); }
// and that nothing else names, or from elsewhere a RegisteredColumn. They stand behind those of
// results/history.h, and result.json says what they are.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/registry.h"
#include "fem/contact/contact_solver.h"
#include "results/history.h"

namespace asperity::fem {

/// A step that was accepted, with its row of the history.
struct AcceptedStep {
  const ContactSystem& system;
  const ContactSolver& solver;
  const ContactState& state;
  const HistoryRow& row;
  const HistoryRow* before;  ///< row of the step before; null for the first
};

struct AddedColumn {
  std::string name;     ///< with its unit, "slip_range [m]"
  std::string meaning;  ///< for result.json and the report
  /// Of the step, in the column's unit; `before`: the same of the step before, 0 for the first. Called on
  /// every rank.
  std::function<double(const AcceptedStep&, double before)> value;
};

/// All of them, by name. Throws std::logic_error if a name is none for a table, or is taken.
const std::vector<AddedColumn>& added_columns();
std::vector<std::string> added_column_names();

/// Their values at a step.
std::vector<double> added_values(const AcceptedStep& step);

/// Registers a column from elsewhere, as a constant outside of all functions.
using RegisteredColumn = Registered<AddedColumn (*)()>;

}  // namespace asperity::fem
