#include "diagnosis/choose/law_error.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Cosines along one coordinate, and the one whose weight is half of the first's: errors of laws vary over a
/// quarter of the range.
constexpr int most_cosines = 12;
constexpr double half_weight = 4;

/// Place of each value between the least and the largest; empty where it does not vary.
std::vector<double> relative(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double from = *low, range = *high - *low;
  if (!(range > 0)) return {};
  std::vector<double> places;
  for (const double value : values) places.push_back((value - from) / range);
  return places;
}

/// sqrt(w_k) phi_k: the constant, then cosines along each coordinate; a row for each sample.
MatrixXd shapes_along(const std::vector<std::vector<double>>& coordinates, std::size_t count) {
  MatrixXd shapes = MatrixXd::Ones(static_cast<Eigen::Index>(count),
                                   1 + most_cosines * static_cast<Eigen::Index>(coordinates.size()));
  double weights = 1;
  for (std::size_t c = 0; c < coordinates.size(); ++c)
    for (int k = 1; k <= most_cosines; ++k) {
      const double weight = 1 / (1 + std::pow(k / half_weight, 2));
      weights += weight;
      for (std::size_t i = 0; i < count; ++i)
        shapes(static_cast<Eigen::Index>(i), most_cosines * static_cast<Eigen::Index>(c) + k) =
            std::sqrt(2 * weight) * std::cos(M_PI * k * coordinates[c][i]);
    }
  return shapes / std::sqrt(weights);
}

/// All samples that count, with what one solution is off by along them.
MatrixXd shapes_of_whole(const Samples& samples, const std::vector<std::size_t>& members) {
  std::vector<double> loads;
  for (const std::size_t i : members)
    loads.push_back(std::max(std::abs(samples.list[i].normal_force), std::abs(samples.list[i].response)));
  const std::vector<double> places = loads.empty() ? loads : relative(loads);
  MatrixXd shapes = MatrixXd::Ones(static_cast<Eigen::Index>(members.size()), places.empty() ? 1 : 2);
  for (std::size_t i = 0; i < places.size(); ++i) shapes(static_cast<Eigen::Index>(i), 1) = places[i] - 0.5;
  return shapes;
}

/// The same with cosines along the displacement or the force that was given.
MatrixXd shapes_of_curve(const Samples& samples, const std::vector<std::size_t>& members) {
  std::vector<bool> is_given_force(samples.list.size());
  for (const SampleRun& run : samples.runs)
    for (std::size_t i = run.begin; i < run.end; ++i) is_given_force[i] = run.response_is_displacement;
  std::vector<double> given;
  for (const std::size_t i : members)
    given.push_back(is_given_force[i] ? samples.list[i].normal_force : samples.list[i].normal_displacement);
  std::vector<std::vector<double>> places;
  if (!given.empty()) places.push_back(relative(given));
  if (!places.empty() && places.front().empty()) places.clear();
  return shapes_along(places, members.size());
}

/// A column for each error and shape; a row for each sample.
MatrixXd columns_of(const std::vector<std::size_t>& samples, const MatrixXd& shapes,
                    const std::vector<LawError>& errors) {
  const Eigen::Index columns = shapes.cols();
  MatrixXd B(static_cast<Eigen::Index>(samples.size()), columns * static_cast<Eigen::Index>(errors.size()));
  for (std::size_t e = 0; e < errors.size(); ++e)
    for (std::size_t row = 0; row < samples.size(); ++row)
      B.row(static_cast<Eigen::Index>(row)).segment(static_cast<Eigen::Index>(e) * columns, columns) =
          errors[e][samples[row]] * shapes.row(static_cast<Eigen::Index>(row));
  return B;
}

/// Of the whitened residual, at these samples.
VectorXd part_of(const VectorXd& white, const NoiseFilter& filter, const std::vector<std::size_t>& samples) {
  VectorXd part(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t row = 0; row < samples.size(); ++row)
    part[static_cast<Eigen::Index>(row)] = white[filter.place(samples[row])];
  return part;
}

}  // namespace

ModelErrors laws_off_by(double part, ModelErrors errors) {
  for (LawError& of_law : errors.of_laws)
    for (double& off : of_law) off *= part;
  for (LawError& of_curve : errors.of_curves)
    for (double& off : of_curve) off *= part;
  return errors;
}

