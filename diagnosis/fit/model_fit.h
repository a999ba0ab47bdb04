// Fits an explanation to a recording: many starts on thinned samples, the last steps on all of them.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <memory>

#include "diagnosis/fit/bounded_least_squares.h"
#include "diagnosis/fit/explanation.h"
#include "diagnosis/fit/noise.h"

namespace asperity {

/// What is fitted, shared by all fits.
struct FitProblem {
  Experiment experiment;
  SimulationChoice choice;
  Samples samples, thin;
  Noise noise;
  /// At the case as it is, where the simulation is one of finite elements; null: reduced laws.
  std::shared_ptr<const BranchCorrection> correction;
  std::vector<double>
      baseline_residual;  ///< recorded minus simulated before physics is added, of all samples

  /// Recorded minus simulated.
  static std::vector<double> residual(const Samples& samples, const std::vector<double>& simulated);
};

struct ModelFit {
  std::shared_ptr<const Explanation> explanation;
  std::vector<double> values;  ///< of explanation->parameters()
  /// Which of the parameters the law does without, held at FreeParameter::absent; empty: none.
  std::vector<bool> held;
  /// Factors of the ways in which the recorded surface differs from the case's, as last known [-]; empty:
  /// none.
  std::vector<double> surface;
  /// Finite elements were solved with these values: the reduced laws of effects with entries in the case
  /// count for no more than small steps.
  bool is_confirmed = false;
  double cost = 0;        ///< sum of Huber's costs of the whitened residuals of all samples [-]
  std::size_t count = 0;  ///< of whitened residuals
  /// Part of what its laws state that they are likely off by, by what the fit leaves (root mean square) [-].
  double part_of_bound = 1;
  /// Of the search coordinates, the last the zero of another surface where there is one; empty where it was
  /// not asked for.
  Eigen::MatrixXd covariance;
  /// Factors on the standard deviations, downwards and upwards, that make the cost rise as a parabola would
  /// (with_intervals()).
  std::vector<std::pair<double, double>> stretch;

  /// What the fitted model says at these samples, in their unit.
  std::vector<double> simulate(const Samples& samples) const;
  std::vector<double> residual(const Samples& samples) const {
    return FitProblem::residual(samples, simulate(samples));
  }
  /// The same with these of its effects only; parameters that the others replaced are those of `baseline`.
  ModelFit only(const FitProblem& problem, const std::vector<const Effect*>& effects,
                const ModelFit& baseline) const;
  bool is_held(std::size_t parameter) const { return !held.empty() && held[parameter]; }
  /// How many of the parameters are free [-].
  std::size_t free_parameters() const {
    return values.size() - static_cast<std::size_t>(std::count(held.begin(), held.end(), true));
  }
  /// Null where it has no such parameter; `owner` null: of the simulation itself.
  /// In the parameter's unit.
  const double* value_of(const std::string& name, const Effect* owner) const;
  /// Parameters of each effect, in their order.
  std::vector<const double*> values_of_effects() const;
  /// Numbers that the effects take from the recording, see Effect::numbers_read_off() [-].
  double numbers_read_off(const Experiment& experiment) const;
  /// Whether each effect is itself with these values, see Effect::is_itself().
  bool is_itself() const;
  /// Where an effect is not itself, the same with the simpler one in its place, from each of its starts.
  std::vector<ModelFit> in_simpler_form(const FitProblem& problem) const;
  /// Name of the first parameter that ended at a bound of the search; empty: none did.
  std::string stopped_at() const;
  /// Whether the 95 % interval of one holds the value with which its effect is none; inflation as below [-].
  bool holds_no_effect(double inflation) const;
  /// 95 % interval of a parameter; `inflation` multiplies the variance.
  /// inflation [-].
  DiagnosedParameter parameter(std::size_t index, double inflation) const;
};

/// From the parameters' own starts, those read off the residuals, and `near`: values of a smaller explanation
/// within this one. Parameters that laws can do without are held or free as there, and else
/// held, or free as well.
enum class Freedom { as_laws_need, all };
ModelFit fit_explanation(const FitProblem& problem, const std::vector<const Effect*>& effects,
                         const ModelFit* near = nullptr, Freedom freedom = Freedom::as_laws_need);
/// From where a fit stands, on these samples (some of which may not count): parameters and cost there.
ModelFit refitted(const FitProblem& problem, const ModelFit& fit, const Samples& samples, bool covariance,
                  int iterations);
/// The last steps, on all samples and with the covariance there.
ModelFit finished(const FitProblem& problem, const ModelFit& fit);

/// The same explanation with finite elements off by one of the standard deviations that they state: of the
/// displacement or friction, and of the lateral stiffness where that is stated. Expects a correction.
std::vector<std::shared_ptr<const Explanation>> off_by_mesh_errors(const ModelFit& fit);

/// The same explanation on another surface of the case: this many standard deviations away in each of the
/// ways that surfaces differ in [-]. Expects a correction.
std::shared_ptr<const Explanation> on_surface(const Explanation& explanation,
                                              const std::vector<double>& factors);

/// Looks along each parameter for where the cost has risen by that of two standard deviations, the others
/// following as the covariance says, and fitted anew where that is no parabola (Venzon & Moolgavkar 1988):
/// it misleads where the response jumps, bends or meets a bound, and where a valley winds.
ModelFit with_intervals(const FitProblem& problem, const ModelFit& fit);

}  // namespace asperity
