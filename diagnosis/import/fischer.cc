// Fischerscope: after a header, blocks "Block : 1  Value : 2", each with a table F [mN], h [um], t [s],
// decimal commas. Each value is a run; loading cycles are found from the force.
#include "core/error.h"
#include "diagnosis/import/segments.h"
#include "diagnosis/import/text_formats.h"

namespace asperity {
namespace {

constexpr const char* fischer_header = "F\th\tt";

}  // namespace

bool is_fischer(const InstrumentText& text) {
  return text.line_with(fischer_header).has_value() && text.line_with("Block").has_value();
}

Recording read_fischer(const InstrumentText& text, const ImportOptions&) {
  if (!text.line_with(fischer_header))
    throw InputError(text.file +
                     ": has no table under F, h, t as Fischer's has; leave --format out, or pass csv");
  RecordingTable table;
  table.file = "loading.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  int run = 0;
  for (auto header = text.line_with(fischer_header); header;
       header = text.line_with(fischer_header, *header + 1)) {
    const InstrumentTable block = table_under(text, *header);
    ++run;
    add_channel(table, "normal_force", block.column("F", text.file), "mN");
    add_channel(table, "normal_displacement", block.column("h", text.file), "um");
    add_channel(table, "time", block.column("t", text.file), "s");
    const FoundSegments found = find_segments(block.column("F", text.file));
    table.segment.insert(table.segment.end(), found.segment.begin(), found.segment.end());
    table.columns["cycle"].insert(table.columns["cycle"].end(), found.cycle.begin(), found.cycle.end());
    table.columns["run"].insert(table.columns["run"].end(), block.rows(), run);
  }
  Recording recording;
  recording.title = "Fischerscope, " + text.lines.front().substr(0, text.lines.front().find('\t'));
  recording.tables = {table};
  return recording;
}

}  // namespace asperity
