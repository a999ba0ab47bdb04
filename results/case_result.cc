#include "results/case_result.h"

#include <algorithm>
#include <initializer_list>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_text.h"
#include "core/renamed_entries.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// The value under the names, one within the other; null where one of them is missing.
const Json& part_of(const Json& whole, std::initializer_list<const char*> names) {
  static const Json none;
  const Json* part = &whole;
  for (const char* name : names) {
    if (!part->is_object()) return none;
    const auto found = part->find(name);
    if (found == part->end()) return none;
    part = &*found;
  }
  return *part;
}

/// The members of an object under the names; none where it is of another kind.
const Json& object_in(const Json& whole, std::initializer_list<const char*> names) {
  static const Json none = Json::object();
  const Json& part = part_of(whole, names);
  return part.is_object() ? part : none;
}

double number_in(const Json& whole, std::initializer_list<const char*> names) {
  return number_of(part_of(whole, names));
}

std::string text_in(const Json& whole, std::initializer_list<const char*> names) {
  const Json& part = part_of(whole, names);
  return part.is_string() ? part.get<std::string>() : "";
}

/// Parts of a result that are of one kind or missing.
void check_kinds(const Json& result, const std::string& file) {
  const auto check = [&](std::initializer_list<const char*> names, bool (Json::*is_kind)() const noexcept,
                         const char* kind) {
    for (const char* name : names)
      if (result.contains(name) && !(result[name].*is_kind)())
        throw InputError(file + ": '" + name + "' is no " + kind +
                         "; solve the case again, or remove the file");
  };
  check({"format", "title", "experiment", "commit", "inputs_sha256"}, &Json::is_string, "text");
  check({"inputs", "hertz", "mesh", "effective", "balance", "cost", "versions", "added"}, &Json::is_object,
        "object");
  check({"complete"}, &Json::is_boolean, "true or false");
}

/// What files of their own have added of a kind; an entry without a name is passed over.
std::vector<Addition> additions_in(const Json& document, const char* kind) {
  std::vector<Addition> additions;
  for (const Json& said : part_of(document, {"added", kind}))
    if (!text_in(said, {"name"}).empty())
      additions.push_back({text_in(said, {"name"}), text_in(said, {"meaning"}), text_in(said, {"unit"}),
                           text_in(said, {"place"}), number_in(said, {"components"})});
  return additions;
}

std::optional<ResolvedRoughness> roughness_in(const Json& document, const char* body) {
  const Json& said = part_of(document, {"mesh", "roughness", body});
  if (!said.is_object()) return std::nullopt;
  return ResolvedRoughness{number_in(said, {"shortest_wave"}), number_in(said, {"cells_over_shortest_wave"}),
                           number_in(said, {"slope_variance_in_shorter_waves"}),
                           number_in(said, {"missed_by_facets", "slope_variance"}),
                           number_in(said, {"repeats_every"})};
}

}  // namespace

CaseResult case_result_of(const Json& document, const std::string& file) {
  if (!document.is_object())
    throw InputError(file + ": is not valid JSON; solve the case again, or remove the file");
  check_kinds(document, file);
  const std::string format = text_in(document, {"format"});
  if (format != CaseResult::format)
    throw InputError(file + ": has the format '" + format + "' where this program reads '" +
                     CaseResult::format + "'");
  CaseResult result;
  result.title = text_in(document, {"title"});
  result.experiment = text_in(document, {"experiment"});
  result.version = text_in(document, {"versions", "asperity"});
  result.commit = text_in(document, {"commit"});
  const Json &complete = part_of(document, {"complete"}),
             &rim = part_of(document, {"mesh", "contact_reaches_rim"});
  result.complete = !complete.is_boolean() || complete.get<bool>();
  result.reaches_rim = rim.is_boolean() && rim.get<bool>();
  for (const auto& [name, said] : object_in(document, {"effective"}).items())
    result.effective.push_back({name, {number_of(said), number_in(said, {"sd"}), text_in(said, {"unit"})}});
  for (const auto& [name, said] : object_in(document, {"balance"}).items())
    result.balance.push_back({name, number_of(said)});
  for (const auto& [path, said] : object_in(document, {"inputs", "entries"}).items())
    result.physical_entries[present_path(path)] = said.is_string() ? said.get<std::string>() : said.dump();
  result.added_columns = additions_in(document, "columns");
  result.added_fields = additions_in(document, "fields");
  result.rms_in_region = {number_in(document, {"inputs", "rms_in_region", "particle"}),
                          number_in(document, {"inputs", "rms_in_region", "substrate"})};
  result.roughness = {roughness_in(document, "particle"), roughness_in(document, "substrate")};
  result.cells = number_in(document, {"mesh", "cells"}),
  result.unknowns = number_in(document, {"mesh", "dofs"});
  result.interface_spacing = number_in(document, {"mesh", "interface_spacing"});
  result.wall_time = number_in(document, {"cost", "wall_time"}),
  result.peak_memory = number_in(document, {"cost", "peak_memory"});
  result.document = document;
  return result;
}

double number_of(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (value.is_object() && value.contains("value") && value["value"].is_number())
    return value["value"].get<double>();
  return std::numeric_limits<double>::quiet_NaN();
}

bool CaseResult::has(const std::string& name) const {
  return std::any_of(effective.begin(), effective.end(),
                     [&](const auto& entry) { return entry.first == name; });
}

EffectiveNumber CaseResult::effective_number(const std::string& name) const {
  for (const auto& [own, number] : effective)
    if (own == name) return number;
  return {};
}

double CaseResult::balance_of(const std::string& name) const {
  for (const auto& [own, error] : balance)
    if (own == name) return error;
  return std::numeric_limits<double>::quiet_NaN();
}

std::optional<CaseResult> read_case_result(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  CaseResult result = case_result_of(json_if_valid(read_file(file)), file.string());
  return result.complete ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace asperity
