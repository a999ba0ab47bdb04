#include "paper/published_column.h"

#include "paper/analysis.h"

namespace asperity {
namespace {

constexpr double micro = 1e-6;
constexpr LoadRange sliding_loads{3 * micro, 100 * micro};     // sec. 2.3
constexpr LoadRange rolling_loads{100 * micro, 3000 * micro};  // sec. 2.4

bool within(double load, const LoadRange& range) {
  constexpr double rounding = 1e-6;
  return load >= range.low * (1 - rounding) && load <= range.high * (1 + rounding);
}

std::string loads_text(const LoadRange& range) {
  return format_quantity(range.low, Dimension::force) + " to " +
         format_quantity(range.high, Dimension::force);
}

ComparedValue measured(const Uncertain& number, const std::string& source) {
  return {number.value, number.sd, "Fuchs, Weinhart et al. 2014, " + source, ""};
}

ComparedContact sphere_on(const Published& published, const char* plane) {
  ComparedContact own;
  own.particle = published.particle().elasticity;
  own.plane = published.body(plane).elasticity;
  own.radius = published.radius();
  return own;
}

/// mu (1 + h/f)
Uncertain over_load(const Uncertain& coefficient, const Uncertain& offset, double load) {
  return propagate([load](const std::vector<double>& x) { return x[0] * (1 + x[1] / load); },
                   {coefficient, offset});
}

}  // namespace

std::string PublishedColumn::plane_of(const ComparedContact& contact) const {
  for (const char* plane : {"silicon", "fused quartz"})
    if (same_bodies(contact, sphere_on(published_, plane))) return plane;
  return "";
}

const PublishedSurface* PublishedColumn::surface_of(const ComparedContact& contact) const {
  const PublishedSurface* surface = nullptr;
  for (const auto& one : published_.surfaces)
    if (std::abs(one.rms.value - contact.rms) <= one.rms.sd) surface = &one;
  return surface;
}

bool PublishedColumn::is_with_indenter(const ComparedContact& contact) const {
  return same_bodies(contact, sphere_on(published_, "diamond"));
}

ComparedValue PublishedColumn::value(Quantity quantity, const ComparedContact& contact, double load) const {
  const std::string plane = plane_of(contact);
  if (plane.empty()) return absent("these bodies were not measured in the paper");
  if (quantity == Quantity::approach || quantity == Quantity::normal_stiffness) {
    if (plane == "silicon") return absent("the paper shows normal loading on silica only");
    const Hertz fit{published_.hertz(plane).reduced_modulus,
                    published_.quoted("hertz_fit_radius", Dimension::length).value};
    return measured({quantity == Quantity::approach ? fit.approach(load) : fit.normal_stiffness(load)},
                    "sec. 4.2: Hertz with the fitted R = 9 um");
  }
  if (plane != "silicon") return absent("the paper measured this mode on silicon");
  if (quantity == Quantity::rolling_stiffness || quantity == Quantity::torsion_stiffness)
    return absent("not measured in the paper");
  if (quantity == Quantity::torsion_friction)
    return within(load, rolling_loads) ? measured(published_.quoted("torsion_r"),
                                                  "Table 2, from the rails (RMS 2.5 to 4.8 nm), lambda = r")
                                       : absent("measured at loads of " + loads_text(rolling_loads));
  if (quantity == Quantity::lateral_stiffness_to_sliding)
    return absent("the paper fits one stiffness to its loop: see that from rest");

  const PublishedSurface* surface = surface_of(contact);
  if (!surface)
    return absent(std::isnan(contact.rms)
                      ? "the substrate's RMS is not known"
                      : "no surface of " +
                            (contact.rms > 0 ? "RMS " + format_quantity(contact.rms, Dimension::length)
                                             : std::string("zero roughness")) +
                            " was measured");
  switch (quantity) {
    case Quantity::lateral_stiffness: {
      const double loop = published_.quoted("loop_load", Dimension::force).value;
      constexpr double same_load = 0.01;
      if (surface != &published_.surfaces.front() || std::abs(load / loop - 1) > same_load)
        return absent("measured at " + format_quantity(loop, Dimension::force) +
                      " on untreated silicon only");
      return measured(published_.quoted("fitted_lateral_stiffness", Dimension::stiffness),
                      "sec. 4.4: slope fitted to the loop");
    }
    case Quantity::sliding_friction:
      return within(load, sliding_loads)
                 ? measured(over_load(surface->sliding, surface->sliding_offset, load),
                            "Table 2, " + surface->name)
                 : absent("sliding was measured at " + loads_text(sliding_loads));
    case Quantity::rolling_friction:
      return within(load, rolling_loads)
                 ? measured(over_load(surface->rolling_r, surface->rolling_r_offset, load),
                            "Table 2, " + surface->name + ", lambda = r")
                 : absent("rolling was measured at " + loads_text(rolling_loads));
    default:
      return absent("not measured in the paper");
  }
}

ComparedValue PublishedColumn::rail(Quantity quantity, const ComparedContact& contact, double angle,
                                    double load) const {
  if (plane_of(contact) != "silicon") return absent("these bodies were not measured in the paper");
  for (const auto& rail : published_.rails) {
    if (rail.angle.value != angle) continue;
    const bool is_force = quantity == Quantity::rail_force;
    return measured(is_force ? over_load(rail.friction, rail.offset, load) : rail.friction,
                    is_force ? "Table 2, rails (h_rail has no uncertainty there)" : "Table 2, rails");
  }
  return absent("no rail of this angle was measured");
}

double PublishedColumn::rail_rms(double angle) const {
  for (const auto& rail : published_.rails)
    if (rail.angle.value == angle) return rail.rms.value;
  return NAN;
}

std::vector<RailCase> PublishedColumn::rails() const {
  const RoughnessLaws laws = roughness_laws(published_);
  std::vector<RailCase> rails;
  for (const auto& rail : published_.rails) {
    const double slopes = 2 * std::cos(rail.angle.value);  // f_plate = 2 cos(theta) f
    rails.push_back({rail.angle.value,
                     {laws.printed_rolling(rail.rms.value), laws.rolling.at(rail.rms).sd},
                     laws.offset.at(rail.rms),
                     {rolling_loads.low / slopes, rolling_loads.high / slopes}});
  }
  return rails;
}

}  // namespace asperity
