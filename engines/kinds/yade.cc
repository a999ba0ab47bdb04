#include "engines/yade.h"

#include <cmath>
#include <sstream>

#include "engines/elastoplastic/elastoplastic_inputs.h"
#include "engines/engine_registry.h"
#include "engines/input_notes.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/particle_box.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

using N = std::string;

N number(double value) { return text_number(value); }

/// One plane as a large sphere that touches the particle from direction (0, y, z), the unit vector from
/// contact to centre.
struct Plane {
  const char* name;
  double y = 0, z = 1;
  const ContactParameters* parameters;
  double load = 0;
};

std::vector<Plane> planes_of(const EngineExperiment& e) {
  const double c = e.rail_cosine(), s = std::sin(e.rail_angle);
  std::vector<Plane> planes;
  if (e.type == Motion::rail)
    planes = {{"left", -s, c, &e.substrate, e.load}, {"right", s, c, &e.substrate, e.load}};
  else
    planes = {{"substrate", 0, 1, &e.substrate, e.load}};
  if (e.type == Motion::rolling || e.type == Motion::rail)
    planes.push_back({"plate", 0, -1, &e.indenter, e.indenter_load()});
  return planes;
}

/// The sphere's centre is at the origin at rest; each plane is a sphere `large` times as large below (or
/// above) it.
void write_bodies(std::ostream& out, const EngineExperiment& e, const std::vector<Plane>& planes) {
  out << "large = 1e5*R\ndef material(label):\n"
      << "    return O.materials.append(FrictMat(young=1e9, poisson=0.3, frictionAngle=0.1, density="
      << number(e.substrate.particle.density)
      << ", label=label))  # moduli and friction: replaced on each contact\n"
      << "particle = O.bodies.append(utils.sphere((0, 0, 0), R, material=material('particle')))\nplanes = "
         "{}\n"
      << yade_functions();
  for (const Plane& plane : planes) {
    out << "planes['" << plane.name << "'] = dict(y=" << number(plane.y) << ", z=" << number(plane.z)
        << ", approach=" << number(plane.parameters->hertz().approach(plane.load)) << ")\n"
        << yade_contact_entry("'particle'", N("'") + plane.name + "'", plane.parameters->effective_radius(),
                              yade_contact(*plane.parameters, plane.load));
  }
  out << R"(for name, plane in planes.items():
    reach = R - plane['approach'] + large
    centre = (0, -plane['y']*reach, -plane['z']*reach)
    plane['id'] = O.bodies.append(utils.sphere(centre, large, material=material(name), fixed=True))
)";
}

const char* const functions = R"(
def contact(name):
    return O.interactions[particle, planes[name]['id']]

def force_on_particle(name):
    # of both halves of a contact, the one that pushes the particle away from the plane
    i = contact(name)
    force = i.phys.normalForce + i.phys.shearForce
    away = i.phys.normalForce.dot(Vector3(0, planes[name]['y'], planes[name]['z']))
    return force if away > 0 else -force

leg = drive = speed = leg_start = 0

def row():
    state = O.bodies[particle].state
    now = drive + speed*(O.iter - leg_start)*O.dt
    substrate = force_on_particle(base)
    approach = planes[base]['approach'] - state.pos.dot(Vector3(0, planes[base]['y'], planes[base]['z']))
    print(*['%.15g' % value for value in (leg, O.time, now, response(), state.pos[0], state.angVel[1],
          substrate.dot(Vector3(0, planes[base]['y'], planes[base]['z'])), approach)], sep=',', file=trace)

def run_leg(distance, steps, every):
    global leg, drive, speed, leg_start
    speed, leg_start = distance/(steps*O.dt), O.iter
    recorder.iterPeriod = every
    move(speed)
    O.run(steps, True)
    drive += distance
    leg += 1
)";

}  // namespace

