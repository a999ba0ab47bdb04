#include "engines/engine_registry.h"

#include "core/error.h"
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
  FunctionEngine(std::string key, std::string name, const EngineWriters& writers)
      : key_(std::move(key)), name_(std::move(name)), writers_(writers) {}
  std::string key() const override { return key_; }
  std::string name() const override { return name_; }
  std::string contact_input(InputNotes& notes) const override { return writers_.contact(notes); }
  std::string matrix_input(const MaterialMatrix& matrix) const override {
    return writers_.matrix ? writers_.matrix(matrix) : WrittenEngine::matrix_input(matrix);
  }
  std::string elastoplastic_matrix_input(const MaterialMatrix& matrix) const override {
    return writers_.elastoplastic_matrix ? writers_.elastoplastic_matrix(matrix)
                                         : WrittenEngine::elastoplastic_matrix_input(matrix);
  }
  std::string elastoplastic_law() const override { return writers_.elastoplastic_law; }
  std::string elastoplastic_input(InputNotes& notes) const override {
    return writers_.elastoplastic ? writers_.elastoplastic(notes) : WrittenEngine::elastoplastic_input(notes);
  }
  bool writes_boxes() const override { return writers_.box != nullptr; }
  std::vector<std::pair<std::string, std::string>> box_files(const MaterialMatrix& matrix,
                                                             const ParticleBox& box) const override {
    return writers_.box ? writers_.box(matrix, box, matrix_file()) : WrittenEngine::box_files(matrix, box);
  }

 private:
  std::string key_, name_;
  EngineWriters writers_;
};

std::string key_of(const std::unique_ptr<WrittenEngine>& engine) { return engine->key(); }

}  // namespace

std::string WrittenEngine::elastoplastic_input(InputNotes&) const {
  throw InputError("asperity writes no elasto-plastic normal law for " + name() + "; leave --normal-law out");
}

std::string WrittenEngine::elastoplastic_matrix_input(const MaterialMatrix&) const {
  throw InputError("asperity writes no elasto-plastic normal law of many particles for " + name() +
                   "; it does for liggghts, mercurydpm and yade. Leave --normal-law out");
}

std::string WrittenEngine::matrix_input(const MaterialMatrix&) const {
  throw InputError("asperity writes the contacts of " + name() + " one at a time: give one record");
}

std::vector<std::pair<std::string, std::string>> WrittenEngine::box_files(const MaterialMatrix&,
                                                                          const ParticleBox&) const {
  throw InputError("asperity writes no box of particles for " + name() +
                   "; it does for lammps, liggghts and yade. Leave --box out to write the contacts alone");
}

std::unique_ptr<WrittenEngine> written_engine(const std::string& key, const std::string& name,
                                              const EngineWriters& writers) {
  return std::make_unique<FunctionEngine>(key, name, writers);
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

const WrittenEngine& written_engine_of(const std::string& key) {
  return *entry_named(engine_catalogue(), key, key_of, "there is no engine");
}

std::string engine_input(const std::string& key, const ContactParameters& parameters,
                         const EngineInputOptions& options) {
  const WrittenEngine& engine = written_engine_of(key);
  InputNotes notes(parameters, options, engine.name());
  if (options.normal_law == "hertz") return engine.contact_input(notes);
  const std::string law = engine.elastoplastic_law();
  if (options.normal_law != law)
    throw InputError("asperity writes no normal law '" + options.normal_law + "' for " + engine.name() +
                     "; --normal-law is hertz" + (law.empty() ? "" : " or " + law) + " there");
  return engine.elastoplastic_input(notes);
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
