#include "diagnosis/challenge/user_baselines.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnosis/choose/held_out.h"
#include "diagnosis/fit/model_fit.h"

namespace asperity {
namespace {

/// What a user has: the recorded channels of each sample, those that vary, with zero mean and unit variance.
struct Features {
  std::vector<std::string> names;
  Eigen::MatrixXd values;  ///< a row for each sample
};

Features features_of(const std::vector<Sample>& samples) {
  const std::vector<std::pair<std::string, std::function<double(const Sample&)>>> channels{
      {"displacement", [](const Sample& s) { return s.normal_displacement; }},
      {"load", [](const Sample& s) { return s.normal_force; }},
      {"position", [](const Sample& s) { return s.lateral_displacement; }},
      {"direction", [](const Sample& s) { return static_cast<double>(s.direction); }},
      {"time", [](const Sample& s) { return s.time; }},
      {"cycle", [](const Sample& s) { return s.cycle; }},
      {"speed", [](const Sample& s) { return s.speed; }},
      {"roughness", [](const Sample& s) { return s.rms_roughness; }},
      {"angle", [](const Sample& s) { return s.rail_angle; }}};
  Features features;
  std::vector<Eigen::VectorXd> columns;
  for (const auto& [name, channel] : channels) {
    Eigen::VectorXd column(static_cast<Eigen::Index>(samples.size()));
    for (std::size_t i = 0; i < samples.size(); ++i)
      column(static_cast<Eigen::Index>(i)) = channel(samples[i]);
    const double mean = column.mean(), sd = std::sqrt((column.array() - mean).square().mean());
    if (!(sd > 1e-9 * std::abs(mean)) || sd == 0) continue;
    columns.push_back((column.array() - mean) / sd);
    features.names.push_back(name);
  }
  features.values.resize(static_cast<Eigen::Index>(samples.size()),
                         static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c)
    features.values.col(static_cast<Eigen::Index>(c)) = columns[c];
  return features;
}

struct Terms {
  std::vector<std::string> names;
  Eigen::MatrixXd values;
};

/// All products up to the third degree.
Terms terms_of(const Features& features) {
  Terms terms;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(features.values.rows());
  std::vector<Eigen::VectorXd> columns{ones};
  terms.names = {"1"};
  constexpr int degree = 3;
  std::function<void(Eigen::Index, int, const Eigen::VectorXd&, const std::string&)> extend =
      [&](Eigen::Index from, int left, const Eigen::VectorXd& product, const std::string& name) {
        if (left == 0) return;
        for (Eigen::Index c = from; c < features.values.cols(); ++c) {
          const Eigen::VectorXd next = product.array() * features.values.col(c).array();
          const std::string longer =
              name + (name.empty() ? "" : " ") + features.names[static_cast<std::size_t>(c)];
          columns.push_back(next);
          terms.names.push_back(longer);
          extend(c, left - 1, next, longer);
        }
      };
  extend(0, degree, ones, "");
  terms.values.resize(features.values.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c)
    terms.values.col(static_cast<Eigen::Index>(c)) = columns[c];
  return terms;
}

/// Orthogonal matching pursuit in units of noise; coefficients of all terms, most of them zero.
Eigen::VectorXd sparse_fit(const Eigen::MatrixXd& terms, const Eigen::VectorXd& residual) {
  constexpr int most_terms = 12;
  const double log_n = std::log(static_cast<double>(residual.size()));
  const Eigen::VectorXd norms = terms.colwise().norm().cwiseMax(1e-30);
  std::vector<Eigen::Index> chosen;
  Eigen::VectorXd best = Eigen::VectorXd::Zero(terms.cols()), left = residual;
  double criterion = residual.squaredNorm();
  while (static_cast<int>(chosen.size()) < std::min<int>(most_terms, static_cast<int>(residual.size()) - 1)) {
    Eigen::Index next = 0;
    Eigen::VectorXd correlation = (terms.transpose() * left).cwiseAbs().cwiseQuotient(norms);
    for (const auto used : chosen) correlation(used) = -1;
    correlation.maxCoeff(&next);
    chosen.push_back(next);
    Eigen::MatrixXd part(terms.rows(), static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t c = 0; c < chosen.size(); ++c)
      part.col(static_cast<Eigen::Index>(c)) = terms.col(chosen[c]);
    const Eigen::VectorXd coefficients = part.colPivHouseholderQr().solve(residual);
    left = residual - part * coefficients;
    const double now = left.squaredNorm() + static_cast<double>(chosen.size()) * log_n;
    if (now >= criterion) break;
    criterion = now;
    best.setZero();
    for (std::size_t c = 0; c < chosen.size(); ++c)
      best(chosen[c]) = coefficients(static_cast<Eigen::Index>(c));
  }
  return best;
}

/// Gaussian process with the squared-exponential kernel and noise of unit variance.
class Process {
 public:
  Process(double amplitude, double length) : variance_(amplitude * amplitude), length_(length) {}

