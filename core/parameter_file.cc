#include "core/parameter_file.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_text.h"
#include "core/nearest_name.h"
#include "core/read_limits.h"
#include "core/renamed_entries.h"
#include "core/text_file.h"
#include "core/text_pieces.h"
#include "core/utf8.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// The text of a parameter file, if it can be one.
std::string parameter_text(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (!error && size > read_limits::largest_parameter_file)
    throw InputError(file.string() + ": holds " + std::to_string(size) +
                     " bytes, more than a parameter file has; pass a case or study file");
  std::string text = plain_text(read_file(file));
  if (text.find('\0') != std::string::npos)
    throw InputError(file.string() + ": this is a binary file, not a parameter file");
  return text;
}

/// Splits off the first word.
std::string take_word(std::string& text) {
  const auto end = std::min(text.find_first_of(" \t"), text.size());
  std::string word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

/// Reads one .prm file and those it includes.
class PrmReader {
 public:
  void read(const fs::path& file) {
    if (++depth_ > deepest_include)
      throw InputError(file.string() + ": files include each other more than " +
                       std::to_string(deepest_include) + " deep; does one include itself?");
    if (++files_read_ > most_files)
      throw InputError(file.string() + ": more than " + std::to_string(most_files) +
                       " files are included; include each once");
    const std::size_t outer_sections = sections_.size();
    std::istringstream stream(parameter_text(file));
    std::map<std::string, int> set_in_line;
    std::string line;
    int number = 0;
    while (std::getline(stream, line)) {
      const int first = ++number;
      line = trimmed(without_comment(line));
      while (!line.empty() && line.back() == '\\') {
        line.pop_back();
        std::string next;
        if (!std::getline(stream, next)) break;
        ++number;
        line = trimmed(line) + " " + trimmed(without_comment(next));
        line = trimmed(line);
        if (line.size() > read_limits::longest_line) refuse_long(file, first);
      }
      if (line.size() > read_limits::longest_line) refuse_long(file, first);
      if (!line.empty()) read_line(file, first, line, outer_sections, set_in_line);
    }
    if (sections_.size() > outer_sections)
      throw InputError(file.string() + ":" + std::to_string(number) + ": the file ends inside subsection " +
                       sections_.back().name + ", opened at " + sections_.back().where + "; add 'end'");
    --depth_;
  }

  Settings settings;

 private:
  static constexpr int deepest_include = 16, most_files = 256;
  struct Section {
    std::string name, where;
  };

  [[noreturn]] static void refuse_long(const fs::path& file, int line) {
    throw InputError(file.string() + ":" + std::to_string(line) + ": this line is longer than " +
                     std::to_string(read_limits::longest_line) + " characters; shorten it");
  }

  static std::string without_comment(const std::string& line) { return line.substr(0, line.find('#')); }

  std::string section_path() const {
    std::string path;
    for (const auto& section : sections_) path += (path.empty() ? "" : "/") + section.name;
    return path;
  }

  void read_line(const fs::path& file, int number, std::string line, std::size_t outer_sections,
                 std::map<std::string, int>& set_in_line) {
    const std::string where = file.string() + ":" + std::to_string(number);
    const std::string word = take_word(line);
    if (word == "subsection") {
      if (line.empty()) throw InputError(where + ": 'subsection' lacks its name");
      if (sections_.size() >= read_limits::deepest_nesting)
        throw InputError(where + ": subsections stand in each other more than " +
                         std::to_string(read_limits::deepest_nesting) + " deep; is an 'end' missing?");
      sections_.push_back({line, where});
    } else if (word == "end") {
      if (!line.empty()) throw InputError(where + ": 'end' stands alone on its line, without '" + line + "'");
      if (sections_.size() <= outer_sections)
        throw InputError(where + ": this 'end' closes no subsection; remove it");
      sections_.pop_back();
    } else if (word == "set") {
      const auto equals = line.find('=');
      if (equals == std::string::npos)
        throw InputError(where + ": 'set " + line + "' lacks '='; write 'set Entry = value'");
      Setting setting{section_path(), trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)),
                      where};
      if (setting.entry.empty()) throw InputError(where + ": 'set' lacks the name of an entry before '='");
      const auto [earlier, is_new] = set_in_line.emplace(setting.path(), number);
      if (!is_new)
        throw InputError(where + ": " + setting.path() + " is set in line " +
                         std::to_string(earlier->second) + " already; remove one of them");
      override_setting(settings, setting);
    } else if (word == "include") {
      if (line.empty()) throw InputError(where + ": 'include' lacks the name of a file");
      const fs::path included = file.parent_path() / line;
      if (!fs::exists(included))
        throw InputError(where + ": there is no file '" + included.string() + "' to include");
      read(included);
    } else {
      const std::string meant = nearest_name(word, {"subsection", "set", "end", "include"});
      throw InputError(where + ": a line begins with subsection, set, end or include, not with '" + word +
                       "'" + (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
    }
  }

  std::vector<Section> sections_;
  int depth_ = 0, files_read_ = 0;
};

/// Line in which `key` of a JSON text first stands at or after `start`; moves `start` behind it.
int line_of_key(const std::string& text, const std::string& key, std::size_t& start) {
  const auto found = text.find(nlohmann::json(key).dump(), start);
  if (found != std::string::npos) start = found + key.size() + 2;
  return 1 + static_cast<int>(std::count(
                 text.begin(), text.begin() + static_cast<long>(std::min(start, text.size())), '\n'));
}

/// deal.II writes names into JSON with other characters than letters and digits as _XX (hexadecimal).
std::string without_mangling(const std::string& key) {
  std::string name;
  for (std::size_t i = 0; i < key.size(); ++i) {
    const bool mangled = key[i] == '_' && i + 2 < key.size() &&
                         std::isxdigit(static_cast<unsigned char>(key[i + 1])) &&
                         std::isxdigit(static_cast<unsigned char>(key[i + 2]));
    name += mangled ? static_cast<char>(std::stoi(key.substr(i + 1, 2), nullptr, 16)) : key[i];
    if (mangled) i += 2;
  }
  return as_utf8(std::move(name));
}

/// True for an entry as deal.II writes it: an object of value, default_value, documentation, pattern.
bool is_described_entry(const nlohmann::ordered_json& value) {
  return value.is_object() && value.contains("value") && value.contains("default_value");
}

void collect_json(const nlohmann::ordered_json& object, const std::string& section, const std::string& text,
                  const std::string& file, std::size_t& position, Settings& settings) {
  for (const auto& [key, item] : object.items()) {
    const std::string where = file + ":" + std::to_string(line_of_key(text, key, position));
    const std::string name = without_mangling(key);
    if (item.is_object() && !is_described_entry(item)) {
      collect_json(item, section.empty() ? name : section + "/" + name, text, file, position, settings);
      continue;
    }
    const auto& value = item.is_object() ? item.at("value") : item;
    if (value.is_array() || value.is_null())
      throw InputError(where + ": '" + name + "' holds " + value.type_name() +
                       "; write a number, true, false, or a text such as \"8.5 um\"");
    override_setting(settings, {section, name,
                                value.is_string() ? trimmed(value.get<std::string>()) : value.dump(), where});
  }
}

Settings read_json(const fs::path& file, const std::string& text) {
  Settings settings;
  const nlohmann::ordered_json object = parse_json(text, file.string());
  std::size_t position = 0;
  collect_json(object, "", text, file.string(), position, settings);
  return settings;
}

}  // namespace

