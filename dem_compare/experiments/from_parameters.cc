#include "dem_compare/experiments/from_parameters.h"

#include "core/error.h"
#include "core/shear_moduli.h"

namespace asperity {
namespace {

bool is_constant(const EffectiveQuantity& stiffness) {
  return stiffness.length_scale != LengthScale::contact_radius;
}

/// G* that gives the record's k_l = 8 G* a.
std::optional<double> sliding_modulus_of(const ContactParameters& parameters) {
  const auto& given = parameters.lateral_stiffness;
  if (given && std::isfinite(given->at_load))
    return given->value / (mindlin_factor * parameters.contact_radius(given->at_load));
  if (parameters.reduced_shear_modulus) return parameters.reduced_shear_modulus->value;
  return std::nullopt;
}

/// What every law may ask for.
LawValues known_of_bodies(const ContactParameters& p) {
  LawValues known{{"radius", p.effective_radius()}};
  if (p.reduced_modulus) known["reduced_modulus"] = p.reduced_modulus->value;
  if (const auto modulus = sliding_modulus_of(p)) known["sliding_modulus"] = *modulus;
  if (p.sliding_friction) known["sliding_coefficient"] = p.sliding_friction->value;
  if (p.particle.has_elasticity() && p.target.has_elasticity())
    known["torsion_modulus"] = torsion_modulus({p.particle.youngs_modulus, p.particle.poissons_ratio},
                                               {p.target.youngs_modulus, p.target.poissons_ratio});
  return known;
}

/// Adds coefficient, offset, length and stiffness of rolling or torsion.
void add_rotation(LawValues& known, const ContactParameters& parameters,
                  const std::optional<EffectiveQuantity>& friction,
                  const std::optional<EffectiveQuantity>& offset,
                  const std::optional<EffectiveQuantity>& stiffness) {
  using Kind = RotationalStiffness::Kind;
  const auto set_stiffness = [&](Kind kind, double value) {
    known["stiffness_law"] = static_cast<double>(kind);
    known["stiffness"] = value;
  };
  if (stiffness && is_constant(*stiffness))
    set_stiffness(Kind::constant, stiffness->value);
  else if (stiffness)
    set_stiffness(Kind::with_radius, stiffness->value / parameters.contact_radius(stiffness->at_load));
  else if (known.count("sliding_modulus"))
    set_stiffness(Kind::tangential_spring, known["sliding_modulus"]);
  if (!friction) return;
  known["coefficient"] = friction->value;
  known["adhesion_force"] = value_or_zero(offset);
  if (friction->length_scale == LengthScale::contact_radius)
    known["length"] = static_cast<double>(LengthScale::contact_radius);
  if (friction->length_scale == LengthScale::none)
    known["coefficient"] /= parameters.particle.radius;  // it is a length
}

/// What the record says of the parameters that laws of one mode may have.
LawValues known_values(const ContactParameters& p, const std::string& mode, bool normal_adhesion) {
  LawValues known = known_of_bodies(p);
  if (mode == NormalMode::name) {
    if (p.normal_stiffness) known["spring_stiffness"] = p.normal_stiffness->value;
    known["adhesion_force"] = normal_adhesion ? value_or_zero(p.pull_off_force) : 0;
  } else if (mode == SlidingMode::name) {
    if (p.lateral_stiffness) known["spring_stiffness"] = p.lateral_stiffness->value;
    if (p.sliding_friction) known["coefficient"] = p.sliding_friction->value;
    known["adhesion_force"] = value_or_zero(p.sliding_offset);
  } else if (mode == RollingMode::name) {
    add_rotation(known, p, p.rolling_friction, p.rolling_offset, p.rolling_stiffness);
  } else if (mode == TorsionMode::name) {
    add_rotation(known, p, p.torsion_friction, p.torsion_offset, p.torsion_stiffness);
  }
  return known;
}

std::string normal_law_of(const ContactParameters& p) {
  if (p.reduced_modulus) return "hertz";
  if (p.normal_stiffness) return "linear";
  throw InputError(p.file + ": neither 'reduced_modulus' nor 'normal_stiffness' is given; give one");
}

std::string sliding_law_of(const ContactParameters& p, bool partial_slip) {
  if (!p.sliding_friction)
    throw InputError(p.file + ": 'sliding_friction' is missing among the quantities; give it");
  if (!partial_slip && p.lateral_stiffness && is_constant(*p.lateral_stiffness)) return "linear_sliding";
  if (!sliding_modulus_of(p))
    throw InputError(
        p.file +
        ": neither 'reduced_shear_modulus' nor 'lateral_stiffness' with its at_load is given; give one");
  return partial_slip ? "mindlin_deresiewicz" : "mindlin";
}

/// Makes the laws of one contact.
class LawsOfContact {
 public:
  LawsOfContact(const ContactParameters& parameters, const ReducedLawOptions& options)
      : parameters_(parameters), options_(options) {}

  const WrittenLaw* written(const std::string& mode) const {
    const WrittenLaw* found = nullptr;
    for (const auto& law : options_.laws) {
      if (law.description.mode != mode) continue;
      if (found)
        throw InputError("'" + found->description.name + "' and '" + law.description.name +
                         "' are both laws of " + mode + "; give one");
      found = &law;
    }
    return found;
  }
  ReducedLaw made(const WrittenLaw& law) const {
    LawValues values = law.values;
    const LawValues known = known_values(parameters_, law.description.mode, options_.normal_adhesion);
    for (const auto& parameter : law.description.parameters) {
      const auto found = known.find(parameter.name);
      if (found != known.end()) values.emplace(parameter.name, found->second);  // what is written goes before
    }
    return make_reduced_law(law.description.name, values);
  }
  template <class Mode, class Usual>
  void put(LawOf<Mode>& law, const Usual& usual_name) const {
    const WrittenLaw* chosen = written(Mode::name);
    law = std::get<LawOf<Mode>>(made(chosen ? *chosen : WrittenLaw{reduced_law(usual_name()), {}}));
  }

 private:
  const ContactParameters& parameters_;
  const ReducedLawOptions& options_;
};

}  // namespace

ReducedLaw law_of_contact(const WrittenLaw& law, const ContactParameters& parameters,
                          const ReducedLawOptions& options) {
  return LawsOfContact(parameters, options).made(law);
}

ContactModel contact_model(const ContactParameters& parameters, const ReducedLawOptions& options) {
  const LawsOfContact laws(parameters, options);
  if (const WrittenLaw* steady = laws.written(SteadySlipMode::name))
    throw InputError("the law '" + steady->description.name +
                     "' is one of steady slip and leads no contact; see its curve with 'asperity law-curve'");
  ContactModel model;
  model.lever = options.lever;
  model.history_spin = HistorySpin::other_body;
  laws.put(model.normal, [&] { return normal_law_of(parameters); });
  laws.put(model.sliding, [&] { return sliding_law_of(parameters, options.partial_slip); });
  if (parameters.rolling_friction || laws.written(RollingMode::name))
    laws.put(model.rolling, [] { return "rolling_resistance"; });
  if (parameters.torsion_friction || laws.written(TorsionMode::name))
    laws.put(model.torsion, [] { return "torsion_resistance"; });
  if (laws.written(ViscousMode::name)) laws.put(model.damping, [] { return "viscous"; });
  return model;
}

}  // namespace asperity
