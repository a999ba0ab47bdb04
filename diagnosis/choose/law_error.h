// What the laws of an explanation may be off by, as a part of its evidence: recorded = simulated +
// discrepancy + noise (Kennedy & O'Hagan 2001). The discrepancy of an effect is its own contribution C, the
// largest nearby, times a factor that varies along the data,
//   C_i sum_k m_k phi_k(i),   m_k ~ N(0, accuracy^2 w_k),  sum w_k = 1,
// phi_k: cosines along each run's segments (over all cycles, and within one), or along what varies in a
// series. With its coefficients integrated out, a further effect that only mends what the first law may be
// off by anyway gains nothing.
//
// The accuracy is a bound: a law may well be nearer. Between sets the evidence counts its mean over parts of
// that bound (parts_of_bound), or a law that states little would win over one that states much and fits.
// Whether a member earns its place is asked with the bound itself.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "diagnosis/fit/stated_errors.h"

namespace asperity {

/// What an explanation may be off by.
struct ModelErrors {
  std::vector<LawError> of_mesh;  ///< of one solution, by the same part everywhere or straight in the load
  std::vector<LawError> of_laws;  ///< each of its own factor in each run and segment
  std::vector<LawError> of_mesh_along = {};  ///< of one solution under normal load, likewise
  std::vector<LawError> of_surfaces = {};    ///< of one surface, each by the same part everywhere
  /// Of laws without history: at each load the same on loading, on unloading and in each run.
  std::vector<LawError> of_curves = {};
};

/// Whether finite elements are off by one factor at all samples: as resistance is that is solved at a few
/// loads, and the approach on one surface in place of another. By its mesh the approach of a contact that is
/// pressed is off by another part at each load.
inline bool has_shared_error(const FitProblem& problem) {
  return problem.correction &&
         (problem.experiment.mode != Motion::normal || !problem.correction->surface_errors().empty());
}

/// What a fit leaves and what it may be off by.
struct Misfit {
  std::vector<double> residual;  ///< on the case's own surface, to which of_surfaces is linear
  ModelErrors errors;
};

/// With what it is off by with one factor at all samples only: mesh in sliding, and surfaces.
Misfit shared_misfit(const FitProblem& problem, const ModelFit& fit);
/// With all of it: law_errors() and surfaces.
Misfit misfit_of(const FitProblem& problem, const ModelFit& fit, const ModelFit& baseline);

/// Root of the sum of squares, of each sample; zeros of `count` where there is none.
LawError together(const std::vector<LawError>& errors, std::size_t count);

/// One for the mesh, where there is one, and one for each effect of a fit whose reduced law counts: its
/// accuracy times the largest of what it changes nearby, with the other parameters as they are.
/// part: of its accuracy, for each effect [-]; empty: one.
ModelErrors law_errors(const FitProblem& problem, const ModelFit& fit, const ModelFit& baseline,
                       const std::function<double(const Effect&)>& part = {});
/// Of all effects together.
LawError law_error(const FitProblem& problem, const ModelFit& fit, const ModelFit& baseline);

/// Parts of what laws state, each as likely a size of what they are off by [-].
constexpr double parts_of_bound[] = {1, 1.0 / 4, 1.0 / 16, 1.0 / 64};
/// The same where laws are off by a part [-] of what they state.
ModelErrors laws_off_by(double part, ModelErrors errors);

/// Cosines in which the errors of laws vary, made once for a recording.
class LawErrors {
 public:
  explicit LawErrors(const Samples& samples);

  /// -2 log likelihood, up to what all explanations share: the least of Huber's costs plus the discrepancy's
  /// own, and the log determinant of its covariance over that of the noise: of mesh under normal load and of
  /// surfaces it is left out, which every set has, so that none gains by stating or letting through less.
  struct Cost {
    double of_misfit = 0, log_determinant = 0;  ///< [-]
    /// [-]
    double sum() const { return of_misfit + log_determinant; }
  };
  Cost cost(const Samples& samples, const Noise& noise, const std::vector<double>& residual,
            const ModelErrors& errors) const;
  /// The residual without what is likely of the errors of mesh and surfaces: of the mesh at most two standard
  /// deviations each, of surfaces together no more than is likely (of_likely_length).
  std::vector<double> without_shared_error(const Samples& samples, const Noise& noise,
                                           std::vector<double> residual, const ModelErrors& errors) const;
  /// What laws that may be off add to the covariance of parameters: generalised least squares with and
  /// without their discrepancy, straight about the fit. changes: of the response with each parameter, a row
  /// for each sample; no column may be zero or like the others.
  /// In the parameters' units.
  Eigen::MatrixXd added_covariance(const Samples& samples, const Noise& noise, const Eigen::MatrixXd& changes,
                                   const ModelErrors& errors) const;

 private:
  /// Samples whose errors share coefficients, with the cosines there.
  struct Group {
    std::vector<std::size_t> samples;
    Eigen::MatrixXd shapes;  ///< sqrt(w_k) phi_k, a row for each sample
  };
  std::vector<Group> groups_;
  Group whole_;  ///< all samples, with a constant and a straight line in the load
  Group once_;   ///< all samples, with a constant
  Group curve_;  ///< all samples, with cosines along what is driven
};

/// What an effect of a fit changes at each sample, in the unit of the response; what a coefficient that is
/// calibrated anyway would take over is no part of it. with: what the fit says there; baseline: the
/// simulation by itself.
std::vector<double> contribution_of(const Effect& effect, const FitProblem& problem, const Samples& samples,
                                    const ModelFit& fit, const std::vector<double>& with,
                                    const ModelFit& baseline);

/// What the law of one effect of a set may be off by, relative: a law of the contact by what it states, since
/// its own numbers may be off in a way that its parameters take up; an instrument's, or another value of the
/// simulation, by what the data show.
/// Returns a share [-].
double accuracy_of(const Effect& effect, const FitProblem& problem, const ModelFit& fit);
/// Whether that is by what the data show.
bool is_known_exactly(const Effect& effect);

}  // namespace asperity