YadeContact yade_contact(const ContactParameters& p, double load) {
  const double root = std::sqrt(p.effective_radius());
  YadeContact contact;
  contact.kno = 4.0 / 3 * p.hertz().reduced_modulus * root;
  contact.kso = p.lateral_stiffness_at(load) / p.contact_radius(load) * root;
  contact.friction = p.sliding_limit(load) / load;
  if (p.rolling_friction && p.rolling_stiffness) {
    contact.kr = p.rolling_stiffness_at(load);
    contact.bend = p.rolling_limit(load) / load;
  }
  if (p.torsion_friction && p.torsion_stiffness) {
    contact.ktw = p.torsion_stiffness_at(load);
    contact.twist = p.torsion_limit(load) / load;
  }
  return contact;
}

std::string Yade::input(const EngineExperiment& e, const MotionPlan& plan) const {
  const bool is_free = e.type == Motion::rolling || e.type == Motion::rail,
             twists = e.type == Motion::rail || e.type == Motion::torsion;
  const std::vector<Plane> planes = planes_of(e);
  std::ostringstream out;
  out << "# asperity: " << engine_experiment_name(e.type) << ", one sphere, normal load " << number(e.load)
      << " N; SI units. Run with: yade -n -x " << input_file()
      << "\nfrom yade import *\nimport os, sys, traceback\n"
      << "R = " << number(e.substrate.particle.radius) << "\nO.dt = " << number(plan.time_step) << "\n";
  write_bodies(out, e, planes);
  out << "base = '" << planes.front().name
      << "'  # the contact whose normal force and approach are recorded\n"
      << functions;

  // What is prescribed, and what answers to it.
  switch (e.type) {
    case Motion::sliding:
      out << "O.bodies[particle].state.blockedDOFs = 'xyXYZ'  # glued\n"
          << "O.forces.setPermF(particle, (0, 0, " << number(-e.load) << "))\n"
          << "def move(v): O.bodies[particle].state.vel = (v, 0, O.bodies[particle].state.vel[2])\n"
          << "def response(): return -force_on_particle('substrate')[0]\n";
      break;
    case Motion::torsion:
      out << "O.bodies[particle].state.blockedDOFs = 'xyzXYZ'\n"
          << "def move(v): O.bodies[particle].state.angVel = (0, 0, v)\n"
          << "def response(): return -O.forces.t(particle)[2]\n";
      break;
    case Motion::rolling:
    case Motion::rail:
      out << "def move(v): O.bodies[planes['plate']['id']].state.vel = (v, 0, 0)\n"
          << "def response(): return force_on_particle('plate')[0]\n";
      break;
    case Motion::normal:
    case Motion::program:
      break;  // no experiment of one particle
  }
  out << "contacts = PyRunner(command='asperity_step()', iterPeriod=1, initRun=True)\n"
      << "recorder = PyRunner(command='row()', iterPeriod=1, initRun=True, dead=True)\n"
      << "O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),\n"
      << "    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],\n"
      << "        [Ip2_FrictMat_FrictMat_MindlinPhys(betan=0.5, betas=" << (is_free ? "0.5" : "0") << ")],\n"
      << "        [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),\n"
      << "    contacts, recorder, NewtonIntegrator(damping=0)]\n"
      << "try:\n"
      << "    O.run(1, True)  # the contacts come into being\n"
      << (twists ? "" : "    contacts.dead = True  # nothing twists under a constant load\n")
      << "    with open('trace.csv', 'w') as trace:\n        print('" << trace_header() << "', file=trace)\n"
      << "        recorder.dead = False\n";
  for (const Leg& leg : plan.legs)
    out << "        run_leg(" << number(leg.distance) << ", " << leg.steps << ", " << leg.every << ")\n";
  out << "except Exception:\n    traceback.print_exc()\n    sys.stdout.flush()\n    sys.stderr.flush()\n    "
         "os._exit(1)\n"
      << "print('asperity: all legs done')\nsys.stdout.flush()\nos._exit(0)\n";
  return out.str();
}

std::string Yade::error_message(const std::string& log) const {
  // The last line of a Python traceback names the error.
  if (log.find("Traceback") == std::string::npos) {
    const auto fatal = log.find("FATAL");
    return fatal == std::string::npos ? "" : log.substr(fatal, log.find('\n', fatal) - fatal);
  }
  std::istringstream lines(log.substr(log.rfind("Traceback")));
  std::string line, last;
  while (std::getline(lines, line))
    if (!line.empty() && line[0] != ' ' && line.find("Error") != std::string::npos) last = line;
  return last;
}

