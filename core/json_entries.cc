#include "core/json_entries.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/joined.h"
#include "core/nearest_name.h"
#include "core/printable.h"

namespace asperity {

void refuse(const std::string& file, const std::string& what) { throw InputError(file + ": " + what); }

void check_keys(const Json& object, const std::vector<std::string>& known, const std::string& where,
                const std::string& file) {
  if (!object.is_object()) refuse(file, "'" + printable(where) + "' is not an object { }");
  for (const auto& item : object.items())
    if (std::find(known.begin(), known.end(), item.key()) == known.end())
      refuse(file, "there is no '" + printable(item.key()) + "' in '" + printable(where) + "'; " +
                       did_you_mean(item.key(), known, "it may hold " + joined(known, ", ")));
}

std::string text_of(const Json& object, const char* key, const std::string& otherwise,
                    const std::string& file, const std::string& path) {
  if (!object.contains(key)) return otherwise;
  if (!object[key].is_string()) refuse(file, "'" + path + key + "' is not a text in quotation marks");
  return object[key].get<std::string>();
}

double finite_number(const Json& value, const std::string& name, const std::string& file) {
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    refuse(file, "'" + name + "' is not a number");
  return value.get<double>();
}

double quantity_of(const Json& value, Dimension dimension, const std::string& name, const std::string& file) {
  if (value.is_number()) return finite_number(value, name, file);
  if (!value.is_string()) refuse(file, "'" + name + "' is not a number or a text with a unit");
  double number = 0;
  try {
    number = parse_quantity(value.get<std::string>(), dimension);
  } catch (const InputError& error) {
    refuse(file, "'" + name + "': " + error.what());
  }
  if (!std::isfinite(number)) refuse(file, "'" + name + "' is not finite");
  return number;
}

}  // namespace asperity
