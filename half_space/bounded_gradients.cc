#include "half_space/bounded_gradients.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/quantity.h"
#include "core/threads.h"

namespace asperity::half_space {
namespace {

class BoundedGradients {
 public:
  BoundedGradients(const Compliance& compliance, const Field& gap, const NormalLoad& load,
                   const NormalContactOptions& options, NormalContactSolution& solution)
      : compliance_(compliance),
        gap_(gap),
        load_(load),
        hardness_(options.hardness),
        cells_(gap.size()),
        s_(solution),
        p_(solution.pressure),
        open_(solution.gap),
        direction_(cells_, 0.0),
        response_(cells_) {}

  void run(const NormalContactOptions& options) {
    if (load_.by_force) fit_to_force();
    displace();
    for (s_.iterations = 0;; ++s_.iterations) {
      measure_gap();
      if (s_.error <= options.tolerance) break;
      if (s_.iterations >= options.most_iterations)
        throw WorkError("the half-space contact is not solved after " + std::to_string(s_.iterations) +
                        " iterations (error " + format_quantity(s_.error, Dimension::none, 2) +
                        "); take a finer grid, a smaller load, or a larger tolerance");
      step();
    }
    s_.force = compliance_.grid().cell_area() *
               sums_over<1>(cells_, [&](std::size_t k, auto& sum) { sum[0] += p_[k]; })[0];
  }

 private:
  bool is_free(std::size_t k) const { return p_[k] > 0 && p_[k] < hardness_; }

  void displace() {
    compliance_.apply(p_, displacement_);
    ++s_.convolutions;
    steps_without_ = 0;
  }

  /// Approach, gap under load, and the error.
  void measure_gap() {
    s_.approach = load_.by_force ? mean_opening() : load_.value;
    const auto sum = sums_over<7>(cells_, [&](std::size_t k, auto& sum) {
      const double g = displacement_[k] + gap_[k] - s_.approach, p = p_[k];
      const double before = std::exchange(open_[k], g);
      if (is_free(k))
        sum[0] += g * g, sum[6] += g * before, sum[1] += p * std::abs(g);
      else if (p > 0)
        sum[1] += p * std::max(0.0, g);
      else
        sum[2] += std::max(0.0, -g);
      sum[3] += p * displacement_[k];
      sum[4] += p, sum[5] += p > 0;
    });
    squares_ = sum[0], products_ = sum[6];
    const double mean_pressure = sum[5] > 0 ? sum[4] / sum[5] : 0;
    s_.error =
        sum[3] > 0 ? (sum[1] + mean_pressure * sum[2]) / sum[3] : std::numeric_limits<double>::infinity();
    // Without any pressure (a first touch) nothing is wrong where nothing overlaps.
    if (sum[4] == 0 && sum[2] == 0) s_.error = 0;
  }

  /// Mean of the opening of the cells between the bounds; where there are none, between what presses and what
  /// does not.
  double mean_opening() const {
    const auto sum = sums_over<2>(cells_, [&](std::size_t k, auto& sum) {
      if (is_free(k)) sum[0] += displacement_[k] + gap_[k], sum[1] += 1;
    });
    if (sum[1] > 0) return sum[0] / sum[1];
    double highest = -std::numeric_limits<double>::infinity(), lowest = -highest;
    for (std::size_t k = 0; k < cells_; ++k) {
      const double opening = displacement_[k] + gap_[k];
      if (p_[k] > 0)
        highest = std::max(highest, opening);
      else
        lowest = std::min(lowest, opening);
    }
    return std::isinf(lowest) ? highest : 0.5 * (highest + lowest);
  }

  struct Along {
    double gap, direction;  ///< sums of gap times direction, and of the direction
  };
  /// Turns the direction towards the gap of the cells between the bounds; what of the last one it keeps.
  Along turn_direction(double keep) {
    const auto sum = sums_over<2>(cells_, [&](std::size_t k, auto& sum) {
      const double d = is_free(k) ? open_[k] + keep * direction_[k] : 0.0;
      direction_[k] = d;
      sum[0] += open_[k] * d, sum[1] += d;
    });
    return {sum[0], sum[1]};
  }

  /// One direction, its length, and the pressures after it. What a direction keeps of the last one is Polak
  /// and Ribiere's share, without starting anew where cells open or close (Vollebregt 2014, J. Optim. Theory
  /// Appl. 162, 931): on rough surfaces some do in most steps.
  void step() {
    const double keep = squares_before_ > 0 ? std::max(0.0, (squares_ - products_) / squares_before_) : 0.0;
    squares_before_ = squares_;
    Along along = turn_direction(keep);
    if (!(along.gap > 0)) along = turn_direction(0);
    double length = 1 / compliance_.of_one_cell();  // a longer step is always felt
    if (squares_ > 0) {
      compliance_.apply(direction_, response_);
      ++s_.convolutions;
      const auto sum = sums_over<3>(cells_, [&](std::size_t k, auto& sum) {
        if (is_free(k)) sum[0] += response_[k] * direction_[k], sum[1] += response_[k], sum[2] += 1;
      });
      const double stiffness = sum[0] - (load_.by_force ? sum[1] / sum[2] * along.direction : 0.0);
      if (stiffness > 0 && along.gap > 0) length = along.gap / stiffness;
    } else if (!load_.by_force) {
      length = length_of_overlap(length);
    }
    move(length);
  }

