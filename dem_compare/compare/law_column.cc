#include "dem_compare/compare/law_column.h"

#include <filesystem>

#include "core/shear_moduli.h"
#include "dem_compare/laws/hertzian_torsion.h"
#include "dem_compare/laws/rail_balance.h"

namespace asperity {
namespace {

constexpr double equal_work =
    5.0 / 6;  // Mindlin & Deresiewicz over Mindlin without slip: finite_element_column.h

std::string file_of(const ComparedContact& contact) {
  return std::filesystem::path(contact.record->file).filename().string();
}

/// Another number than the law of the bodies has, beyond the rounding of moduli in a file.
bool differs(double one, double other) {
  constexpr double rounding = 1e-3;
  return std::abs(one / other - 1) > rounding;
}

LawValue law(const std::string& name, double value, double sd = NAN) {
  LawValue result;
  result.value = value;
  result.sd = sd;
  result.source = name;
  return result;
}

LawValue no_law(const std::string& reason) {
  LawValue result;
  result.reason = result.no_engine = reason;
  return result;
}

std::vector<LawValue> normal_laws(Quantity quantity, const ComparedContact& contact, double load) {
  constexpr double difference = 0.02;
  const bool is_approach = quantity == Quantity::approach;
  const auto with_engine = [&](LawValue value, const ContactParameters& p) {
    value.engine = EngineRequest{glued(p, load), "approach", 1, is_approach ? 0 : difference};
    return value;
  };
  const auto number = [&](const Hertz& hertz) {
    return is_approach ? hertz.approach(load) : hertz.normal_stiffness(load);
  };
  std::vector<LawValue> laws{with_engine(law("Hertz", number(contact.hertz())), of_bodies(contact))};
  if (!contact.record) return laws;
  const double given = number(contact.record->hertz());
  if (differs(given, laws[0].value))
    laws.push_back(with_engine(law("Hertz with E* as given", given), as_given(contact)));
  if (!is_approach && contact.record->normal_stiffness) {
    laws.push_back(law("k_n as given", contact.record->normal_stiffness_at(load)));
    laws.back().no_engine = "the engine's normal law is Hertz";
  }
  return laws;
}

/// 8 G* a with `share`, and the engine with that spring.
LawValue lateral_spring(const std::string& name, double share, const ComparedContact& contact, double load) {
  const double k =
      share * mindlin_factor * contact.reduced_shear_modulus() * contact.hertz().contact_radius(load);
  LawValue value = law(name, k);
  EngineExperiment experiment = glued(of_bodies(contact), load);
  experiment.substrate.lateral_stiffness = constant(k, LengthScale::contact_radius);
  experiment.substrate.lateral_stiffness->at_load = load;
  value.engine = EngineRequest{experiment, "slope after reversal"};
  return value;
}

std::vector<LawValue> sliding_laws(Quantity quantity, const ComparedContact& contact, double load) {
  if (quantity == Quantity::sliding_friction) {
    LawValue value;
    if (contact.record && contact.record->sliding_friction) {
      const EffectiveQuantity& mu = *contact.record->sliding_friction;
      const Uncertain offset =
          contact.record->sliding_offset
              ? Uncertain{contact.record->sliding_offset->value, contact.record->sliding_offset->sd}
              : Uncertain{0};
      const Uncertain over_load =
          propagate([load](const std::vector<double>& x) { return x[0] * (1 + x[1] / load); },
                    {{mu.value, mu.sd}, offset});
      value = law("Coulomb with offset", over_load.value, over_load.sd);
    } else if (contact.friction > 0) {
      value = law("Coulomb, mu of the case", contact.friction);
    } else {
      return {no_law("the case has no friction coefficient and no parameters were given (--parameters)")};
    }
    ContactParameters numbers = contact.record ? as_given(contact) : of_bodies(contact);
    value.engine = EngineRequest{glued(numbers, load), "plateau", load};
    std::vector<LawValue> laws{value};
    if (numbers.sliding_offset && numbers.sliding_offset->value != 0) {
      laws.push_back(
          law("Coulomb without offset", numbers.sliding_friction->value, numbers.sliding_friction->sd));
      numbers.sliding_offset.reset();
      laws.back().engine = EngineRequest{glued(numbers, load), "plateau", load};
    }
    return laws;
  }
  std::vector<LawValue> laws{lateral_spring("Mindlin without slip", 1, contact, load)};
  if (quantity == Quantity::lateral_stiffness_to_sliding)
    laws.push_back(lateral_spring("Mindlin-Deresiewicz with equal work", equal_work, contact, load));
  if (contact.record && differs(contact.record->lateral_stiffness_at(load), laws[0].value)) {
    laws.push_back(law("k_l as given", contact.record->lateral_stiffness_at(load)));
    laws.back().engine = EngineRequest{glued(as_given(contact), load), "slope after reversal"};
  }
  return laws;
}

std::vector<LawValue> rolling_laws(Quantity quantity, const ComparedContact& contact, double load) {
  if (!contact.record) return {no_law("no parameters were given (--parameters)")};
  if (!contact.record->rolling_friction) return {no_law(file_of(contact) + " has no rolling_friction")};
  const ContactParameters &substrate = *contact.record, &plate = contact.plate();
  if (!plate.rolling_friction) return {no_law("the parameters of the plate have no rolling numbers")};
  const double weight = load * contact.radius;
  const std::string mean = contact.indenter ? ", mean with the plate" : "";
  const bool has_stiffness = substrate.rolling_stiffness && plate.rolling_stiffness;
  LawValue value;
  if (quantity == Quantity::rolling_stiffness) {
    if (!has_stiffness) return {no_law(file_of(contact) + " has no rolling_stiffness")};
    value = law("k_ro as given" + mean,
                (substrate.rolling_stiffness_at(load) + plate.rolling_stiffness_at(load)) / 2);
  } else {
    const EffectiveQuantity& mu = *substrate.rolling_friction;
    const double offset = substrate.rolling_offset ? substrate.rolling_offset->value : 0;
    const double offset_sd = substrate.rolling_offset ? substrate.rolling_offset->sd : NAN;
    const Uncertain own = propagate(
        [&](const std::vector<double>& x) {
          return x[0] * substrate.length(mu.length_scale, load) * (load + x[1]) / weight;
        },
        {{mu.value, mu.sd}, {offset, offset_sd}});
    value = law("slider with offset" + mean,
                (substrate.rolling_limit(load) + plate.rolling_limit(load)) / 2 / weight, own.sd);
  }
  std::vector<LawValue> laws{value};
  ContactParameters without = as_given(contact), plate_without = plate;
  const bool has_offset = (without.rolling_offset && without.rolling_offset->value != 0) ||
                          (plate.rolling_offset && plate.rolling_offset->value != 0);
  without.rolling_offset.reset();
  plate_without.rolling_offset.reset();
  if (quantity == Quantity::rolling_friction && has_offset)
    laws.push_back(law("slider without offset" + mean,
                       (without.rolling_limit(load) + plate_without.rolling_limit(load)) / 2 / weight));
  if (!has_stiffness) {
    for (auto& one : laws) one.no_engine = file_of(contact) + " has no rolling_stiffness";
    return laws;
  }
  // The plate's force acts over the diameter: M_s + M_i = 2 r f. Both contacts resist the rotation.
  const auto run = [&](const ContactParameters& below, const ContactParameters& above) {
    const EngineExperiment experiment = engine_experiment(Motion::rolling, below, above, load);
    return quantity == Quantity::rolling_stiffness
               ? EngineRequest{experiment, "stiffness against rotation", 2}
               : EngineRequest{experiment, "plateau", load};
  };
  laws[0].engine = run(as_given(contact), plate);
  if (laws.size() > 1) laws[1].engine = run(without, plate_without);
  return laws;
}

std::vector<LawValue> torsion_laws(Quantity quantity, const ComparedContact& contact, double load) {
  const double a = contact.hertz().contact_radius(load), r = contact.radius;
  const bool has_limit = contact.record && contact.record->torsion_friction;
  const double no_slip = no_slip_torsion_stiffness(contact.torsion_modulus(), a);
  const double full_slip = full_slip_torsion_moment(contact.friction, load, a);
  const double limit = has_limit ? contact.record->torsion_limit(load) : full_slip;
  const std::string no_friction =
      "the case has no friction coefficient and no parameters were given (--parameters)";
  const auto with_engine = [&](LawValue value, double stiffness, double moment) {
    if (!(moment > 0))
      value.no_engine = no_friction;
    else if (quantity == Quantity::torsion_stiffness)
      value.engine = EngineRequest{twisting(contact, load, stiffness, moment), "slope after reversal"};
    else
      value.engine = EngineRequest{twisting(contact, load, stiffness, moment), "plateau", load * r};
    return value;
  };
  std::vector<LawValue> laws;
  if (quantity == Quantity::torsion_stiffness) {
    const double assumed = mindlin_factor * contact.reduced_shear_modulus() * a * r * r;
    laws.push_back(with_engine(law("Reissner-Sagoci without slip", no_slip), no_slip, limit));
    laws.push_back(with_engine(law("8 G* a r^2, the paper's assumption", assumed), assumed, limit));
    if (contact.record && contact.record->torsion_stiffness) {
      const double own = contact.record->torsion_stiffness_at(load);
      if (differs(own, assumed) && differs(own, no_slip))
        laws.push_back(with_engine(law("k_to as given", own), own, limit));
    }
    return laws;
  }
  if (full_slip > 0)
    laws.push_back(
        with_engine(law("full slip, (3 pi/16) mu a/r", full_slip / (load * r)), no_slip, full_slip));
  if (has_limit) {
    const EffectiveQuantity& mu = *contact.record->torsion_friction;
    const double value = limit / (load * r);
    const double stiffness =
        contact.record->torsion_stiffness ? contact.record->torsion_stiffness_at(load) : no_slip;
    laws.push_back(with_engine(law("slider as given", value, value * mu.sd / mu.value), stiffness, limit));
  }
  if (laws.empty()) laws.push_back(no_law(no_friction));
  return laws;
}

/// eq:murail and, for the force over the load, mu_rail (1 + h_rail/f); beside it what leaving out torsion or
/// the offsets makes of it.
std::vector<LawValue> rail_laws(Quantity quantity, const ComparedContact& contact, double load,
                                const RailCase& rail) {
  if (!contact.record) return {no_law("no parameters were given (--parameters)")};
  if (!contact.record->torsion_friction || !contact.record->rolling_friction)
    return {no_law(file_of(contact) + " lacks rolling_friction or torsion_friction")};
  const EffectiveQuantity& mu = *contact.record->torsion_friction;
  const double scale = contact.record->length(mu.length_scale, load) / contact.radius;
  const Uncertain torsion_offset =
      contact.record->torsion_offset
          ? Uncertain{contact.record->torsion_offset->value, contact.record->torsion_offset->sd}
          : Uncertain{0};
  const bool is_force = quantity == Quantity::rail_force;
  const auto balance = [&](const std::string& name, const Uncertain& torsion, bool with_offsets) {
    const Uncertain value = propagate(
        [&](const std::vector<double>& x) {
          const RailFriction friction{x[0], x[1] * scale, x[2], x[3]};
          return rail_friction(rail.angle, friction) *
                 (1 + (with_offsets ? rail_offset(rail.angle, friction) / load : 0));
        },
        {rail.rolling, torsion, rail.offset, torsion_offset});
    return law(name, value.value, value.sd);
  };
  const Uncertain torsion{mu.value, mu.sd};
  std::vector<LawValue> laws{
      balance(is_force ? "rail balance with offsets" : "rail balance (eq:murail)", torsion, is_force)};
  if (contact.record->rolling_stiffness && contact.record->torsion_stiffness &&
      contact.record->sliding_friction)
    laws[0].engine = rail_run(contact, load, rail, mu.value * scale, is_force);
  else
    laws[0].no_engine = file_of(contact) + " lacks rolling_stiffness, torsion_stiffness or sliding_friction";
  laws.push_back(balance("rail balance without torsion", Uncertain{0}, is_force));
  laws.back().no_engine = "the engine is run with all resistances";
  if (is_force) {
    laws.push_back(balance("rail balance without offsets", torsion, false));
    laws.back().no_engine = "the engine is run with all resistances";
  }
  return laws;
}

}  // namespace

std::vector<LawValue> law_values(Quantity quantity, const ComparedContact& contact, double load,
                                 const RailCase* rail) {
  switch (display_of(quantity).mode) {
    case Motion::normal:
      return normal_laws(quantity, contact, load);
    case Motion::sliding:
      return sliding_laws(quantity, contact, load);
    case Motion::rolling:
      return rolling_laws(quantity, contact, load);
    case Motion::torsion:
      return torsion_laws(quantity, contact, load);
    case Motion::rail:
    case Motion::program:
      break;
  }
  if (!rail) return {no_law("no rail was named")};
  return rail_laws(quantity, contact, load, *rail);
}

}  // namespace asperity
