// What a discrete element engine does with the numbers of a law: the third column of the comparison. The
// engine is run live, once for each experiment however many lines ask for it. One that is missing or fails
// spoils this column only.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "dem_compare/compare/law_column.h"
#include "dem_compare/compare/row.h"
#include "engines/engine.h"

namespace asperity {

class EngineColumn {
 public:
  /// No name: no engine is run. Inputs, logs and traces go to folders of their own in `folder`.
  /// Throws InputError for an engine that is not known.
  EngineColumn(const std::string& name, std::filesystem::path folder, EngineRunOptions options = {});

  /// What the engine gives for a law's request; with its reason where it gives none.
  ComparedValue value(const LawValue& law);

  /// The engine's first failure, one sentence; "" if there was none.
  const std::string& failure() const { return failure_; }
  std::string engine() const { return engine_ ? engine_->name() : ""; }
  std::string version() const { return done_.empty() ? "" : done_.begin()->second.version; }
  std::size_t runs() const { return done_.size(); }

 private:
  const EngineRun& run(const EngineExperiment& experiment);
  double measured(const EngineRequest& request);

  const Engine* engine_;
  std::filesystem::path folder_;
  EngineRunOptions options_;
  std::map<std::string, EngineRun> done_;  ///< by the text of the input
  std::string failure_;
};

}  // namespace asperity
