// Load and unload of a sphere that yields on a rigid plane, by axisymmetric finite elements of another
// program (references/02_elastoplastic_table_*), nu = 0.17. SI units.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/csv.h"
#include "core/hertz.h"
#include "tests/support/shared_files.h"

namespace asperity::test {

class TabulatedYielding {
 public:
  static constexpr double poisson = 0.17;

  explicit TabulatedYielding(double yield, double radius = 8.5e-6, double youngs_modulus = 71e9) {
    const double factor = 1.295 * std::exp(0.736 * poisson), pi = std::acos(-1);
    bodies_ = {reduced_modulus({youngs_modulus, poisson}, {1e15, 0.3}), radius};
    approach_ = std::pow(pi * factor * yield / (2 * bodies_.reduced_modulus), 2) * radius;
    force_ = bodies_.force(approach_);
    const CsvTable table = read_csv(reference_table("02_elastoplastic_table_ownFE.csv")),
                   unloading = read_csv(reference_table("02_elastoplastic_table_unloading.csv"));
    w_ = table.numbers("w/wc");
    f_ = table.numbers("F/Fc_nu0.17");
    peak_ = unloading.numbers("w_max/wc"), left_ = unloading.numbers("w_res/w_max_ownFE");
    exponent_ = unloading.numbers("unloading_exponent_fit_ownFE");
  }
  const Hertz& bodies() const { return bodies_; }
  double approach_at_yield() const { return approach_; }
  /// On first loading; straight in F^(2/3) between the table's rows.
  double loading(double d) const {
    const double depth = d / approach_;
    if (depth <= w_.front()) return force_ * std::pow(depth, 1.5);
    std::size_t k = 1;
    while (w_[k] < depth) ++k;
    const double part = (depth - w_[k - 1]) / (w_[k] - w_[k - 1]), low = std::pow(f_[k - 1], 2.0 / 3);
    return force_ * std::pow(low + part * (std::pow(f_[k], 2.0 / 3) - low), 1.5);
  }
  /// Largest approach of a row of the table of unloadings, and what of it stays.
  double peak(std::size_t row) const { return peak_.at(row) * approach_; }
  double left(std::size_t row) const { return left_.at(row) * peak(row); }
  double unloading(double d, std::size_t row) const {
    const double part = (d - left(row)) / (peak(row) - left(row));
    return part > 0 ? loading(peak(row)) * std::pow(part, exponent_.at(row)) : 0.0;
  }

 private:
  Hertz bodies_;
  double approach_ = 0, force_ = 0;
  std::vector<double> w_, f_, peak_, left_, exponent_;
};

}  // namespace asperity::test
