#include "dem_compare/resistance/length_answer.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/cases/case_numbers.h"

namespace asperity {
namespace {

using Contacts = std::vector<const MovingContact*>;

bool differ_by_radius(const MovingContact& one, const MovingContact& other) {
  const auto differ = differing_inputs(one, other);
  return differ.size() == 1 && differ.front() == "Particle/Radius";
}

ScalingExponent over_loads(const MovingContact& contact, const MotionMode& mode) {
  std::vector<double> loads;
  std::vector<Uncertain> moments;
  for (const auto* state : contact.of(mode))
    loads.push_back(state->load), moments.push_back(state->resistance);
  constexpr double four_thirds = 4.0 / 3.0;
  return {"load", contact.label, fit_exponent_of(loads, moments),
          1,      four_thirds,   &mode == &rolling_mode() ? 1.0 / 3.0 : NAN};
}

/// One exponent for each load that several radii have.
std::vector<ScalingExponent> over_radii(const Contacts& contacts, const MotionMode& mode) {
  std::vector<ScalingExponent> exponents;
  for (const auto* lead : contacts.front()->of(mode)) {
    std::vector<double> radii;
    std::vector<Uncertain> moments;
    for (const auto* contact : contacts)
      if (const MovingState* state = contact->find(mode, lead->load))
        radii.push_back(contact->bodies.radius), moments.push_back(state->resistance);
    if (radii.size() < 2) continue;
    constexpr double third = 1.0 / 3.0;
    exponents.push_back({"radius", format_quantity(lead->load, Dimension::force),
                         fit_exponent_of(radii, moments), 1, third,
                         &mode == &rolling_mode() ? 1 + third : NAN});
  }
  return exponents;
}

/// Contacts whose moment is known to be positive.
std::vector<ResistancePoint> points_of(const Contacts& contacts, const MotionMode& mode) {
  std::vector<ResistancePoint> points;
  for (const auto* contact : contacts)
    for (const auto* state : contact->of(mode))
      for (const auto& item : state->cases) {
        const Uncertain moment = item.first.resistance();
        constexpr double two_sigma = 2;
        if (moment.has_sd() && moment.value > two_sigma * moment.sd)
          points.push_back({item.load, moment.value, moment.sd,
                            item.seeds + " at " + format_quantity(contact->bodies.radius, Dimension::length),
                            contact->bodies.radius, state->hertz_radius});
      }
  return points;
}

constexpr double contradicts = 3;  // standard deviations

/// Root mean square of the relative sds: what a law that holds may miss the points by.
double half_width_of(const std::vector<ResistancePoint>& points) {
  double squares = 0;
  for (const auto& point : points)
    squares += std::pow(point.sd / point.value, 2) / static_cast<double>(points.size());
  return std::sqrt(squares);
}

/// A law with whatever offset cannot be: an exponent in the radius, or its misfit, is too far off.
bool is_contradicted(const LengthAnswer& answer, bool by_contact,
                     const std::vector<ResistancePoint>& points) {
  for (const auto& exponent : answer.exponents)
    if (exponent.over == "radius" &&
        std::abs(by_contact ? exponent.from_contact() : exponent.from_radius()) > contradicts)
      return true;
  const ResistanceLaw& law = by_contact ? answer.choice->with_contact : answer.choice->with_radius;
  return law.degrees_of_freedom > 0 && law.misfit > contradicts * half_width_of(points);
}

LengthAnswer::Verdict judge(const LengthAnswer& answer, const std::vector<ResistancePoint>& points) {
  using Verdict = LengthAnswer::Verdict;
  if (!answer.choice) return Verdict::cannot_tell;
  const bool is_contact = answer.choice->log_odds > 0, against = is_contradicted(answer, is_contact, points);
  if (against && (answer.choice->is_told() || is_contradicted(answer, !is_contact, points)))
    return Verdict::neither;
  if (!answer.choice->is_told()) return Verdict::cannot_tell;
  return is_contact ? Verdict::contact_radius : Verdict::particle_radius;
}

}  // namespace

LengthAnswer::Verdict LengthAnswer::without_offset() const {
  bool against_radius = false, against_contact = false;
  for (const auto& exponent : exponents) {
    against_radius = against_radius || std::abs(exponent.from_radius()) > contradicts;
    against_contact = against_contact || std::abs(exponent.from_contact()) > contradicts;
  }
  if (against_radius == against_contact) return against_radius ? Verdict::neither : Verdict::cannot_tell;
  return against_radius ? Verdict::contact_radius : Verdict::particle_radius;
}

std::vector<LengthAnswer> length_answers(const MovingStudy& study) {
  std::vector<LengthAnswer> answers;
  std::vector<const MovingContact*> seen;
  for (const auto& lead : study.contacts) {
    if (std::count(seen.begin(), seen.end(), &lead)) continue;
    Contacts family{&lead};
    for (const auto& other : study.contacts)
      if (&other != &lead && differ_by_radius(lead, other)) family.push_back(&other), seen.push_back(&other);
    for (const MotionMode* mode : {&rolling_mode(), &torsion_mode()}) {
      Contacts moved;
      for (const auto* contact : family)
        if (!contact->of(*mode).empty()) moved.push_back(contact);
      if (moved.empty()) continue;
      LengthAnswer answer;
      answer.mode = mode;
      answer.contact = moved.front()->label;
      for (const auto* contact : moved) {
        answer.radii.push_back(contact->bodies.radius);
        if (contact->of(*mode).size() > 1) answer.exponents.push_back(over_loads(*contact, *mode));
      }
      for (auto& exponent : over_radii(moved, *mode)) answer.exponents.push_back(std::move(exponent));
      if (answer.exponents.empty()) continue;
      const auto points = points_of(moved, *mode);
      if (points.size() > 1) answer.choice = choose_length(points);
      answer.verdict = judge(answer, points);
      answers.push_back(std::move(answer));
    }
  }
  return answers;
}

}  // namespace asperity
