#include "half_space/partial_slip.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/threads.h"

namespace asperity::half_space {
namespace {

double product(const Shears& a, const Shears& b) {
  return sums_over<1>(a.x.size(),
                      [&](std::size_t k, auto& sum) { sum[0] += a.x[k] * b.x[k] + a.y[k] * b.y[k]; })[0];
}

/// The largest eigenvalue of the compliance among the cells that touch, by powers; a twentieth more.
double largest_eigenvalue(const StuckContact& contact, const Field& limit) {
  const std::size_t cells = limit.size();
  Shears vector{Field(cells, 0.0), Field(cells, 0.0)}, image;
  for (std::size_t k = 0; k < cells; ++k) vector.x[k] = limit[k] > 0;
  double value = 0;
  constexpr int rounds = 12;
  constexpr double margin = 1.05;
  for (int n = 0; n < rounds; ++n) {
    const double length = std::sqrt(product(vector, vector));
    if (length == 0) return 0;
    for (std::size_t k = 0; k < cells; ++k) vector.x[k] /= length, vector.y[k] /= length;
    contact.apply(vector, image);
    for (std::size_t k = 0; k < cells; ++k)
      if (!(limit[k] > 0)) image.x[k] = image.y[k] = 0;
    value = std::sqrt(product(image, image));
    std::swap(vector, image);
  }
  return margin * value;
}

}  // namespace

PartialSlip::PartialSlip(const StuckContact& contact, Field limit)
    : contact_(contact), limit_(std::move(limit)) {
  const Grid& grid = contact_.grid();
  if (limit_.size() != grid.cells())
    throw InputError("partial slip needs a limit of the shear traction for each cell");
  for (const double value : limit_) {
    if (!(value >= 0) || !std::isfinite(value))
      throw InputError("partial slip needs finite limits of the shear traction of 0 or more");
    full_slip_ += value * grid.cell_area();
  }
  const double largest = largest_eigenvalue(contact_, limit_);
  step_ = largest > 0 ? 1 / largest : 0;
}

SlipState PartialSlip::at_rest() const {
  const std::size_t cells = limit_.size();
  const Shears nothing{Field(cells, 0.0), Field(cells, 0.0)};
  SlipState state;
  state.traction = state.slip = nothing;
  return state;
}

void PartialSlip::project(Shears& traction) const {
  for_entries(static_cast<int>(limit_.size()), [&](int k) {
    const double length = std::hypot(traction.x[k], traction.y[k]);
    const double scale = length <= limit_[k] ? 1 : length > 0 ? limit_[k] / length : 0;
    traction.x[k] *= scale, traction.y[k] *= scale;
  });
}

SlipState PartialSlip::shifted(const SlipState& before, double x, double y) const {
  constexpr int most_iterations = 5000;
  constexpr double close = 1e-7;  // change of the tractions in one step, of all of them
  const std::size_t cells = limit_.size();
  SlipState state = before;
  Shears moved = state.traction, image, last;
  double momentum = 1;
  for (state.iterations = 0;; ++state.iterations) {
    if (state.iterations == most_iterations)
      throw WorkError("the partial slip of the half-space contact is not found after " +
                      std::to_string(most_iterations) + " iterations; take a coarser grid");
    contact_.apply(moved, image);
    last = state.traction;
    for_entries(static_cast<int>(cells), [&](int k) {
      state.traction.x[k] = moved.x[k] + step_ * (x - before.slip.x[k] - image.x[k]);
      state.traction.y[k] = moved.y[k] + step_ * (y - before.slip.y[k] - image.y[k]);
    });
    project(state.traction);
    const auto sums = sums_over<3>(cells, [&](std::size_t k, auto& sum) {
      const double dx = state.traction.x[k] - last.x[k], dy = state.traction.y[k] - last.y[k];
      sum[0] += dx * dx + dy * dy;
      sum[1] += limit_[k] * limit_[k];
      // Gradient times step: against the way means that the momentum has gone too far.
      sum[2] += (moved.x[k] - state.traction.x[k]) * dx + (moved.y[k] - state.traction.y[k]) * dy;
    });
    if (sums[0] <= close * close * sums[1]) break;
    const double next = sums[2] > 0 ? 1 : 0.5 * (1 + std::sqrt(1 + 4 * momentum * momentum)),
                 keep = sums[2] > 0 ? 0 : (momentum - 1) / next;
    for_entries(static_cast<int>(cells), [&](int k) {
      moved.x[k] = state.traction.x[k] + keep * (state.traction.x[k] - last.x[k]);
      moved.y[k] = state.traction.y[k] + keep * (state.traction.y[k] - last.y[k]);
    });
    momentum = next;
  }
  measure(state, before, x, y);
  return state;
}

void PartialSlip::measure(SlipState& state, const SlipState& before, double x, double y) const {
  Shears image;
  contact_.apply(state.traction, image);
  constexpr double at_limit = 1 - 1e-9;
  for (std::size_t k = 0; k < limit_.size(); ++k) {
    const bool touches = limit_[k] > 0,
               slips =
                   touches && std::hypot(state.traction.x[k], state.traction.y[k]) >= at_limit * limit_[k];
    state.slip.x[k] = slips ? x - image.x[k] : before.slip.x[k];
    state.slip.y[k] = slips ? y - image.y[k] : before.slip.y[k];
  }
  const auto sums = sums_over<5>(limit_.size(), [&](std::size_t k, auto& sum) {
    sum[0] += state.traction.x[k], sum[1] += state.traction.y[k];
    sum[2] += state.traction.x[k] * (state.slip.x[k] - before.slip.x[k]) +
              state.traction.y[k] * (state.slip.y[k] - before.slip.y[k]);
    if (!(limit_[k] > 0)) return;
    sum[3] += 1;
    sum[4] += std::hypot(state.traction.x[k], state.traction.y[k]) >= at_limit * limit_[k];
  });
  const double cell = contact_.grid().cell_area();
  state.force_x = sums[0] * cell, state.force_y = sums[1] * cell;
  state.dissipated = before.dissipated + sums[2] * cell;
  state.slipping = sums[3] > 0 ? sums[4] / sums[3] : 0;
}

}  // namespace asperity::half_space
