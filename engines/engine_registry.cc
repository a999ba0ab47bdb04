#include "engines/engine_registry.h"

#include <algorithm>

#include "core/error.h"
#include "core/joined.h"
#include "core/nearest_name.h"
#include "engines/engine.h"
#include "engines/input_notes.h"

namespace asperity {
namespace engines {
std::vector<std::unique_ptr<WrittenEngine>> make_all();  // generated from the files of kinds/
}
namespace {

using Maker = std::unique_ptr<WrittenEngine> (*)();

std::vector<Maker>& makers_from_elsewhere() {
  static std::vector<Maker>
      makers;  // in a function: filled while other files' constants are still being set up
  return makers;
}

class FunctionEngine : public WrittenEngine {
 public:
  FunctionEngine(std::string key, std::string name, std::string (*contact_input)(InputNotes&))
      : key_(std::move(key)), name_(std::move(name)), contact_input_(contact_input) {}
  std::string key() const override { return key_; }
  std::string name() const override { return name_; }
  std::string contact_input(InputNotes& notes) const override { return contact_input_(notes); }

 private:
  std::string key_, name_;
  std::string (*contact_input_)(InputNotes&);
};

std::vector<std::string> runnable_keys() {
  std::vector<std::string> keys;
  for (const Engine* engine : runnable_engines()) keys.push_back(engine->key());
  return keys;
}

}  // namespace

std::unique_ptr<WrittenEngine> written_engine(const std::string& key, const std::string& name,
                                              std::string (*contact_input)(InputNotes&)) {
  return std::make_unique<FunctionEngine>(key, name, contact_input);
}

RegisteredEngine::RegisteredEngine(Maker make) { makers_from_elsewhere().push_back(make); }

const std::vector<std::unique_ptr<WrittenEngine>>& engine_catalogue() {
  static const std::vector<std::unique_ptr<WrittenEngine>> list = [] {
    auto all = engines::make_all();
    for (const Maker make : makers_from_elsewhere()) all.push_back(make());
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a->key() < b->key(); });
    return all;
  }();
  return list;
}

std::vector<std::string> engine_input_names() {
  std::vector<std::string> names;
  for (const auto& engine : engine_catalogue()) names.push_back(engine->key());
  return names;
}

std::string engine_input(const std::string& key, const ContactParameters& parameters,
                         const EngineInputOptions& options) {
  for (const auto& engine : engine_catalogue()) {
    if (engine->key() != key) continue;
    InputNotes notes(parameters, options, engine->name());
    return engine->contact_input(notes);
  }
  const std::string meant = nearest_name(key, engine_input_names());
  throw InputError(
      "there is no engine '" + key + "'; " +
      (meant.empty() ? "there are " + joined(engine_input_names(), ", ") : "did you mean '" + meant + "'?"));
}

std::vector<const Engine*> runnable_engines() {
  std::vector<const Engine*> found;
  for (const auto& engine : engine_catalogue())
    if (const auto* runnable = dynamic_cast<const Engine*>(engine.get())) found.push_back(runnable);
  return found;
}

std::string list_runnable_engines(std::string (Engine::*text)() const, const std::string& separator) {
  std::vector<std::string> texts;
  for (const Engine* engine : runnable_engines()) texts.push_back((engine->*text)());
  return joined(texts, separator);
}

const Engine& engine_of(const std::string& key) {
  for (const Engine* engine : runnable_engines())
    if (engine->key() == key) return *engine;
  const std::string meant = nearest_name(key, runnable_keys());
  throw InputError("asperity cannot run an engine '" + key + "'; " +
                   (meant.empty() ? "it runs " + list_runnable_engines(&Engine::key, " and ")
                                  : "did you mean '" + meant + "'?"));
}

}  // namespace asperity
