#include "diagnosis/recording/recording_json.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/nearest_name.h"

namespace asperity {

void refuse(const std::string& file, const std::string& what) { throw InputError(file + ": " + what); }

void check_keys(const Json& object, const std::vector<std::string>& known, const std::string& where,
                const std::string& file) {
  if (!object.is_object()) refuse(file, "'" + where + "' is not an object { }");
  for (const auto& item : object.items()) {
    if (std::find(known.begin(), known.end(), item.key()) != known.end()) continue;
    const std::string meant = nearest_name(item.key(), known);
    refuse(file, "there is no entry '" + item.key() + "' in " + where +
                     (meant.empty() ? "; remove it" : "; did you mean '" + meant + "'?"));
  }
}

std::string text_of(const Json& object, const char* key, const std::string& otherwise,
                    const std::string& file) {
  if (!object.contains(key)) return otherwise;
  if (!object[key].is_string()) refuse(file, "'" + std::string(key) + "' is not a text in quotation marks");
  return object[key].get<std::string>();
}

double quantity_of(const Json& value, Dimension dimension, const std::string& name, const std::string& file) {
  double number = 0;
  if (value.is_string()) {
    try {
      number = parse_quantity(value.get<std::string>(), dimension);
    } catch (const InputError& error) {
      refuse(file, "'" + name + "': " + error.what());
    }
  } else if (value.is_number()) {
    number = value.get<double>();
  } else {
    refuse(file, "'" + name + "' is not a number or a text with a unit");
  }
  if (!std::isfinite(number)) refuse(file, "'" + name + "' is not finite");
  return number;
}

}  // namespace asperity
