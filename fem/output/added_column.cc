#include "fem/output/added_column.h"

#include <stdexcept>

namespace asperity::columns {
std::vector<fem::AddedColumn> make_all();  // generated from the files of columns/
}

namespace asperity::fem {
namespace {

std::vector<AddedColumn> checked(std::vector<AddedColumn> columns) {
  for (const auto& added : columns) {
    if (added.name.empty() || added.name.find_first_of(",\"#\n") != std::string::npos)
      throw std::logic_error("'" + added.name + "' cannot be the name of a column of history.csv");
    for (const auto& known : history_columns())
      if (added.name == known.name) throw std::logic_error("there are two columns '" + added.name + "'");
  }
  return columns;
}

}  // namespace

const std::vector<AddedColumn>& added_columns() {
  static const auto list = checked(
      with_registered_makers(columns::make_all(), [](const AddedColumn& column) { return column.name; }));
  return list;
}

std::vector<std::string> added_column_names() {
  std::vector<std::string> names;
  for (const auto& column : added_columns()) names.push_back(column.name);
  return names;
}

std::vector<double> added_values(const AcceptedStep& step) {
  std::vector<double> values;
  for (std::size_t k = 0; k < added_columns().size(); ++k)
    values.push_back(added_columns()[k].value(step, step.before ? step.before->added[k] : 0));
  return values;
}

}  // namespace asperity::fem
