// Entries that results had before they listed them.
#pragma once

#include <string>
#include <vector>

#include "core/quantity.h"

namespace asperity {

/// An entry "Section/Entry", and what it measures.
struct KnownEntry {
  const char* path;
  Dimension dimension;
  const char* otherwise;  ///< where a case does not say it; empty: it must
};

/// Those that are numbers with a unit, and those that are words.
const std::vector<KnownEntry>& known_quantities();
const std::vector<KnownEntry>& known_words();

/// Whether it is one of them.
bool is_known_entry(const std::string& path);

/// Name of an entry of a law in `inputs` of result.json: "Shear strength" -> "shear_strength".
std::string result_name(std::string entry);

}  // namespace asperity
