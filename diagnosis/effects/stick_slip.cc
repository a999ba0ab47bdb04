// Saw-tooth of slip events during sliding: after each event the force is lower by A and is built up again
// over the period p:
//   |f_l| <= mu f_n + A [frac(phase) - 1/2],  d phase/d s = 1/p on the mean.
// Where events begin no law says (after a reversal, between defects, by chance): the phase is read off the
// recording in windows of three periods (sliding_trace.h), each of which counts as a parameter that the
// window's samples tell. Where there is no recording, events are counted from the middle of the stroke.
#include <algorithm>
#include <cmath>
#include <complex>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

/// A residual along the direction of motion, at a path since the reversal where the contact slides
/// everywhere.
struct SlidingPoint {
  double s, r;
  int part;
};

constexpr double settled = SlidingTrace::settled;

/// Without the mean of each part.
std::vector<SlidingPoint> sliding_points(const Samples& samples, const std::vector<double>& residual) {
  constexpr std::size_t most_points = 6000;
  std::vector<double> longest(static_cast<std::size_t>(samples.parts), 0.0);
  for (const auto& s : samples.list)
    longest[static_cast<std::size_t>(s.part)] =
        std::max(longest[static_cast<std::size_t>(s.part)], s.since_reversal);
  std::vector<SlidingPoint> points;
  for (std::size_t i = 0; i < samples.list.size() && points.size() < most_points; ++i) {
    const Sample& s = samples.list[i];
    if (!s.counts || s.since_reversal < settled * longest[static_cast<std::size_t>(s.part)]) continue;
    points.push_back({s.since_reversal, residual[i] * s.direction, s.part});
  }
  for (std::size_t from = 0, to = 0; from < points.size(); from = to) {
    double sum = 0;
    while (to < points.size() && points[to].part == points[from].part) sum += points[to++].r;
    for (std::size_t i = from; i < to; ++i) points[i].r -= sum / static_cast<double>(to - from);
  }
  return points;
}

std::size_t most_in_one_part(const std::vector<SlidingPoint>& points) {
  std::size_t in_part = 1, most = 1;
  for (std::size_t i = 1; i < points.size(); ++i) {
    in_part = points[i].part == points[i - 1].part ? in_part + 1 : 1;
    most = std::max(most, in_part);
  }
  return most;
}

/// Amplitude of the wave of `frequency` [1/m] in the points, the phase of each part its own.
double amplitude_at(double frequency, const std::vector<SlidingPoint>& points) {
  std::complex<double> sum = 0;
  double power = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double angle = 2 * M_PI * frequency * points[i].s;
    sum += points[i].r * std::complex<double>(std::cos(angle), std::sin(angle));
    ++count;
    if (i + 1 == points.size() || points[i + 1].part != points[i].part) {
      power += std::norm(sum) / static_cast<double>(count);
      sum = 0;
      count = 0;
    }
  }
  return 2 * std::sqrt(power / static_cast<double>(points.size()));
}

/// Periods that stand out in the residuals along the path since the reversal, the strongest first, with their
/// amplitudes.
std::vector<std::pair<double, double>> strongest_periods(const Samples& samples,
                                                         const std::vector<double>& residual) {
  const std::vector<SlidingPoint> points = sliding_points(samples, residual);
  double stroke = 0;
  for (const auto& point : points) stroke = std::max(stroke, point.s);
  if (points.size() < 20 || stroke <= 0) return {};
  const double path = (1 - settled) * stroke, step = 1 / (4 * stroke);
  const double highest =
      0.4 * static_cast<double>(most_in_one_part(points)) / path;  // cycles per metre the sampling can hold
  std::vector<std::pair<double, double>> found;                    // amplitude, frequency
  double before = 0, at = 0;
  for (double f = 2 / path; f < highest; f += step) {
    const double now = amplitude_at(f, points);
    if (at > before && at >= now) found.push_back({at, f - step});
    before = at;
    at = now;
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::pair<double, double>> periods;
  for (const auto& [amplitude, frequency] : found) {
    if (periods.size() == 3) break;
    periods.push_back({1 / frequency, amplitude});
  }
  return periods;
}

/// Part of a period by which events come earlier or later than the phase in a window says: samples, and
/// distances that scatter by a few percent.
constexpr double uncertainty_of_phase = 0.07;

/// frac - 1/2, as it is on the mean where the event lies anywhere within +- `uncertainty` of its phase:
/// otherwise a fit would take drops that come at another sample for smaller ones.
double saw_tooth(double part, double uncertainty) {
  const double from_event = part < 0.5 ? part : part - 1;
  if (std::abs(from_event) >= uncertainty) return part - 0.5;
  return from_event * (1 - 0.5 / uncertainty);
}

class StickSlip : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "stick_slip",
        "Stick-slip",
        "|f_l| <= mu f_n + A [frac(s/p + phase) - 1/2], the phase read off the recording",
        "Bowden & Leben 1939; Tomlinson 1929; Mate et al. 1987",
        "Sliding goes in jumps: force builds up while the contact sticks and drops when it slips. Where "
        "events "
        "begin is read off the recording, also where data are kept out of the fit; their size and distance "
        "are "
        "predicted.",
        EffectKind::contact,
        {Motion::sliding},
        {},
        {},
        3,
        false,
        0.3};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_trace; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double f = e.largest_response, path = e.stroke;
    EffectParameter period{"period", "m",         "p, path between events", 1e-4 * path, 0.5 * path,
                           true,     {0.1 * path}};
    period.off_by = 0.01;  // 26 recordings of challenges: 0.3 % root mean square, 0.7 % at most
    return {{"amplitude", "N", "A, drop of the force in an event", 1e-4 * f, 2 * f, true, {0.1 * f}}, period};
  }
  /// A wave that rises as it falls is an oscillation: of the force in time, of the instrument.
  bool is_itself(const Experiment& e, const double* p) const override {
    constexpr double clearly = 8;  // in log evidence
    if (!e.sliding_trace) return true;
    const auto as_saw_tooth = [](double phase) { return saw_tooth(phase, uncertainty_of_phase); };
    const auto as_sine = [](double phase) { return -std::sin(2 * M_PI * phase); };
    return e.sliding_trace->log_likelihood(p[1], as_sine) <
           e.sliding_trace->log_likelihood(p[1], as_saw_tooth) + clearly;
  }
  double numbers_read_off(const Experiment& e, const double* p) const override {
    return e.sliding_trace ? e.sliding_trace->windows(p[1]) : 0;
  }
  std::vector<EffectStart> starts(const Samples& samples,
                                  const std::vector<double>& residual) const override {
    std::vector<EffectStart> list;
    for (const auto& [period, amplitude] : strongest_periods(samples, residual))
      list.push_back({M_PI * amplitude, period});  // a saw-tooth's first harmonic is A/pi
    return list;
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.mode == Motion::sliding ? EntersBy::on_friction : EntersBy::reduced_law_only;
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double drop = p[0], period = p[1], middle = 0.5 * m.experiment.stroke;
    std::vector<double> phases;
    if (m.experiment.sliding_trace) phases = m.experiment.sliding_trace->phases(period);
    m.lateral.limit_changes.push_back(
        [drop, period, middle, phases = std::move(phases)](double limit, const SlipState& s) {
          if (s.path <= 0) return limit;
          const bool is_read = s.sample && s.sample->index < phases.size();
          const double phase = is_read ? phases[s.sample->index] : (s.path - middle) / period;
          return limit + drop * saw_tooth(phase - std::floor(phase), is_read ? uncertainty_of_phase : 0);
        });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(stick_slip, StickSlip)
