// One pass through the recording: the assembled mechanics driven sample by sample.
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "diagnosis/mechanics/lateral_run.h"
#include "diagnosis/mechanics/mechanics.h"
#include "diagnosis/mechanics/scalar_root.h"

namespace asperity {
namespace {

class NormalRun {
 public:
  explicit NormalRun(const NormalMechanics& mechanics) : mechanics_(mechanics) {
    if (mechanics_.correction)
      if (auto solved = mechanics_.contact->solved_by(
              [&](const NormalContact& law) { return mechanics_.correction->contact_for(law); }))
        mechanics_.contact = std::move(solved);
    forget();
  }

  /// Restart without history: rows of a series.
  void forget() { contact_ = mechanics_.contact->clone(); }

  double force_at(const Sample& sample) {
    begin_step(sample);
    const double shifted = sample.normal_displacement - shift(sample);
    const double d = mechanics_.series.empty() && mechanics_.delays.empty() && !mechanics_.correction
                         ? shifted
                         : contact_displacement(shifted);
    accept(d);
    contact_->begin_step(0);  // the time of this step is over
    return reading(force(d) + addition(sample, sample.normal_displacement));
  }

  double displacement_at(const Sample& sample) {
    begin_step(sample);
    const double shifted = shift(sample);
    if (mechanics_.beside.empty() && mechanics_.additions.empty() && mechanics_.readings.empty()) {
      const double d = contact_->displacement(sample.normal_force);
      if (std::isfinite(d)) {
        step_ = d - last_;
        last_ = d;
        const double whole =
            d + series_under(sample.normal_force, sample.normal_force) + delayed(d) + shifted;
        accept(d);
        return whole;
      }
    }
    const auto whole = [&](double d) { return d + series(d) + delayed(d) + shifted; };
    const auto excess = [&](double d) {
      return reading(force(d) + addition(sample, whole(d))) - sample.normal_force;
    };
    // As far again as the last step went.
    const double root = increasing_root(excess, last_ + step_, std::max(smallest_step, 0.5 * std::abs(step_)),
                                        displacement_tolerance);
    // A law that cannot carry the force sends the search ever further, sample by sample.
    const double d = std::clamp(root, -farthest, farthest);
    step_ = d - last_;
    last_ = d;
    const double displacement = whole(d);
    accept(d);
    return displacement;
  }

 private:
  static constexpr double displacement_tolerance = 1e-14;  // [m], far below what any instrument resolves
  static constexpr double farthest = 1;                    // [m], where no contact is any more
  static constexpr double smallest_step = 1e-12;           // [m], in which a root is looked for

  void begin_step(const Sample& sample) {
    time_step_ = begun_ ? std::max(0.0, sample.time - time_) : 0;
    time_ = sample.time;
    begun_ = true;
    sample_ = &sample;
    contact_->begin_step(time_step_);
  }
  void accept(double d) {
    contact_->accept(d);
    for (auto& part : mechanics_.delays) part.accept(d, time_step_);
  }
  double delayed(double d) const {
    double sum = 0;
    for (const auto& part : mechanics_.delays) sum += part.after(d, time_step_);
    return sum;
  }
  double shift(const Sample& sample) {
    double sum = 0;
    for (auto& part : mechanics_.shifts) sum += part(sample);
    return sum;
  }
  /// Of the contact and what acts beside it.
  double force(double d) const {
    double sum = contact_->force(d);
    for (const auto& part : mechanics_.beside) sum += part(d);
    return sum;
  }
  /// Displacement in series with a contact displaced by d.
  double series(double d) const { return series_under(force(d), contact_->solved_force(d)); }
  /// The same under a force, and under the contact's own part of it, which finite elements solve for.
  double series_under(double force, double of_contact) const {
    double sum = 0;
    for (const auto& part : mechanics_.series) sum += part(force);
    if (mechanics_.correction) sum += mechanics_.correction->displacement(*sample_, of_contact);
    return sum;
  }
  double addition(const Sample& sample, double displacement) const {
    double sum = 0;
    for (const auto& part : mechanics_.additions) sum += part(sample, displacement);
    return sum;
  }
  double reading(double force) const {
    for (const auto& part : mechanics_.readings) force = part(force);
    return force;
  }
  /// Solves d + series(f(d)) + delayed(d) = given for the contact's own displacement d.
  double contact_displacement(double given) {
    const double free = given - delayed(0) - series_under(0, 0);
    const auto excess = [&](double d) { return d + series(d) + delayed(d) - given; };
    const double step = given - last_given_;
    last_given_ = given;
    last_ = free <= 0
                ? pulled_displacement(excess, free, step)
                : increasing_root(excess, std::min(last_ + step, given),
                                  std::max(smallest_step, 0.5 * std::abs(step)), displacement_tolerance);
    return last_;
  }
  /// Below first touch an attraction may hold, which the series draws out: until the whole displacement has
  /// its minimum, and the contact snaps to where it is free.
  template <class Excess>
  double pulled_displacement(const Excess& excess, double free, double step) const {
    const double release = contact_->release();
    if (!(release < 0 && contact_->force(release / 2) < 0)) return free;
    // The excess falls to its minimum and grows from there: a place where it is negative below one where it
    // is not encloses the state that is held. Only where none is near the last state is the minimum looked
    // for.
    double high = last_, f_high = excess(high);
    double low = high, f_low = f_high;
    const double near = std::max(smallest_step, std::abs(step));
    for (double width = near; f_high < 0; width *= 2) high += width, f_high = excess(high);
    constexpr int attempts = 4;
    double width = near;
    for (int i = 0; i < attempts && f_low >= 0 && low - width > release; ++i, width *= 2)
      low -= width, f_low = excess(low);
    if (f_low < 0) return root_between(excess, low, high, f_low, f_high, displacement_tolerance);
    constexpr int bits = 24;
    const auto at_part = [&](double part) { return excess(part * release) / -release; };  // of order one
    const double fold = release * boost::math::tools::brent_find_minima(at_part, 0.0, 1.0, bits).first;
    const double least = excess(fold);
    if (least >= 0) return free;
    return root_between(excess, fold, high, least, f_high, displacement_tolerance);
  }

  NormalMechanics mechanics_;
  std::unique_ptr<NormalContact> contact_;
  double last_ = 0, last_given_ = 0, step_ = 0, time_ = 0, time_step_ = 0;
  bool begun_ = false;
  const Sample* sample_ = nullptr;
};

}  // namespace

std::vector<double> simulate(const Mechanics& mechanics, const Samples& samples) {
  std::vector<double> response(samples.list.size(), 0.0);
  for (const auto& run : samples.runs) {
    if (mechanics.experiment.mode == Motion::normal) {
      NormalRun state(mechanics.normal);
      for (std::size_t i = run.begin; i < run.end; ++i) {
        if (run.independent_rows) state.forget();
        response[i] = run.response_is_displacement ? state.displacement_at(samples.list[i])
                                                   : state.force_at(samples.list[i]);
      }
      continue;
    }
    LateralRun state(mechanics);
    state.at_ = run.at;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const Sample& sample = samples.list[i];
      response[i] = run.independent_rows ? state.steady(sample)
                    : i == run.begin     ? state.first(sample, run.first_response)
                                         : state.next(sample);
    }
  }
  return response;
}

}  // namespace asperity
