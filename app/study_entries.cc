#include "app/study_entries.h"

#include "app/case_file.h"
#include "core/error.h"
#include "core/renamed_entries.h"
#include "core/text_pieces.h"
#include "core/topography_spec.h"

namespace asperity {

namespace fs = std::filesystem;

void make_topography_absolute(Setting& setting, const fs::path& file) {
  if (setting.entry != "Topography") return;
  try {
    const TopographySpec topography(setting.value);
    if (topography.scan() && fs::exists(file.parent_path() / topography.scan()->file))
      setting.value = with_absolute_file(*topography.scan(), file.parent_path()).text();
  } catch (const InputError& error) {
    throw InputError(setting.where + ": " + setting.path() + ": " + error.what());
  }
}

namespace {

/// Parts between separators that stand outside of parentheses.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == separator && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (auto& part : parts) part = trimmed(part);
  return parts;
}

/// "Section/Entry" of a case file.
Setting case_setting(const std::string& path, const std::string& value, const std::string& where,
                     const fs::path& file) {
  const auto slash = path.rfind('/');
  Setting setting{slash == std::string::npos ? "" : trimmed(path.substr(0, slash)),
                  slash == std::string::npos ? path : trimmed(path.substr(slash + 1)), value, where};
  use_present_name(setting);
  check_entry_exists(setting);
  make_topography_absolute(setting, file);
  return setting;
}

/// "Section/Entry=value".
Setting read_assignment(const std::string& text, const std::string& where, const fs::path& file) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError(where + ": '" + text +
                     "' lacks '='; write Section/Entry=value, several separated by ';'");
  return case_setting(trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)), where, file);
}

/// "label: value; Section/Entry=value; ...": label and further entries may be missing.
StudyChoice read_value(const Setting& written, const std::string& text, const fs::path& file) {
  auto parts = split(text, ';');
  const std::string& first = parts.front();
  if (first.empty())
    throw InputError(written.where + ": the values of " + written.entry +
                     " have an empty one; remove the comma");
  const auto colon = first.find(": ");
  const std::string value = colon == std::string::npos ? first : trimmed(first.substr(colon + 1));
  StudyChoice choice{colon == std::string::npos ? first : trimmed(first.substr(0, colon)),
                     {case_setting(written.entry, value, written.where, file)}};
  choice.settings.front().former = written.former;
  for (auto part = parts.begin() + 1; part != parts.end(); ++part)
    choice.settings.push_back(read_assignment(*part, written.where, file));
  return choice;
}

}  // namespace

WrittenAxis read_vary(const Setting& written, const fs::path& file) {
  WrittenAxis axis{written.entry, written.where, {}};
  for (const auto& part : split(written.value, ',')) axis.choices.push_back(read_value(written, part, file));
  return axis;
}

StudyChoice read_variant(const Setting& written, const fs::path& file) {
  StudyChoice variant{written.entry, {}};
  if (written.value.empty()) return variant;
  for (const auto& part : split(written.value, ';'))
    variant.settings.push_back(read_assignment(part, written.where, file));
  return variant;
}

}  // namespace asperity
