// What noise in the channels that drive a simulation adds to what the recorded response is off by.
#pragma once

#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// A driving channel of one table with noise that its response does not follow.
struct NoisyControl {
  std::size_t table = 0;
  bool by_row = false;  ///< of a series, whose rows or recording give it
  std::string name;
  double Sample::*channel = nullptr;  ///< [SI]
  std::vector<double> sd;  ///< of all samples, as given or as their run scatters over neighbours [SI]
  double largest = 0;      ///< of these before smoothing [SI]
  double over_noise =
      0;  ///< what the simulation makes of it over the noise of the response, root mean square [-]
};

/// Of series, all channels that a simulation may depend on whose rows have a noise given, as that of the
/// response is. Of traces, those
/// whose noise, passed on by the simulation, accounts for a residual that scatters over neighbours by
/// more than the noise of the response: one that follows its control, however noisy that is, is none.
std::vector<NoisyControl> noisy_controls(const Recording& recording, const FitProblem& problem,
                                         const ModelFit& baseline);

/// Smooths them, until what is left is well below the noise of the response where parts are long enough.
void smooth_controls(Samples& samples, std::vector<NoisyControl>& controls);

/// Adds what is left of them, through the slope of the simulation, to the standard deviations of `noise`;
/// correlations are those of the residual then. `noise.of_control` says what was found. `baseline`: any fit.
void add_noise_of_controls(const std::vector<NoisyControl>& controls, const FitProblem& problem,
                           const ModelFit& baseline, Noise& noise);

/// "FILE: 'CHANNEL_sd' is not used: why", of deviations that are given and that no sample counts.
std::vector<std::string> unused_deviations(const Recording& recording, const Noise& noise);

}  // namespace asperity
