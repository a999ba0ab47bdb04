// Entries of JSON files that people write: texts, numbers and quantities, with refusals that name file and
// entry.
#pragma once

#include <string>
#include <vector>

#include "core/json_text.h"
#include "core/quantity.h"

namespace asperity {

using Json = nlohmann::ordered_json;

/// Throws InputError "file: what".
[[noreturn]] void refuse(const std::string& file, const std::string& what);
/// Throws InputError for an entry that is not known, naming the nearest, and for what is no object. where:
/// what the object is called.
void check_keys(const Json& object, const std::vector<std::string>& known, const std::string& where,
                const std::string& file);
/// Throws InputError where the entry is no text; `otherwise` where it is absent. path: of the object, as
/// "particle/", empty at the top.
std::string text_of(const Json& object, const char* key, const std::string& otherwise,
                    const std::string& file, const std::string& path = "");
/// In the file's unit. Throws InputError for what is no finite number. name: of the entry, as
/// "quantities/mu/value".
double finite_number(const Json& value, const std::string& name, const std::string& file);
/// A plain SI number or a text with its unit ("8.5 um"), in SI. Throws InputError as finite_number() does.
double quantity_of(const Json& value, Dimension dimension, const std::string& name, const std::string& file);

}  // namespace asperity
