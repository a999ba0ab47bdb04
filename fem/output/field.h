// Fields for ParaView and the report: what asperity writes (fields.cc), and what files of their own add: a
// file NAME.cc of fields/ that defines
//   namespace asperity::fields { fem::Field make_NAME(); }
// and that nothing else names, or from elsewhere a RegisteredField. result.json says what those are.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/registry.h"
#include "fem/contact/contact_solver.h"

namespace asperity::fem {

/// What is written, with what several fields show of it.
struct ShownState {
  const ContactSystem& system;
  const ContactSolver& solver;
  const ContactState& state;
  std::vector<double> gaps;      ///< of each row of the contact [m]
  std::vector<CellState> cells;  ///< of this rank

  bool is_closed(std::size_t row) const { return state.multiplier[row] > 0; }
};

enum class FieldPlace {
  contact,  ///< rows of the contact (interface/), on every rank all of them
  bodies    ///< cells of this rank (fields/), in the order of the batches of the finest level
};

struct Field {
  std::string name;
  std::string unit;     ///< "Pa"; empty: a number
  std::string meaning;  ///< for result.json and the report
  FieldPlace place;
  int components;  ///< 1, 3, or 6 (xx yy zz xy yz xz)
  /// All components of the first point, then those of the next, in the field's unit. Called on every rank.
  std::function<std::vector<double>(const ShownState&)> values;
};

/// Those that asperity writes, in the order of the files.
const std::vector<Field>& shipped_fields();
/// Those that files of their own add, by name. Throws std::logic_error if a name is taken.
const std::vector<Field>& added_fields();

/// Registers a field from elsewhere, as a constant outside of all functions.
using RegisteredField = Registered<Field (*)()>;

}  // namespace asperity::fem
