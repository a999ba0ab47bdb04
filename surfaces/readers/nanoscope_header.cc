#include "surfaces/readers/nanoscope_header.h"

#include "core/error.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

/// Exports write each line in quotes, and "?" for the first backslash.
std::string unquoted(std::string line) {
  if (line.size() > 1 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
  if (line.rfind("?*", 0) == 0) line[0] = '\\';
  return line;
}

/// "1 1 ~m" or "1000 nm".
void read_scan_size(const NanoscopeSection& section, StoredMap& map) {
  const auto found = section.find("scan size");
  if (found == section.end()) return;
  const auto first = number_with_unit(found->second);
  if (!first) return;
  const auto second = number_with_unit(first->unit);
  const auto factor = length_unit_factor(second ? second->unit : first->unit);
  if (!factor || !(first->number > 0)) return;
  map.lx = first->number * *factor;
  map.ly = (second ? second->number : first->number) * *factor;
}

}  // namespace

NanoscopeHeader nanoscope_header(const SourceFile& file) {
  NanoscopeHeader header;
  NanoscopeSection* section = &header.instrument;
  for (std::size_t begin = 0; begin < file.bytes.size();) {
    const std::size_t end = file.bytes.find('\n', begin);
    const std::string line =
        unquoted(trimmed_text(file.bytes.substr(begin, end == std::string::npos ? end : end - begin)));
    const std::string lower = lower_case(line);
    if (lower == "\\*file list end") return header;
    if (lower.rfind("\\*", 0) == 0) {
      if (lower == "\\*file list") {
        section = &header.file_list;
      } else if (lower.find("image list") != std::string::npos) {
        header.images.emplace_back();
        section = &header.images.back();
      } else {
        section = &header.instrument;
      }
    } else if (line.rfind('\\', 0) == 0) {
      const auto colon = line.find(": ");
      const std::string key = colon == std::string::npos ? line.substr(1) : line.substr(1, colon - 1);
      (*section)[lower_case(key)] = colon == std::string::npos ? "" : trimmed_text(line.substr(colon + 2));
    }
    if (end == std::string::npos) break;
    begin = end + 1;
  }
  throw InputError(file.name() + " ends inside its NanoScope header: it is cut off; copy or export it again");
}

std::string nanoscope_image_name(const NanoscopeSection& section) {
  for (const char* key : {"@2:image data", "@3:image data", "@4:image data", "image data"}) {
    const auto found = section.find(key);
    if (found == section.end()) continue;
    const auto open = found->second.find('"'), close = found->second.rfind('"');
    return close == open ? found->second : found->second.substr(open + 1, close - open - 1);
  }
  return "unnamed";
}

void read_nanoscope_size(const NanoscopeHeader& header, const NanoscopeSection& image, StoredMap& map) {
  read_scan_size(image, map);
  if (!map.lx) read_scan_size(header.instrument, map);
}

std::vector<NanoscopeExport> nanoscope_exports(const SourceFile& file) {
  const std::string mark = "\\Exported image units:";
  std::vector<NanoscopeExport> exports;
  for (auto at = file.bytes.find(mark); at != std::string::npos; at = file.bytes.find(mark, at + 1)) {
    const auto line_end = std::min(file.bytes.find('\n', at), file.bytes.size());
    std::string unit = trimmed_text(file.bytes.substr(at + mark.size(), line_end - at - mark.size()));
    if (!unit.empty() && unit.back() == '"') unit = trimmed_text(unit.substr(0, unit.size() - 1));
    if (!exports.empty()) exports.back().end = file.bytes.rfind('\n', at) + 1;
    exports.push_back({unit, std::min(line_end + 1, file.bytes.size()), file.bytes.size()});
  }
  return exports;
}

}  // namespace asperity
