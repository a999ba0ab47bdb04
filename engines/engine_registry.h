// The engines that asperity knows. Each is a file KEY.cc of kinds/, with the engine's key as its name, that
// defines
//   namespace asperity::engines { std::unique_ptr<WrittenEngine> make_KEY(); }
// The build finds the files; nothing else names them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/registry.h"
#include "engines/engine_input.h"

namespace asperity {

/// An engine that is written alone, from a function that writes it.
std::unique_ptr<WrittenEngine> written_engine(const std::string& key, const std::string& name,
                                              std::string (*contact_input)(InputNotes&));

/// All engines, by key.
const std::vector<std::unique_ptr<WrittenEngine>>& engine_catalogue();

/// Registers an engine from elsewhere, as a constant outside of all functions.
using RegisteredEngine = Registered<std::unique_ptr<WrittenEngine> (*)()>;

}  // namespace asperity
