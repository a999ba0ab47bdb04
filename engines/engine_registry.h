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

/// An engine that is written alone: what writes a contact, a matrix of materials, and a box beside the
/// matrix's file; null where asperity does not write that.
struct EngineWriters {
  std::string (*contact)(InputNotes&) = nullptr;
  std::string (*matrix)(const MaterialMatrix&) = nullptr;
  std::vector<std::pair<std::string, std::string>> (*box)(const MaterialMatrix&, const ParticleBox&,
                                                          const std::string& contacts) = nullptr;
  const char* elastoplastic_law = "";
  std::string (*elastoplastic)(InputNotes&) = nullptr;  ///< a contact with that law
  std::string (*elastoplastic_matrix)(const MaterialMatrix&) = nullptr;
};
std::unique_ptr<WrittenEngine> written_engine(const std::string& key, const std::string& name,
                                              const EngineWriters& writers);

/// All engines, by key.
const std::vector<std::unique_ptr<WrittenEngine>>& engine_catalogue();

/// Registers an engine from elsewhere, as a constant outside of all functions.
using RegisteredEngine = Registered<std::unique_ptr<WrittenEngine> (*)()>;

}  // namespace asperity
