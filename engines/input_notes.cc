#include "engines/input_notes.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/printed.h"
#include "core/shear_moduli.h"
#include "engines/needed_cases.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

std::string signed_percent(double error) { return printed("%+.1f %%", 100 * error); }

std::string short_number(double value) { return printed("%.4g", value); }

}  // namespace

InputNotes::InputNotes(const ContactParameters& parameters, const EngineInputOptions& options,
                       std::string engine)
    : p_(parameters), options_(options), engine_(std::move(engine)) {
  if (options.load && !(*options.load > 0))
    throw InputError("the load at which the limits are to be right must be above zero");
  std::string needed;
  bool is_refused = false;
  for (const auto& missing : needed_cases(p_)) {
    needed += (needed.empty() ? "" : "; ") + to_text(missing);
    is_refused = is_refused || missing.is_required;
    if (!missing.is_required) left_out_.push_back(to_text(missing));
  }
  if (is_refused)
    throw InputError(p_.file + ": " + engine_ + " still needs " + needed +
                     "; solve these for the same contact and run 'asperity derive' over their folders and "
                     "those solved before");
}

LoadRange InputNotes::range(Member friction, Member offset) const {
  if (const auto found = p_.load_range(friction, offset)) return *found;
  if (options_.load) return {*options_.load, *options_.load};
  const bool depends_on_load = (p_.*offset && (p_.*offset)->value != 0) ||
                               (p_.*friction && (p_.*friction)->length_scale == LengthScale::contact_radius);
  if (depends_on_load)
    throw InputError(p_.file +
                     ": a limit depends on the load and has no load_range; give the load at which it shall "
                     "be right with --load");
  return {1, 1};  // the same at every load
}

void InputNotes::state(const std::string& what, const Folded& folded) {
  if (folded.is_exact()) return;
  std::string text =
      what + ": " + signed_percent(folded.error_low) + " at " + short_number(folded.range.low) + " N";
  if (folded.range.high > folded.range.low)
    text += ", " + signed_percent(folded.error_high) + " at " + short_number(folded.range.high) + " N";
  if (options_.load && (*options_.load < folded.range.low || *options_.load > folded.range.high))
    text += "; " + short_number(*options_.load) + " N lies outside of the loads it was fitted on";
  limits_.push_back(text);
}

double InputNotes::limit(const std::string& mode, Member friction, Member offset, const OfLoad& record) {
  const EffectiveQuantity& mu = *(p_.*friction);
  const double h = p_.*offset ? (p_.*offset)->value : 0;
  const Folded folded = fold(
      record, [](double load) { return load; }, range(friction, offset), options_.load);
  std::string why;
  if (h != 0)
    why = "whose offset h = " + short_number(h) +
          " N has no place of its own and is folded into the coefficient";
  if (mu.length_scale == LengthScale::contact_radius)
    why += std::string(why.empty() ? "" : " and ") +
           "whose length scale grows with the contact radius and is fixed here";
  const std::string what = mode + " limit" + (why.empty() ? "" : ", " + why);
  state(what, folded);
  return folded.number;
}

double InputNotes::sliding() {
  return limit("sliding", &ContactParameters::sliding_friction, &ContactParameters::sliding_offset,
               [&](double load) { return p_.sliding_limit(load); });
}

double InputNotes::rolling() {
  return limit("rolling", &ContactParameters::rolling_friction, &ContactParameters::rolling_offset,
               [&](double load) { return p_.rolling_limit(load); });
}

double InputNotes::torsion() {
  return limit("torsion", &ContactParameters::torsion_friction, &ContactParameters::torsion_offset,
               [&](double load) { return p_.torsion_limit(load); });
}

double InputNotes::shear_modulus() {
  const Folded folded =
      fold([&](double load) { return p_.lateral_stiffness_at(load); },
           [&](double load) { return 8 * p_.contact_radius(load); },
           range(&ContactParameters::sliding_friction, &ContactParameters::sliding_offset), options_.load);
  state("lateral stiffness, which grows with the contact radius here", folded);
  return folded.number;
}

double InputNotes::constant_lateral_stiffness() {
  const Folded folded =
      fold([&](double load) { return p_.lateral_stiffness_at(load); }, [](double) { return 1.0; },
           range(&ContactParameters::sliding_friction, &ContactParameters::sliding_offset), options_.load);
  state("lateral stiffness, which is constant here", folded);
  return folded.number;
}

double InputNotes::constant_rolling_stiffness() {
  return rolling_stiffness_over([](double) { return 1.0; }, "which is constant here");
}

double InputNotes::rolling_stiffness_over(const OfLoad& k, const std::string& factor) {
  if (!p_.rolling_stiffness) {
    cannot("the record has no rolling_stiffness: rolling resistance is left out or without its spring");
    return 0;
  }
  const Folded folded =
      fold([&](double load) { return p_.rolling_stiffness_at(load); }, k,
           range(&ContactParameters::rolling_friction, &ContactParameters::rolling_offset), options_.load);
  state("rolling stiffness, " + factor, folded);
  return folded.number;
}

double InputNotes::constant_torsion_stiffness() {
  if (!p_.torsion_stiffness) {
    cannot("the record has no torsion_stiffness: torsion resistance is left out");
    return 0;
  }
  const Folded folded =
      fold([&](double load) { return p_.torsion_stiffness_at(load); }, [](double) { return 1.0; },
           range(&ContactParameters::torsion_friction, &ContactParameters::torsion_offset), options_.load);
  state("torsion stiffness, which is constant here", folded);
  return folded.number;
}

