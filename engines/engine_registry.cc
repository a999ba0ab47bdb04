#include "engines/engine_registry.h"

#include "core/joined.h"
#include "engines/engine.h"
#include "engines/input_notes.h"

namespace asperity {
namespace engines {
std::vector<std::unique_ptr<WrittenEngine>> make_all();  // generated from the files of kinds/
}
namespace {

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

std::string key_of(const std::unique_ptr<WrittenEngine>& engine) { return engine->key(); }

}  // namespace

std::unique_ptr<WrittenEngine> written_engine(const std::string& key, const std::string& name,
                                              std::string (*contact_input)(InputNotes&)) {
  return std::make_unique<FunctionEngine>(key, name, contact_input);
}

const std::vector<std::unique_ptr<WrittenEngine>>& engine_catalogue() {
  static const auto list = with_registered_makers(engines::make_all(), key_of);
  return list;
}

std::vector<std::string> engine_input_names() {
  std::vector<std::string> names;
  for (const auto& engine : engine_catalogue()) names.push_back(engine->key());
  return names;
}

std::string engine_input(const std::string& key, const ContactParameters& parameters,
                         const EngineInputOptions& options) {
  const auto& engine = entry_named(engine_catalogue(), key, key_of, "there is no engine");
  InputNotes notes(parameters, options, engine->name());
  return engine->contact_input(notes);
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
  const std::vector<const Engine*> engines = runnable_engines();
  return *entry_named(
      engines, key, [](const Engine* engine) { return engine->key(); }, "asperity cannot run an engine");
}

}  // namespace asperity