  /// Of a step by the overlap of cells that do not press yet, which are together far stiffer to press than
  /// each alone; `otherwise` where there are none.
  double length_of_overlap(double otherwise) {
    for (std::size_t k = 0; k < cells_; ++k) direction_[k] = p_[k] == 0 ? std::min(0.0, open_[k]) : 0.0;
    compliance_.apply(direction_, response_);
    ++s_.convolutions;
    const auto sum = sums_over<2>(cells_, [&](std::size_t k, auto& sum) {
      sum[0] += direction_[k] * direction_[k], sum[1] += response_[k] * direction_[k];
    });
    std::fill(direction_.begin(), direction_.end(), 0.0);
    return sum[1] > 0 ? sum[0] / sum[1] : otherwise;
  }

  void move(double length) {
    const auto counts = sums_over<2>(cells_, [&](std::size_t k, auto& count) {
      double& p = p_[k];
      if (is_free(k)) {
        const double wanted = p - length * direction_[k];
        p = std::min(hardness_, std::max(0.0, wanted));
        count[0] += p != wanted;
      } else if ((p == 0) == (open_[k] < 0) && open_[k] != 0) {
        p = std::min(hardness_, std::max(0.0, p - length * open_[k]));
        count[1] += 1;
      }
    });
    const double scale = load_.by_force ? fit_to_force() : 1.0;
    constexpr int most_steps_without = 20;  // what rounding adds up in is computed anew
    if (counts[0] + counts[1] > 0 || scale == 0 || ++steps_without_ > most_steps_without) return displace();
    for_entries(static_cast<int>(cells_), [this, scale, length](int k) {
      displacement_[k] = scale * (displacement_[k] - length * response_[k]);
    });
  }

  /// Scales the pressures between the bounds to the given force. The factor of all pressures; 0 where it is
  /// not the same for all.
  double fit_to_force() {
    const double wanted = load_.value / compliance_.grid().cell_area();
    double factor = 1;
    for (;;) {  // each round puts cells at their bound, or is the last
      const auto sum =
          sums_over<2>(cells_, [&](std::size_t k, auto& sum) { sum[p_[k] < hardness_ ? 0 : 1] += p_[k]; });
      if (!(sum[0] + sum[1] > 0)) {
        add_the_nearest(wanted);
        return 0;
      }
      const bool all = sum[1] == 0 || sum[1] >= wanted || !(sum[0] > 0);
      const double scale = all ? wanted / (sum[0] + sum[1]) : (wanted - sum[1]) / sum[0];
      const double clipped = sums_over<1>(cells_, [&](std::size_t k, auto& sum) {
        if (!all && p_[k] >= hardness_) return;
        p_[k] *= scale;
        if (p_[k] > hardness_) p_[k] = hardness_, sum[0] += 1;
      })[0];
      factor = all && clipped == 0 && factor != 0 ? factor * scale : 0;
      if (clipped == 0) break;
      if (!(sum[0] > 0)) {
        add_the_nearest(wanted - sum[1]);
        break;
      }
    }
    return factor;
  }

  /// Where all that presses is at its bound and carries too little: as many cells more as it takes, those
  /// with the smallest gaps. missing: sum of their pressures.
  void add_the_nearest(double missing) {
    const Field& gap = displacement_.empty() ? gap_ : open_;
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < cells_; ++k)
      if (p_[k] == 0) open.push_back(k);
    const auto needed = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(missing / hardness_)));
    const auto count = std::min(open.size(), needed);
    const auto end = open.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(open.begin(), end, open.end(),
                      [&](std::size_t a, std::size_t b) { return gap[a] < gap[b]; });
    for (auto k = open.begin(); k != end; ++k) p_[*k] = missing / static_cast<double>(count);
  }

  const Compliance& compliance_;
  const Field& gap_;
  const NormalLoad load_;
  const double hardness_;
  const std::size_t cells_;
  NormalContactSolution& s_;
  Field &p_, &open_;
  Field displacement_, direction_, response_;
  double squares_ = 0, squares_before_ = 0, products_ = 0;
  int steps_without_ = 0;
};

}  // namespace

void iterate(const Compliance& compliance, const Field& gap, const NormalLoad& load,
             const NormalContactOptions& options, NormalContactSolution& solution) {
  solution.gap.assign(gap.size(), 0.0);
  BoundedGradients(compliance, gap, load, options, solution).run(options);
}

}  // namespace asperity::half_space
