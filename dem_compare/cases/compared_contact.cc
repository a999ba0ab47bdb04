#include "dem_compare/cases/compared_contact.h"

#include <cmath>

#include "core/error.h"
#include "core/shear_moduli.h"

namespace asperity {
namespace {

bool close(double one, double other, double share) {
  return std::abs(one - other) <= share * std::abs(other);
}

bool same_elasticity(const ElasticBody& one, const ElasticBody& other) {
  constexpr double share = 0.01;
  return close(one.youngs_modulus, other.youngs_modulus, share) &&
         close(one.poisson_ratio, other.poisson_ratio, share);
}

ElasticBody elasticity_of(const ContactBody& body, const std::string& file, const char* name) {
  if (!body.has_elasticity())
    throw InputError(file + ": '" + name +
                     "' needs youngs_modulus and poissons_ratio to be compared with finite elements");
  return {body.youngs_modulus, body.poissons_ratio};
}

}  // namespace

double ComparedContact::reduced_shear_modulus() const {
  return asperity::reduced_shear_modulus(particle, plane);
}
double ComparedContact::torsion_modulus() const { return asperity::torsion_modulus(particle, plane); }

ComparedContact contact_of(const CaseGroup& group) {
  const SolvedCase& solved = group.first();
  ComparedContact contact;
  contact.label = group.label;
  contact.particle = solved.particle();
  contact.plane = solved.substrate();
  contact.radius = solved.hertz().radius;
  contact.rms = solved.entries.topography("Substrate").rms();
  contact.friction = solved.entries.quantity("Interface/Friction coefficient", Dimension::none, 0);
  return contact;
}

ComparedContact contact_of(const ContactParameters& record,
                           const std::optional<ContactParameters>& indenter) {
  if (!record.target.is_plane())
    throw InputError(record.file + ": these experiments are with planes; its target is a sphere");
  ComparedContact contact;
  contact.label = record.title.empty() ? record.file : record.title;
  contact.particle = elasticity_of(record.particle, record.file, "particle");
  contact.plane = elasticity_of(record.target, record.file, "target");
  contact.radius = record.particle.radius;
  contact.rms = record.target.rms;
  if (record.sliding_friction) contact.friction = record.sliding_friction->value;
  contact.record = record;
  contact.indenter = indenter;
  if (indenter && indenter->particle.radius != record.particle.radius)
    throw InputError(indenter->file + ": its particle has another radius than that of " + record.file);
  return contact;
}

bool same_bodies(const ComparedContact& one, const ComparedContact& other) {
  constexpr double share = 0.01;
  return same_elasticity(one.particle, other.particle) && same_elasticity(one.plane, other.plane) &&
         close(one.radius, other.radius, share);
}

bool same_roughness(const ComparedContact& one, const ComparedContact& other) {
  constexpr double share = 0.1;
  return close(one.rms, other.rms, share);
}

}  // namespace asperity
