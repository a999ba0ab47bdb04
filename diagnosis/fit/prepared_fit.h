// From a recording to what all fits share: its samples, its own simulation calibrated as it says, what is
// noise, what an outlier.
#pragma once

#include <functional>

#include "diagnosis/fit/model_fit.h"
#include "diagnosis/fit/noise_of_control.h"

namespace asperity {

struct PreparedFit {
  FitProblem problem;
  ModelFit baseline;        ///< the recording's own simulation
  Noise short_scale_noise;  ///< before anything is learned from residuals that are noise
  Noise of_response;        ///< without what noisy controls add
  std::vector<NoisyControl> noisy_controls = {};
  std::size_t outliers = 0;
  std::size_t in_jumps = 0;  ///< samples that do not count because the probe jumps (probe_jumps.h)

  /// Noise from what a fit leaves, where that is noise, of at most `off` times the deviation estimated first
  /// [-]; false if nothing changes.
  bool learn_noise(const std::vector<double>& residual, double off = may_be_off);
  /// The noise of rows whose radius, roughness, load, ... have a noise of their own anew, through the slope
  /// of a fit, and the baseline with it. False if that changes little, or nothing.
  bool pass_on_deviations(const ModelFit& fit);
};

/// Completes a problem whose samples and experiment are known: what finite elements say of the case as it is.
using MakeCorrection = std::function<void(FitProblem&)>;

/// Throws InputError where nothing presses or responds.
PreparedFit prepared_fit(const Recording& recording, const std::function<void(const std::string&)>& progress,
                         const MakeCorrection& correct = nullptr);

}  // namespace asperity