  /// Log marginal likelihood.
  double learn(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
    x_ = x;
    Eigen::MatrixXd K = kernel(x, x);
    K.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> factor(K);
    weights_ = factor.solve(y);
    const Eigen::MatrixXd L = factor.matrixL();
    return -0.5 * y.dot(weights_) - L.diagonal().array().log().sum();
  }
  Eigen::VectorXd predict(const Eigen::MatrixXd& x) const { return kernel(x, x_) * weights_; }

 private:
  Eigen::MatrixXd kernel(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const {
    const Eigen::VectorXd aa = a.rowwise().squaredNorm(), bb = b.rowwise().squaredNorm();
    Eigen::MatrixXd distance = -2 * a * b.transpose();
    distance.colwise() += aa;
    distance.rowwise() += bb.transpose();
    return variance_ * (-distance.array().max(0) / (2 * length_ * length_)).exp();
  }
  double variance_, length_;
  Eigen::MatrixXd x_;
  Eigen::VectorXd weights_;
};

Eigen::MatrixXd rows_of(const Eigen::MatrixXd& all, const std::vector<Eigen::Index>& rows) {
  Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()), all.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) part.row(static_cast<Eigen::Index>(i)) = all.row(rows[i]);
  return part;
}

std::vector<Eigen::Index> spread(const std::vector<Eigen::Index>& rows, std::size_t most) {
  if (rows.size() <= most) return rows;
  std::vector<Eigen::Index> part;
  for (std::size_t i = 0; i < most; ++i) part.push_back(rows[i * rows.size() / most]);
  return part;
}

/// The amplitude and length of largest likelihood.
std::pair<double, double> process_scales(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
  const double rms = std::max(0.1, std::sqrt(y.squaredNorm() / static_cast<double>(y.size())));
  std::pair<double, double> best{rms, 1};
  double most = -1e300;
  for (const double amplitude : {0.3 * rms, rms, 3 * rms})
    for (const double length : {0.1, 0.25, 0.6, 1.5, 4.0}) {
      const double likelihood = Process(amplitude, length).learn(x, y);
      if (likelihood > most) most = likelihood, best = {amplitude, length};
    }
  return best;
}

}  // namespace

UserBaselines user_baselines(const Recording& recording) {
  // The simulation calibrated as the recording asks for, on all data: what is left is what both work on.
  FitProblem problem;
  problem.samples = samples_of(recording);
  problem.experiment = experiment_of(recording, problem.samples);
  problem.choice = completed(recording.simulation, problem.experiment);
  problem.thin = problem.samples;
  std::vector<double> recorded;
  for (const auto& sample : problem.samples.list) recorded.push_back(sample.response);
  problem.noise = estimate_noise(recording, problem.samples, recorded);
  const ModelFit fit = fit_explanation(problem, {});
  const std::vector<double> residual = FitProblem::residual(problem.samples, fit.simulate(problem.samples));
  problem.noise = estimate_noise(recording, problem.samples, residual);
  const Blocks blocks = blocks_of(problem.samples);

  const Features features = features_of(problem.samples.list);
  const Terms terms = terms_of(features);
  Eigen::VectorXd r(static_cast<Eigen::Index>(residual.size()));
  std::vector<Eigen::Index> usable;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    r(static_cast<Eigen::Index>(i)) = residual[i] / problem.noise.sd[i];
    if (problem.samples.list[i].counts) usable.push_back(static_cast<Eigen::Index>(i));
  }
  const auto part = [&](const std::vector<Eigen::Index>& rows) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) values(static_cast<Eigen::Index>(i)) = r(rows[i]);
    return values;
  };
  constexpr std::size_t most_for_scales = 220, most_for_process = 500;
  const auto for_scales = spread(usable, most_for_scales);
  const auto [amplitude, length] = process_scales(rows_of(features.values, for_scales), part(for_scales));

  UserBaselines result;
  double count = 0;
  for (int block = 0; block < blocks.count; ++block) {
    std::vector<Eigen::Index> seen, unseen;
    for (const auto i : usable)
      (blocks.of_sample[static_cast<std::size_t>(i)] == block ? unseen : seen).push_back(i);
    if (seen.size() < 3 || unseen.empty()) continue;
    const Eigen::VectorXd target = part(unseen);
    const Eigen::VectorXd coefficients = sparse_fit(rows_of(terms.values, seen), part(seen));
    const auto learned = spread(seen, most_for_process);
    Process process(amplitude, length);
    process.learn(rows_of(features.values, learned), part(learned));
    result.simulation += target.squaredNorm();
    result.sparse_regression += (target - rows_of(terms.values, unseen) * coefficients).squaredNorm();
    result.gaussian_process += (target - process.predict(rows_of(features.values, unseen))).squaredNorm();
    count += static_cast<double>(unseen.size());
  }
  for (double* sum : {&result.simulation, &result.sparse_regression, &result.gaussian_process})
    *sum /= std::max(1.0, count);
  const Eigen::VectorXd whole = sparse_fit(rows_of(terms.values, usable), part(usable));
  for (Eigen::Index c = 0; c < whole.size(); ++c)
    if (whole(c) != 0) result.terms.push_back(terms.names[static_cast<std::size_t>(c)]);
  return result;
}

}  // namespace asperity