LawErrors::LawErrors(const Samples& samples) {
  for (std::size_t i = 0; i < samples.list.size(); ++i)
    if (samples.list[i].counts) whole_.samples.push_back(i);
  whole_.shapes = shapes_of_whole(samples, whole_.samples);
  once_ = {whole_.samples, whole_.shapes.leftCols(1)};
  curve_ = {whole_.samples, shapes_of_curve(samples, whole_.samples)};
  std::map<std::pair<std::size_t, int>, std::vector<std::size_t>> members;
  for (std::size_t r = 0; r < samples.runs.size(); ++r)
    for (std::size_t i = samples.runs[r].begin; i < samples.runs[r].end; ++i)
      if (samples.list[i].counts)
        members[samples.runs[r].independent_rows ? std::pair<std::size_t, int>{samples.runs[r].table, -1}
                                                 : std::pair{r, samples.list[i].segment}]
            .push_back(i);
  for (auto& [key, of_key] : members) {
    std::vector<std::size_t>& list = of_key;  // which lambdas may take, unlike a binding
    std::vector<std::vector<double>> coordinates;
    const auto add = [&](const std::function<double(const Sample&)>& value) {
      std::vector<double> values;
      for (const std::size_t i : list) values.push_back(value(samples.list[i]));
      values = relative(values);
      if (!values.empty()) coordinates.push_back(std::move(values));
    };
    if (key.second < 0) {
      for (const auto& value : {&Sample::normal_force, &Sample::normal_displacement, &Sample::speed,
                                &Sample::rms_roughness, &Sample::rail_angle, &Sample::radius})
        add([value](const Sample& s) { return s.*value; });
    } else {
      // Along the segment, and along one cycle of it where there are several.
      add([](const Sample& s) { return static_cast<double>(s.index); });
      std::map<int, std::pair<std::size_t, std::size_t>> parts;
      for (const std::size_t i : list) {
        auto& part = parts.try_emplace(samples.list[i].part, i, i).first->second;
        part.second = i;
      }
      if (parts.size() > 1)
        add([&](const Sample& s) {
          const auto& [from, to] = parts.at(s.part);
          return to > from ? static_cast<double>(s.index - from) / static_cast<double>(to - from) : 0.0;
        });
    }
    MatrixXd shapes = shapes_along(coordinates, list.size());
    groups_.push_back({std::move(list), std::move(shapes)});
  }
}

LawErrors::Cost LawErrors::cost(const Samples& samples, const Noise& noise,
                                const std::vector<double>& residual, const ModelErrors& errors) const {
  const NoiseFilter filter(samples, noise.sd, noise.shared);
  const std::vector<double> white = filter.whitened(residual);
  VectorXd r = Eigen::Map<const VectorXd>(white.data(), static_cast<Eigen::Index>(white.size()));
  Cost cost;
  const auto take_off = [&](const Group& group, const std::vector<LawError>& counted,
                            const std::vector<LawError>& free) {
    if ((counted.empty() && free.empty()) || group.samples.empty()) return;
    std::vector<LawError> all = free;
    all.insert(all.end(), counted.begin(), counted.end());
    MatrixXd B = columns_of(group.samples, group.shapes, all);
    filter.whiten(group.samples, B);
    const VectorXd part = part_of(r, filter, group.samples);
    const LikelyPart t = likely_part(B, part);
    cost.of_misfit += t.coefficients.squaredNorm();
    if (!counted.empty()) {
      cost.log_determinant += t.log_determinant;
      const auto columns = static_cast<Eigen::Index>(free.size()) * group.shapes.cols();
      if (columns > 0) cost.log_determinant -= likely_part(B.leftCols(columns), part).log_determinant;
    }
    for (std::size_t row = 0; row < group.samples.size(); ++row)
      r[filter.place(group.samples[row])] = t.left[static_cast<Eigen::Index>(row)];
  };
  take_off(whole_, errors.of_mesh, {});
  take_off(once_, {}, errors.of_surfaces);
  if (!errors.of_curves.empty()) take_off(curve_, errors.of_curves, errors.of_mesh_along);
  for (const Group& group : groups_) take_off(group, errors.of_laws, errors.of_mesh_along);
  for (Eigen::Index i = 0; i < r.size(); ++i) cost.of_misfit += huber_cost(r[i]);
  if (!std::isfinite(cost.sum())) cost.of_misfit = std::numeric_limits<double>::infinity();
  return cost;
}

