// A study by half-spaces: each case's normal contact in seconds, so that hundreds of surfaces can be had
// beside the few that finite elements solve.
//
// Where some realisations of a cell of the matrix are solved as well, the mean over all is that of the
// half-spaces times how much the solved ones differ from them: a ratio estimate by double sampling (Cochran
// 1977, Sampling Techniques, section 12.8). Its error is that of the ratio over the solved ones and that of
// the half-spaces' mean over all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/study.h"

namespace asperity {

/// A mean over realisations and its standard deviation.
struct MeanOverSurfaces {
  double value = 0, sd = 0;
};

/// all: by half-spaces, of every realisation; half_spaces, elements: of those that are solved as well, in the
/// same order. Throws InputError for fewer than two of either, or where half-spaces give 0 in the mean.
MeanOverSurfaces mean_by_double_sampling(const std::vector<double>& all,
                                         const std::vector<double>& half_spaces,
                                         const std::vector<double>& elements);

/// How it is done.
struct StudyPreviewOptions {
  std::filesystem::path output;  ///< the study's folder; solved cases in it are taken along
  std::function<bool(const std::string& name)> chosen;  ///< of the cases
  /// A case's preview.json. Called by several threads at once.
  std::function<std::string(const StudyCase&)> preview;
  std::function<void(const std::string&)> say;
};

/// Previews the chosen cases into DIR/previews/CASE.json, but those that are there of the same inputs, and
/// writes previews.json and previews.csv of all. Throws InputError where a case cannot be
/// previewed.
void preview_study(const Study& study, const StudyPreviewOptions& options);

}  // namespace asperity
