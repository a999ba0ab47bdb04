#include "dem_compare/numbers/uncertain.h"

namespace asperity {

Uncertain operator+(const Uncertain& a, const Uncertain& b) {
  return {a.value + b.value, std::hypot(a.sd, b.sd)};
}
Uncertain operator-(const Uncertain& a, const Uncertain& b) {
  return {a.value - b.value, std::hypot(a.sd, b.sd)};
}
Uncertain operator*(const Uncertain& a, double factor) { return {a.value * factor, a.sd * std::abs(factor)}; }

Uncertain ratio(const Uncertain& a, const Uncertain& b) {
  const double value = a.value / b.value;
  return {value, std::hypot(a.sd / b.value, value * b.sd / b.value)};
}

Uncertain propagate(const std::function<double(const std::vector<double>&)>& f,
                    const std::vector<Uncertain>& inputs) {
  constexpr double share_of_sd =
      1e-3;  // of a central difference: slopes at the inputs, not over the whole scatter
  std::vector<double> at;
  for (const auto& input : inputs) at.push_back(input.value);
  Uncertain result{f(at)};
  double variance = 0;
  bool any = false;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!inputs[i].has_sd() || inputs[i].sd == 0) continue;
    any = true;
    const double step = share_of_sd * inputs[i].sd;
    std::vector<double> up = at, down = at;
    up[i] += step;
    down[i] -= step;
    const double change = (f(up) - f(down)) / (2 * share_of_sd);
    variance += change * change;
  }
  if (any) result.sd = std::sqrt(variance);
  return result;
}

double deviation_in_sigma(const Uncertain& computed, const Uncertain& published) {
  return (computed.value - published.value) / published.sd;
}

double deviation_in_both_sigmas(const Uncertain& computed, const Uncertain& published) {
  const double own = computed.has_sd() ? computed.sd : 0;
  return (computed.value - published.value) / std::hypot(own, published.sd);
}

}  // namespace asperity