std::string Yade::remedy(const std::string& message) const {
  if (message.find("NameError") != std::string::npos || message.find("ImportError") != std::string::npos)
    return "this build lacks the Hertz-Mindlin law; Debian's package 'yade' (2023.02a) has it";
  return "asperity is tested with Debian's package 'yade' (2023.02a): use that one, or name it with "
         "--program";
}

std::string Yade::version(const std::string& log) const {
  const std::string mark = "Welcome to Yade ";
  const auto at = log.find(mark);
  if (at == std::string::npos) return "";
  const std::string rest = log.substr(at + mark.size(), log.find('\n', at) - at - mark.size());
  return rest.substr(0, rest.find_last_not_of(' ') + 1);
}

std::string Yade::contact_input(InputNotes& notes) const {
  const double root = std::sqrt(notes.effective_radius());
  YadeContact contact;
  contact.kno = 4.0 / 3 * notes.record().hertz().reduced_modulus * root;
  contact.kso = 8 * notes.shear_modulus() * root;
  notes.meaning("kno", contact.kno, "N/m^(3/2)", "4/3 E* R_e^(1/2), F = kno delta^(3/2)");
  notes.meaning("kso", contact.kso, "N/m^(3/2)", "8 G* R_e^(1/2), lateral stiffness kso delta^(1/2)");
  contact.friction = notes.sliding();
  notes.meaning("tangensOfFrictionAngle", contact.friction, "", "|f_l| <= tan F");
  if (notes.has_rolling()) {
    contact.kr = notes.constant_rolling_stiffness();
    contact.bend = notes.rolling();
    notes.meaning("kr", contact.kr, "N m/rad", "K_ro (krot of the functor)");
    notes.meaning("maxBendPl", contact.bend, "m",
                  "C_ro, |M| <= maxBendPl F; the functor would make it eta times the mean of both radii");
  }
  if (notes.has_torsion()) {
    contact.ktw = notes.constant_torsion_stiffness();
    contact.twist = notes.torsion();
    notes.meaning("ktw", contact.ktw, "N m/rad", "K_to (ktwist of the functor)");
    notes.meaning("twist_limit", contact.twist, "m",
                  "C_to, |M| <= twist_limit F: MindlinPhys has no such limit, asperity_step() lays it on");
  }
  notes.leaves_out_pull_off("includeAdhesion (DMT, 4 pi gamma R_e) would add it to the limits of all modes");
  notes.cannot(
      "other radii: kno and kso follow R_e^(1/2) of each contact, kr, ktw, maxBendPl and twist_limit are "
      "those of the R_e above");
  return notes.text(python_comment) + R"(
# Materials: O.materials.append(FrictMat(..., label=PARTICLE)) and label=TARGET;
# contacts of other materials stay as they are.
# O.engines: InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
#                            # the damping betan is not in the record: choose it
#                            [Ip2_FrictMat_FrictMat_MindlinPhys(betan=0.5)],
#                            [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),
#            # behind it and before NewtonIntegrator, at every step
#            PyRunner(command='asperity_step()', iterPeriod=1, initRun=True),
PARTICLE = )" +
         python_literal(notes.particle_name()) + "\nTARGET = " + python_literal(notes.target_name()) + "\n" +
         yade_functions() + "\n" +
         yade_contact_entry("PARTICLE", "TARGET", notes.effective_radius(), contact);
}

std::string Yade::elastoplastic_input(InputNotes& notes) const { return yade_luding(notes); }

std::string Yade::matrix_input(const MaterialMatrix& matrix) const { return yade_matrix(matrix); }

std::string Yade::elastoplastic_matrix_input(const MaterialMatrix& matrix) const {
  return yade_luding_matrix(matrix);
}

std::vector<std::pair<std::string, std::string>> Yade::box_files(const MaterialMatrix& matrix,
                                                                 const ParticleBox& box) const {
  return yade_box(matrix, box, matrix_file());
}

namespace engines {
std::unique_ptr<WrittenEngine> make_yade() { return std::make_unique<Yade>(); }
}  // namespace engines

}  // namespace asperity
