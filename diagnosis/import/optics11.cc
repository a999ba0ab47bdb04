// Optics11: header "k (N/m)", "Tip radius (um)", "E[v=0.50] (Pa)"; table of time, load, indentation,
// cantilever and piezo. Displacement: piezo less cantilever, from where the file's own indentation begins, so
// that the approach before contact is kept too.
#include <algorithm>

#include "core/error.h"
#include "diagnosis/import/segments.h"
#include "diagnosis/import/text_formats.h"

namespace asperity {
namespace {

constexpr const char* optics11_header = "Time (s)\tLoad (uN)";

}  // namespace

bool is_optics11(const InstrumentText& text) {
  return text.line_with(optics11_header).has_value() && text.line_with("Tip radius").has_value();
}

Recording read_optics11(const InstrumentText& text, const ImportOptions& options) {
  const auto header = text.line_with(optics11_header);
  if (!header)
    throw InputError(
        text.file +
        ": has no table under 'Time (s)' and 'Load (uN)' as Optics11's has; leave --format out, or pass csv");
  const InstrumentTable source = table_under(text, *header);
  const auto &time = source.column("Time (s)", text.file), &load = source.column("Load (uN)", text.file),
             &indentation = source.column("Indentation (nm)", text.file),
             &cantilever = source.column("Cantilever (nm)", text.file),
             &piezo = source.column("Piezo (nm)", text.file);
  std::vector<double> displacement, offsets;
  for (std::size_t i = 0; i < source.rows(); ++i) {
    displacement.push_back(piezo[i] - cantilever[i]);
    if (indentation[i] > 0) offsets.push_back(displacement.back() - indentation[i]);
  }
  if (!offsets.empty()) {
    std::nth_element(offsets.begin(), offsets.begin() + static_cast<long>(offsets.size() / 2), offsets.end());
    for (double& d : displacement) d -= offsets[offsets.size() / 2];
  }
  const auto k = text.number_behind("k (N/m)");
  std::vector<double> force = load;
  if (options.spring_constant) {
    if (!k || !(*k > 0))
      throw InputError(text.file + ": has no 'k (N/m)' that --spring-constant could replace");
    for (double& f : force) f *= *options.spring_constant / *k;
  }
  RecordingTable table;
  table.file = "loading.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  add_channel(table, "time", time, "s");
  add_channel(table, "normal_displacement", displacement, "nm");
  add_channel(table, "normal_force", force, "uN");
  table.columns["run"].assign(source.rows(), 1);
  table.segment = find_segments(piezo).segment;  // what the instrument drives
  Recording recording;
  recording.title = "Optics11, " + (text.lines.size() > 1 ? text.lines[1] : std::string());
  recording.tables = {table};
  if (const auto radius = text.number_behind("Tip radius (um)")) recording.particle.radius = *radius * 1e-6;
  recording.particle.material = "glass";
  recording.particle.youngs_modulus = 70e9;
  recording.particle.poissons_ratio = 0.2;
  if (const auto modulus = text.number_behind("E[v=0.50] (Pa)")) {
    recording.substrate.youngs_modulus = *modulus;
    recording.substrate.poissons_ratio = 0.5;
  }
  return recording;
}

}  // namespace asperity
