// What a case file says, in SI units. app/ reads it; meshing and fem work from it.
#pragma once

#include <limits>
#include <map>
#include <string>

#include "core/hertz.h"
#include "core/law_declaration.h"
#include "core/motion.h"
#include "core/topography_spec.h"

namespace asperity {

/// A film that is bonded to a body: an oxide, a coating, contamination.
struct FilmInput {
  double thickness = 0;                                           ///< [m]; 0: there is none
  double youngs_modulus = 0;                                      ///< E [Pa]
  double poisson_ratio = 0;                                       ///< nu [-]
  double yield_stress = std::numeric_limits<double>::infinity();  ///< of perfect plasticity [Pa]

  bool is_there() const { return thickness > 0; }
};

/// One elastic-plastic body of a contact (small-strain J2 plasticity with associated flow).
struct BodyInput {
  double youngs_modulus = 0;  ///< E [Pa]
  double poisson_ratio = 0;   ///< nu [-]
  LawValues parameters;  ///< of the laws of plasticity; one that is left out has its default, and the body is
                         ///< elastic without any
  TopographySpec topography;
  FilmInput film;
};

/// Laws at a point of the interface.
struct InterfaceInput {
  LawValues parameters;  ///< of the laws of friction and adhesion; one that is left out has its default
  double work_of_adhesion = 0;    ///< on approach [J/m^2]; 0: what approaches does not attract
  double work_of_separation = 0;  ///< on separation of surfaces that were in contact [J/m^2]; 0: the same
  std::string adhesion_law = "dugdale";
  /// Attraction beyond the contact, which presses whatever the gap, so that it acts like more load [N].
  double attraction_force = 0;
};

/// How the particle is moved.
struct ExperimentInput {
  Motion type = Motion::normal;  ///< not rail, which is a program
  std::string declared;          ///< name of the experiment that wrote `program`; empty: people did
  LawValues parameters;          ///< of declared experiments (core/experiment_declaration.h)
  enum class Control { force, displacement } control = Control::force;
  double normal_load = 0;          ///< largest normal force F [N] (force control)
  double normal_approach = 0;      ///< largest approach [m] (displacement control)
  int load_steps = 10;             ///< recorded steps from zero to the largest load
  double load_step_error = 0.005;  ///< of the approach, which steps of bodies that yield may leave before
                                   ///< they are divided; 0: never
  bool unload = true;              ///< return to zero load after loading
  double retract = 0;  ///< beyond first touch, at the end of unloading under displacement control [m]
  int unload_steps = 10;
  int cycles = 1;              ///< load-unload cycles (reloading follows unloading)
  int hold_steps = 0;          ///< steps at the largest load before unloading
  double distance = 0;         ///< path length of sliding and rolling in one direction [m]
  double angle = 0;            ///< torsion angle in one direction [rad]
  bool reverse = true;         ///< come back along the path
  double return_distance = 0;  ///< after the reversal of sliding or rolling [m]; 0: all of `distance`
  std::string program;         ///< motions combined (core/motion_program.h)
  double speed = 0;            ///< of the motion along its path [m/s]; 0: a step lasts a second
  double load_time = 0;        ///< from zero to the largest load, and back [s]; 0: a step lasts a second
  double hold_time = 0;        ///< of all hold steps together [s]; 0: a step lasts a second
  int motion_steps = 0;        ///< equal steps in one direction; 0: fine where slip begins, then an interface
                               ///< spacing (half of one in torsion)
};

/// How fine the bodies are meshed.
struct MeshInput {
  double interface_spacing =
      0;  ///< node spacing in the potential contact zone [m]; 0: derived from load and roughness
  double contact_region =
      0;           ///< half width of the finely meshed square [m]; 0: derived from load and roughness
  int layers = 4;  ///< cells of each refinement level below the interface (grading)
  std::string sphere = "hemisphere";
  std::string along_path =
      "travelling";  ///< fine cells "travelling" with the contact, or on the "whole" path
};

/// How a step is solved.
struct SolverInput {
  std::string backend =
      "matrix-free";        ///< "matrix-free" (geometric multigrid) or "assembled" (algebraic multigrid)
  int newton_steps = 60;    ///< most of one step; a step that needs more is halved
  double tolerance = 1e-6;  ///< residual force of an accepted step relative to the contact force [-]
  int threads = 0;          ///< per process; 0: all cores of the machine divided by the ranks on it
};

/// Which fields are written.
struct OutputInput {
  bool fields = true;    ///< VTU/PVD of the bodies, VTP/PVD of the interface
  int fields_every = 0;  ///< steps between field files; 0: ten of them, even in load or path
};

/// All of a case file.
struct CaseInput {
  std::string file;  ///< where it was read, for messages
  std::string title;
  BodyInput particle;
  double radius = 0;  ///< of the particle [m]
  BodyInput substrate;
  InterfaceInput interface;
  ExperimentInput experiment;
  MeshInput mesh;
  SolverInput solver;
  OutputInput output;
  /// "Section/Entry" and text, defaults written out, of all entries that decide the answer and not how well
  /// or where it is computed: for result.json, where cases of the same contact are known by them. Empty for a
  /// case that no file was read for.
  std::map<std::string, std::string> physical_entries;
};

/// Whether one of the bodies has a film.
inline bool has_films(const CaseInput& input) {
  return input.particle.film.is_there() || input.substrate.film.is_there();
}

/// The bodies as if they were smooth and elastic, without their films.
inline ElasticBody elastic_body(const BodyInput& body) { return {body.youngs_modulus, body.poisson_ratio}; }
inline ElasticBody elastic_film(const FilmInput& film) { return {film.youngs_modulus, film.poisson_ratio}; }
inline Hertz hertz_of(const CaseInput& input) {
  return {reduced_modulus(elastic_body(input.particle), elastic_body(input.substrate)), input.radius};
}

/// What the contact carries at the largest load under control by force [N].
inline double largest_contact_force(const CaseInput& input) {
  return input.experiment.normal_load + input.interface.attraction_force;
}

/// Their approach at the largest load, or the one that is asked for [m].
inline double hertz_approach_of(const CaseInput& input) {
  const ExperimentInput& e = input.experiment;
  return e.control == ExperimentInput::Control::displacement
             ? e.normal_approach
             : hertz_of(input).approach(largest_contact_force(input));
}

}  // namespace asperity