Settings read_settings(const fs::path& file, const std::vector<std::string>& overrides) {
  if (!fs::exists(file)) throw InputError("there is no file '" + file.string() + "'");
  const std::string text = parameter_text(file);
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos)
    throw InputError(file.string() +
                     ": the file is empty; `asperity case-template` prints one to start from");
  Settings settings;
  if (text[first] == '{') {
    settings = read_json(file, text);
  } else {
    PrmReader reader;
    reader.read(file);
    settings = std::move(reader.settings);
  }
  use_present_names(settings);
  for (const auto& override_text : overrides) override_setting(settings, parse_override(override_text));
  return settings;
}

Setting parse_override(const std::string& text) {
  const auto equals = text.find('=');
  const std::string path = trimmed(text.substr(0, equals));
  const std::string where = "--set \"" + text + "\"";
  if (equals == std::string::npos || path.empty())
    throw InputError(
        where + ": write --set \"Section/Entry=value\", for example --set \"Experiment/Normal load=1 mN\"");
  const auto slash = path.rfind('/');
  Setting setting{"", path, trimmed(text.substr(equals + 1)), where};
  if (slash != std::string::npos)
    setting.section = trimmed(path.substr(0, slash)), setting.entry = trimmed(path.substr(slash + 1));
  use_present_name(setting);
  return setting;
}

void override_setting(Settings& settings, const Setting& setting) {
  for (auto& existing : settings)
    if (existing.section == setting.section && existing.entry == setting.entry) {
      existing = setting;
      return;
    }
  settings.push_back(setting);
}

std::string format_settings(const Settings& settings) {
  std::vector<std::string> sections;
  for (const auto& setting : settings)
    if (std::find(sections.begin(), sections.end(), setting.section) == sections.end())
      sections.push_back(setting.section);
  std::stable_partition(sections.begin(), sections.end(), [](const auto& name) { return name.empty(); });
  std::string text;
  for (const auto& section : sections) {
    std::vector<std::string> names;
    std::istringstream parts(section);
    for (std::string name; std::getline(parts, name, '/');) names.push_back(name);
    for (std::size_t i = 0; i < names.size(); ++i)
      text += std::string(2 * i, ' ') + "subsection " + names[i] + "\n";
    const std::string indent(2 * names.size(), ' ');
    for (const auto& setting : settings)
      if (setting.section == section) text += indent + "set " + setting.entry + " = " + setting.value + "\n";
    for (std::size_t i = names.size(); i-- > 0;) text += std::string(2 * i, ' ') + "end\n";
  }
  return text;
}

}  // namespace asperity
