// A study by half-spaces: each case's normal contact in seconds, so that hundreds of surfaces can be had
// beside the few that finite elements solve, which correct their mean (core/double_sampling.h).
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/study.h"

namespace asperity {

/// How it is done.
struct StudyPreviewOptions {
  std::filesystem::path output;  ///< the study's folder; solved cases in it are taken along
  std::function<bool(const std::string& name)> chosen;  ///< of the cases
  /// A case's preview.json. Called by several threads at once.
  std::function<std::string(const StudyCase&)> preview;
  std::function<void(const std::string&)> say;
  int parallel = 0;  ///< cases at the same time; 0: as many as the machine has cores
};

/// Previews the chosen cases into DIR/previews/CASE.json, but those that are there of the same inputs, and
/// writes previews.json and previews.csv of all. Throws InputError where a case cannot be
/// previewed.
void preview_study(const Study& study, const StudyPreviewOptions& options);

}  // namespace asperity
