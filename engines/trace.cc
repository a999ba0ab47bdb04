#include "engines/trace.h"

#include <cmath>

#include "core/csv.h"
#include "core/error.h"

namespace asperity {
namespace {

struct TraceColumn {
  const char* name;
  std::vector<double> EngineTrace::*values;
};

const std::vector<TraceColumn>& columns() {
  static const std::vector<TraceColumn> all{{"leg", &EngineTrace::leg},
                                            {"time", &EngineTrace::time},
                                            {"drive", &EngineTrace::drive},
                                            {"response", &EngineTrace::response},
                                            {"particle", &EngineTrace::particle},
                                            {"rotation_rate", &EngineTrace::rotation_rate},
                                            {"normal_force", &EngineTrace::normal_force},
                                            {"approach", &EngineTrace::approach}};
  return all;
}

}  // namespace

const std::string& trace_header() {
  static const std::string header = [] {
    std::string text;
    for (const auto& column : columns()) text += (text.empty() ? "" : ",") + std::string(column.name);
    return text;
  }();
  return header;
}

EngineTrace read_trace(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  EngineTrace trace;
  for (const auto& column : columns()) {
    trace.*column.values = table.numbers(column.name);
    for (std::size_t row = 0; row < trace.size(); ++row)
      if (!std::isfinite((trace.*column.values)[row]))
        throw InputError(file.string() + ": row " + std::to_string(row + 1) + " of '" + column.name +
                         "' is not a finite number");
  }
  return trace;
}

}  // namespace asperity
