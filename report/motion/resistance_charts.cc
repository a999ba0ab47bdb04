#include "report/motion/resistance_charts.h"

#include <cmath>

#include "dem_compare/cases/path_averages.h"
#include "report/page/colour_scale.h"
#include "report/page/display_units.h"
#include "report/page/words.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

constexpr int narrow = 520;
const std::string measured_colour = "#d55e00";

double divisor(const MovingContact& contact, const MovingState& state, ResistanceUnit unit) {
  switch (unit) {
    case ResistanceUnit::load:
      return state.load;
    case ResistanceUnit::contact:
      return state.load * state.hertz_radius;
    case ResistanceUnit::particle:
      return state.load * contact.bodies.radius;
    default:
      return state.coulomb;
  }
}

void add(Series& series, double x, const Uncertain& y) {
  series.x.push_back(x);
  series.y.push_back(y.value);
  series.error.push_back(y.sd);
}

ResistanceUnit own_unit(const MotionMode& mode) {
  return &mode == &sliding_mode() ? ResistanceUnit::load : ResistanceUnit::contact;
}

/// The paper's values, in the unit of the figure.
void add_measured(const RoughnessTrend& trend, const AgainstPublished& published, Chart& chart) {
  Series measured{"measured (Fuchs, Weinhart et al. 2014)", measured_colour, Series::Style::points};
  for (const auto& one : published.magnitudes) {
    if (one.mode != trend.mode ||
        std::find(trend.contacts.begin(), trend.contacts.end(), one.contact) == trend.contacts.end())
      continue;
    const MovingState* state = one.contact->find(*one.mode, one.load);
    const double length = one.mode == &sliding_mode() ? 1 : one.contact->bodies.radius;
    add(measured, one.contact->bodies.rms / nm, one.measured * (one.load * length / state->scale()));
  }
  if (!measured.x.empty()) chart.series.push_back(std::move(measured));
}

}  // namespace

std::string unit_label(const MotionMode& mode, ResistanceUnit unit) {
  if (unit == ResistanceUnit::load) return "lateral resistance / load";
  const std::string moment = &mode == &rolling_mode() ? "rolling moment" : "torsion moment";
  if (unit == ResistanceUnit::contact) return moment + " / (load · contact radius)";
  if (unit == ResistanceUnit::particle) return moment + " / (load · particle radius)";
  return moment + " / (3π/16 · µ · load · contact radius)";
}

Chart resistance_over_load(const MovingStudy& study, const MotionMode& mode, ResistanceUnit unit) {
  Chart chart{"load [µN]", unit_label(mode, unit)};
  chart.width = narrow;
  for (const auto& contact : study.contacts) {
    Series series{contact.label, line_colour(chart.series.size()), Series::Style::line_with_points};
    for (const auto* state : contact.of(mode)) {
      const double by = divisor(contact, *state, unit);
      if (std::isfinite(by) && by > 0) add(series, state->load / uN, state->resistance * (1 / by));
    }
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

Chart resistance_over_rms(const RoughnessTrend& trend, const AgainstPublished& published) {
  Chart chart{"RMS roughness of the plane [nm]", unit_label(*trend.mode, own_unit(*trend.mode))};
  chart.width = narrow;
  for (const auto& at : trend.loads) {
    Series series{in_units(at.load, Dimension::force), line_colour(chart.series.size()),
                  Series::Style::line_with_points};
    for (const auto* contact : trend.contacts)
      if (const MovingState* state = contact->find(*trend.mode, at.load))
        add(series, contact->bodies.rms / nm, state->resistance * (1 / state->scale()));
    chart.series.push_back(std::move(series));
  }
  add_measured(trend, published, chart);
  return chart;
}

Chart parts_over_rms(const RoughnessTrend& trend, const TrendAtLoad& at) {
  Chart chart{"RMS roughness of the plane [nm]", unit_label(*trend.mode, own_unit(*trend.mode))};
  chart.width = narrow;
  struct Part {
    std::string name;
    Uncertain ResistanceParts::*member;
  };
  for (const auto& part : {Part{"slip", &ResistanceParts::friction},
                           Part{bodies_dissipate_by(trend.contacts), &ResistanceParts::plastic},
                           Part{"bonds", &ResistanceParts::adhesion}}) {
    Series series{part.name, line_colour(chart.series.size()), Series::Style::line_with_points};
    bool any = false;
    for (const auto* contact : trend.contacts)
      if (const MovingState* state = contact->find(*trend.mode, at.load)) {
        const Uncertain value = state->parts.*part.member * (1 / state->scale());
        any = any || std::abs(value.value) > 0;
        add(series, contact->bodies.rms / nm, value);
      }
    if (any) chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace asperity::report