void InputNotes::rolling_stiffness_is(const OfLoad& engine, const std::string& law) {
  if (!p_.rolling_stiffness) return;
  state("rolling stiffness, which is " + law + " and cannot be set",
        unfoldable([&](double load) { return p_.rolling_stiffness_at(load); }, engine,
                   range(&ContactParameters::rolling_friction, &ContactParameters::rolling_offset)));
}

void InputNotes::torsion_stiffness_is(const OfLoad& engine, const std::string& law) {
  if (!p_.torsion_stiffness) return;
  state("torsion stiffness, which is " + law + " and cannot be set",
        unfoldable([&](double load) { return p_.torsion_stiffness_at(load); }, engine,
                   range(&ContactParameters::torsion_friction, &ContactParameters::torsion_offset)));
}

void InputNotes::meaning(const std::string& name, double value, const std::string& unit,
                         const std::string& text) {
  meanings_.push_back(name + " = " + text_number(value) + (unit.empty() ? "" : " " + unit) + ": " + text);
}

void InputNotes::cannot(const std::string& what) { limits_.push_back(what); }

void InputNotes::leaves_out_pull_off(const std::string& why) {
  if (p_.pull_off_force)
    cannot("pull-off force h_n = " + text_number(p_.pull_off_force->value) + " N: " + why + "; left out");
}

std::vector<std::string> InputNotes::not_expressed() const {
  std::vector<std::string> all = limits_;
  for (const auto& missing : left_out_) all.push_back("not in the record, left out: " + missing);
  return all;
}

std::vector<std::string> InputNotes::lines() const {
  std::vector<std::string> all;
  all.push_back("Written by asperity for " + engine_ + " from " + (p_.file.empty() ? "a record" : p_.file) +
                (p_.title.empty() ? "" : ": " + p_.title));
  all.push_back("Particle: " + particle_name() + "; target: " + target_name() + ".");
  all.push_back("SI units. Contact of a sphere, R = " + text_number(p_.particle.radius) + " m, with " +
                (p_.target.is_plane() ? "a plane" : "a sphere, R = " + text_number(p_.target.radius) + " m") +
                "; effective radius R_e = " + text_number(p_.effective_radius()) +
                " m. F is the normal force.");
  all.push_back(options_.load
                    ? "Limits that depend on the load are right at " + short_number(*options_.load) + " N."
                    : "Limits that depend on the load are as much too large at one end of the fitted loads "
                      "as too small at the other.");
  all.push_back("");
  for (const auto& line : meanings_) all.push_back("  " + line);
  if (!left_out_.empty()) {
    all.push_back("");
    all.push_back(
        "What the record does not hold and is left out, and the case that would tell 'asperity derive':");
    for (const auto& line : left_out_) all.push_back("  " + line);
  }
  all.push_back("");
  if (limits_.empty()) {
    all.push_back("All quantities of the record are expressed without error.");
  } else {
    all.push_back("What " + engine_ +
                  " cannot express, with the error of what it does instead, (engine - record)/record:");
    for (const auto& line : limits_) all.push_back("  " + line);
  }
  return all;
}

std::string InputNotes::particle_name() const {
  return p_.particle.material.empty() ? "particle" : p_.particle.material;
}

std::string InputNotes::target_name() const {
  const std::string name = p_.target.material.empty() ? "target" : p_.target.material;
  return name == particle_name() ? name + " (target)" : name;
}

std::string InputNotes::text(const CommentStyle& comment) const {
  std::string text;
  for (const auto& line : lines()) text += comment.line(line) + "\n";
  return text;
}

EngineElasticity engine_elasticity(InputNotes& notes) {
  constexpr double agree = 1e-3;
  const ContactParameters& p = notes.record();
  const double E = p.hertz().reduced_modulus, G = notes.shear_modulus();
  if (p.particle.has_elasticity() && p.target.has_elasticity()) {
    const ElasticBody particle{p.particle.youngs_modulus, p.particle.poissons_ratio},
        target{p.target.youngs_modulus, p.target.poissons_ratio};
    const double own_E = reduced_modulus(particle, target), own_G = reduced_shear_modulus(particle, target);
    if (std::abs(own_E / E - 1) < agree && std::abs(own_G / G - 1) < agree)
      return {{p.particle.youngs_modulus, p.target.youngs_modulus},
              {p.particle.poissons_ratio, p.target.poissons_ratio}};
  }
  // Two equal bodies: E* = E/(2 (1 - nu^2)), G* = E/(4 (1 + nu)(2 - nu)), so G*/E* = (1 - nu)/(2 (2 - nu)),
  // from 1/4 to 1/6.
  const double ratio = G / E, wanted = (1 - 4 * ratio) / (1 - 2 * ratio);
  constexpr double least = 0, most = 0.49;
  const double nu = ratio < 0.5 ? std::clamp(wanted, least, most) : least;
  const double Youngs = 2 * E * (1 - nu * nu), engine_G = Youngs / (4 * (1 + nu) * (2 - nu));
  if (std::abs(engine_G / G - 1) > agree)
    notes.cannot("lateral stiffness, which follows from E and nu here and cannot be as that of the record: " +
                 signed_percent(engine_G / G - 1) + " at every load");
  else
    notes.cannot(
        "E and nu are those of two equal bodies that have the record's E* and k_l: not those of the "
        "materials");
  return {{Youngs, Youngs}, {nu, nu}};
}

}  // namespace asperity