MatrixXd LawErrors::added_covariance(const Samples& samples, const Noise& noise, const MatrixXd& changes,
                                     const ModelErrors& errors) const {
  const NoiseFilter filter(samples, noise.sd, noise.shared);
  MatrixXd white(static_cast<Eigen::Index>(whole_.samples.size()), changes.cols());
  for (Eigen::Index k = 0; k < changes.cols(); ++k) {
    const auto column = filter.whitened({changes.col(k).begin(), changes.col(k).end()});
    white.col(k) = Eigen::Map<const VectorXd>(column.data(), static_cast<Eigen::Index>(column.size()));
  }
  const VectorXd size = white.colwise().norm();
  white.array().rowwise() /= size.transpose().array();
  const MatrixXd by_noise = white.transpose() * white, I = MatrixXd::Identity(white.cols(), white.cols());
  // What a law that may be off hides of the information about the parameters.
  const auto hide = [&](const Group& group, const std::vector<LawError>& of_laws, MatrixXd& hidden) {
    if (of_laws.empty() || group.samples.empty()) return;
    MatrixXd B = columns_of(group.samples, group.shapes, of_laws);
    filter.whiten(group.samples, B);
    MatrixXd J(static_cast<Eigen::Index>(group.samples.size()), white.cols());
    for (std::size_t row = 0; row < group.samples.size(); ++row)
      J.row(static_cast<Eigen::Index>(row)) = white.row(filter.place(group.samples[row]));
    const MatrixXd seen = B.transpose() * J;
    hidden +=
        seen.transpose() * (MatrixXd::Identity(B.cols(), B.cols()) + B.transpose() * B).ldlt().solve(seen);
  };
  // Errors of one curve and of single runs overlap: each by itself, and the sum, which is no less.
  MatrixXd of_curves = MatrixXd::Zero(white.cols(), white.cols()), of_runs = of_curves;
  hide(curve_, errors.of_curves, of_curves);
  for (const Group& group : groups_) hide(group, errors.of_laws, of_runs);
  const MatrixXd added = (by_noise - of_curves).ldlt().solve(I) + (by_noise - of_runs).ldlt().solve(I) -
                         2 * by_noise.ldlt().solve(I);
  return (size.cwiseInverse().asDiagonal() * added * size.cwiseInverse().asDiagonal()).eval();
}

std::vector<double> LawErrors::without_shared_error(const Samples& samples, const Noise& noise,
                                                    std::vector<double> residual,
                                                    const ModelErrors& errors) const {
  if ((errors.of_mesh.empty() && errors.of_surfaces.empty()) || whole_.samples.empty()) return residual;
  constexpr double most = 2;  // standard deviations
  const NoiseFilter filter(samples, noise.sd, noise.shared);
  const std::vector<double> white = filter.whitened(residual);
  const MatrixXd of_mesh = columns_of(whole_.samples, whole_.shapes, errors.of_mesh),
                 of_surfaces = columns_of(once_.samples, once_.shapes, errors.of_surfaces);
  MatrixXd B(of_mesh.rows(), of_mesh.cols() + of_surfaces.cols());
  B << of_mesh, of_surfaces;
  MatrixXd whitened = B;
  filter.whiten(whole_.samples, whitened);
  const VectorXd r = Eigen::Map<const VectorXd>(white.data(), static_cast<Eigen::Index>(white.size()));
  VectorXd likely = likely_part(whitened, part_of(r, filter, whole_.samples)).coefficients;
  const Eigen::Index mesh = of_mesh.cols(), surfaces = of_surfaces.cols();
  likely.head(mesh) = likely.head(mesh).cwiseMax(-most).cwiseMin(most);
  likely.tail(surfaces) = of_likely_length(likely.tail(surfaces));
  const VectorXd off = B * likely;
  for (std::size_t row = 0; row < whole_.samples.size(); ++row)
    residual[whole_.samples[row]] -= off[static_cast<Eigen::Index>(row)];
  return residual;
}

}  // namespace asperity
