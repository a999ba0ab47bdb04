// What a recording is of: bodies and typical sizes, from which effects take starting values and bounds. SI
// units.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <string>

#include "core/hertz.h"
#include "core/relaxing_modulus.h"
#include "diagnosis/recording/samples.h"
#include "diagnosis/recording/sliding_trace.h"

namespace asperity {

struct Experiment {
  Motion mode = Motion::normal;
  ElasticBody particle, substrate, indenter;
  double radius = 0;                            ///< nominal, of the particle [m]
  double yield_hint = 0;                        ///< smallest known yield stress [Pa]; 0: none is known
  double largest_force = 0, typical_force = 0;  ///< normal [N]
  double largest_displacement = 0;              ///< of the contact under the largest force, by Hertz [m]
  double largest_response = 0;                  ///< in units of the response
  double stroke = 0;                            ///< path length in one direction [m]
  double duration = 0;                          ///< of the longest run [s]
  double hold_duration = 0;                     ///< of the longest hold [s]
  double slowest = 0, fastest = 0;  ///< speeds that a twentieth of the samples stay below and above [m/s]
  double fastest_approach = 0;  ///< rate of displacement that a twentieth of the samples stays above [m/s]
  double slowest_run = 0, fastest_run = 0;  ///< 1/duration of the longest and the shortest run [1/s]
  double cycles = 0;                        ///< of the longest run
  double smoothest = 0, roughest = 0;       ///< rms roughness [m]
  double smallest_radius = 0, largest_radius = 0;
  double smallest_force = 0;
  /// How many different values each of the variables holds that an experimenter sets (rms_roughness, radius,
  /// rail_angle, humidity), by channel.
  std::map<std::string, int> different;
  /// What sliding looks like in time; null where no run of sliding was recorded.
  std::shared_ptr<const SlidingTrace> sliding_trace;
  bool has_trace = false, has_series = false, has_both_directions = false, has_unloading = false,
       has_off_contact = false;
  /// Samples below first touch by more than a fiftieth of the largest displacement.
  std::size_t samples_off_contact = 0;
  bool has_time = false;           ///< the times of all traces are known
  bool response_is_force = false;  ///< a normal force is recorded under a driven displacement
  /// The simulation is a case of finite elements: laws keep only what its entries can say.
  bool by_finite_elements = false;
  /// Yield stresses of that case, as it is [Pa]; infinite: the body stays elastic.
  double particle_yield = std::numeric_limits<double>::infinity();
  double substrate_yield = std::numeric_limits<double>::infinity();
  bool case_is_smooth = true;          ///< neither of its bodies has a topography
  double case_spacing = 0;             ///< of its nodes where the bodies can touch [m]; 0: it derives it
  double case_friction = 0;            ///< its local coefficient of friction [-]; 0: none
  double case_adhesion_range = 0;      ///< of its attraction [m]; 0: it gives none
  double case_work_of_adhesion = 0;    ///< its own, on approach [J/m^2]
  double case_work_of_separation = 0;  ///< the same on separation [J/m^2]
  double case_attraction_force = 0;    ///< its attraction beyond the contact [N]
  /// Of their shear moduli, as it is.
  RelaxingPart particle_relaxation, substrate_relaxation;
  /// RMS roughness of its substrate where that is generated, or of the recorded surface that it is solved
  /// with [m]; 0: smooth or a scan.
  double case_rms = 0;

  /// Of motions along the surface that a case of finite elements can be set against.
  bool is_lateral() const {
    return mode == Motion::sliding || mode == Motion::rolling || mode == Motion::torsion;
  }
  /// A body of the case relaxes with time.
  bool case_relaxes() const { return particle_relaxation.share > 0 || substrate_relaxation.share > 0; }
  /// The case is pressed, and its surfaces attract each other over a range.
  bool case_attracts() const {
    return mode == Motion::normal && case_adhesion_range > 0 && case_work_of_separation > 0;
  }
  /// E* of the pair [Pa].
  double reduced_modulus() const { return asperity::reduced_modulus(particle, substrate); }
  Hertz hertz() const { return {reduced_modulus(), radius}; }
};

/// From a recording's description and the range of its samples.
Experiment experiment_of(const Recording& recording, const Samples& samples);

}  // namespace asperity
