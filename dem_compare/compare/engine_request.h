// What a live engine is asked to do with the numbers of a compared contact. SI units.
#pragma once

#include <string>

#include "dem_compare/cases/compared_contact.h"
#include "dem_compare/numbers/uncertain.h"
#include "engines/experiment.h"

namespace asperity {

/// What an engine is run for: a number of one experiment over `divisor`.
struct EngineRequest {
  EngineExperiment experiment;
  std::string measurement;  ///< as measure() names it
  double divisor = 1;
  double load_step =
      0;  ///< above zero: load over approach, differenced between loads apart by this share to both sides
};

/// Friction of the rail's slopes and plate.
struct RailCase {
  double angle = 0;    ///< [rad]
  Uncertain rolling;   ///< mu_ro lambda/r at the rail's roughness
  Uncertain offset{};  ///< h_ro at the rail's roughness [N]
  LoadRange loads{};   ///< on one slope, from those on the plate [N]
};

/// A quantity that does not depend on the load.
EffectiveQuantity constant(double value, LengthScale scale = LengthScale::none);

/// Moduli of the smooth, elastic bodies, whatever a record says; friction of the record, otherwise of the
/// case.
ContactParameters of_bodies(const ComparedContact& contact);
/// The record's numbers; the contact must have one.
ContactParameters as_given(const ComparedContact& contact);

/// With an amplitude that reaches every limit with room to spare. load [N], rail_angle [rad].
EngineExperiment engine_experiment(Motion type, const ContactParameters& substrate,
                                   const ContactParameters& indenter, double load, double rail_angle = 0);
/// The glued sphere's loop. The approach is asked for where the case has no friction, too: it does not depend
/// on it.
EngineExperiment glued(ContactParameters p, double load);
/// Twisting in the engine with a spring k [N m/rad] and a limit [N m].
EngineExperiment twisting(const ComparedContact& contact, double load, double stiffness, double limit);
/// The rail in the engine; with offsets or without. torsion: mu_to lambda/r.
EngineRequest rail_run(const ComparedContact& contact, double load, const RailCase& rail, double torsion,
                       bool with_offsets);

}  // namespace asperity
