#include "engines/lammps_script.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engines/text_number.h"

namespace asperity {
namespace {

/// Rows of trace.csv from here on: `expressions` of the columns behind leg and time.
struct TraceExpressions {
  std::string drive, response, particle = "0", rotation_rate = "0", normal_force, approach;
};

/// The script in the order LAMMPS wants it.
class Script {
 public:
  Script(const EngineExperiment& experiment, const MotionPlan& plan, const Lammps& lammps)
      : e_(experiment), plan_(plan), lammps_(lammps), R_(experiment.substrate.particle.radius) {}

  std::string text() {
    header();
    switch (e_.type) {
      case Motion::sliding:
        glued();
        break;
      case Motion::rolling:
        rolling();
        break;
      case Motion::rail:
        rail();
        break;
      case Motion::torsion:
        twisting();
        break;
      case Motion::normal:
      case Motion::program:
        break;  // no experiment of one particle
    }
    return out_.str();
  }

 private:
  using N = std::string;
  static N number(double value) { return text_number(value); }

  bool is_free() const { return e_.type == Motion::rolling || e_.type == Motion::rail; }

  void header() {
    out_ << "# asperity: " << engine_experiment_name(e_.type) << ", one sphere, normal load "
         << number(e_.load) << " N; SI units\n"
         << "units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify vel "
            "yes\n";
  }

  /// A sphere at a height; box wide enough for its way.
  void sphere(double height) {
    const double half = 4 * R_ + 4 * e_.amplitude;
    out_ << "region box block " << number(-half) << ' ' << number(half) << ' ' << number(-half) << ' '
         << number(half) << ' ' << number(-R_) << ' ' << number(6 * R_) << " units box\ncreate_box 1 box\n"
         << "create_atoms 1 single 0 0 " << number(height) << " units box\n"
         << "set atom 1 diameter " << number(2 * R_) << " density " << number(e_.substrate.particle.density)
         << "\n"
         << "neighbor " << number(R_ / 8) << " bin\n"
         << "pair_style granular\npair_coeff * * hertz 1 0 tangential linear_nohistory 0 0  # there is no "
            "second sphere\n"
         << "timestep " << number(plan_.time_step) << "\n";
  }

  std::string contact(const ContactParameters& parameters, double load) const {
    LammpsContact law = lammps_contact(parameters, load);
    law.normal_damping = e_.type == Motion::torsion ? 0 : plan_.damping / parameters.contact_radius(load);
    law.tangential_damping = is_free() ? 1 : 0;
    if (lammps_.marshall) law.torsion_stiffness = 0;
    return lammps_text(law, lammps_.tangential_style) + (lammps_.marshall ? " twisting marshall" : "");
  }

  void trace(const TraceExpressions& columns) {
    out_ << "variable time equal step*dt\n"
         << "variable drive equal " << columns.drive << "\nvariable response equal " << columns.response
         << "\n"
         << "variable particle equal " << columns.particle << "\nvariable rotation_rate equal "
         << columns.rotation_rate << "\n"
         << "variable normal_force equal " << columns.normal_force << "\nvariable approach equal "
         << columns.approach << "\n"
         << "thermo_style custom step v_drive v_response v_normal_force\nthermo_modify lost error\n"
         << "print \"" << trace_header() << "\" file trace.csv\n";
  }

  /// One row of the trace; `leg` is its number or the variable that has it.
  static std::string rows_every(long every, const std::string& leg, std::size_t first) {
    return "fix out all print " + std::to_string(every) + " \"" + leg +
           ",${time},${drive},${response},${particle},${rotation_rate},${normal_force},${approach}\" append "
           "trace.csv screen no title \"# leg " +
           std::to_string(first + 1) + "\"\n";
  }

  /// Runs all legs; `move` gives the commands that set a leg's speed, from speed, drive and step at its
  /// start.
  template <class Move>
  void run_legs(const Move& move) {
    double drive = 0;
    long step = 0;
    for (std::size_t i = 0; i < plan_.legs.size(); ++i) {
      const Leg& leg = plan_.legs[i];
      out_ << "# leg " << i + 1 << ": " << number(leg.distance) << " at " << number(plan_.speed(leg))
           << " per second\n"
           << move(plan_.speed(leg), drive, step) << "thermo " << leg.steps << "\n"
           << rows_every(leg.every, std::to_string(i), i) << "run " << leg.steps << "\nunfix out\n";
      drive += leg.distance;
      step += leg.steps;
    }
  }

  /// The same without the set-up before each leg, which evaluates the contact with the new speed and the old
  /// history: at the limit of "twisting sds" a sign that has turned then throws the torque to the other
  /// limit, or not, by rounding.
  template <class Move>
  void run_legs_in_one_go(const Move& move) {
    double drive = 0;
    long step = 0, every = plan_.legs.front().every;
    for (const Leg& leg : plan_.legs) every = std::min(every, leg.every);
    for (std::size_t i = 0; i < plan_.legs.size(); ++i) {
      const Leg& leg = plan_.legs[i];
      out_ << "# leg " << i + 1 << ": " << number(leg.distance) << " at " << number(plan_.speed(leg))
           << " per second\n"
           << move(plan_.speed(leg), drive, step) << "variable leg equal " << i << "\nthermo " << leg.steps
           << "\n"
           << (i ? "" : rows_every(every, "${leg}", i)) << "run " << leg.steps << (i ? " pre no" : "")
           << "\n";
      drive += leg.distance;
      step += leg.steps;
    }
    out_ << "unfix out\n";
  }

  void glued() {
    sphere(R_ - e_.substrate.hertz().approach(e_.load));
    out_ << "fix substrate all wall/gran granular " << contact(e_.substrate, e_.load)
         << " zplane 0 NULL contacts\n"
         << "fix load all addforce 0 0 " << number(-e_.load) << "\n"
         << "fix hold all setforce 0 0 NULL  # what it holds is the lateral force of the substrate\n"
         << "fix move all nve  # without rotation: glued\nvelocity all set 0 0 0\n";
    trace({"x[1]", "-f_hold[1]", "x[1]", "0", "f_substrate[1][4]", number(R_) + "-z[1]"});
    run_legs([](double speed, double, long) { return "velocity all set " + number(speed) + " 0 NULL\n"; });
  }

  /// The plate moves by its own clock; its height keeps the gap, so that the load is constant as long as it
  /// only translates.
  std::string plate(double height) const {
    return "variable plate equal 0\nregion plate plane 0 0 " + number(height) +
           " 0 0 -1 move v_plate NULL NULL units box\nfix plate all wall/gran/region granular " +
           contact(e_.indenter, e_.indenter_load()) + " region plate contacts\n";
  }

  void run_plate_legs() {
    run_legs([](double speed, double drive, long step) {
      return "variable plate equal \"" + number(drive) + " + " + number(speed) + "*(step - " +
             std::to_string(step) + ")*dt\"\n";
    });
  }

  void rolling() {
    const double below = e_.substrate.hertz().approach(e_.load),
                 above = e_.indenter.hertz().approach(e_.load);
    sphere(R_ - below);
    out_ << "fix substrate all wall/gran granular " << contact(e_.substrate, e_.load)
         << " zplane 0 NULL contacts\n"
         << plate(2 * R_ - below - above)
         << "fix move all nve/sphere\ncompute rotation all property/atom omegay\n";
    trace({"v_plate", "f_plate[1][2]", "x[1]", "c_rotation[1]", "f_substrate[1][4]", number(R_) + "-z[1]"});
    run_plate_legs();
  }

  void rail() {
    const double below = e_.substrate.hertz().approach(e_.load),
                 above = e_.indenter.hertz().approach(e_.indenter_load());
    const double c = e_.rail_cosine(), s = std::sin(e_.rail_angle), height = (R_ - below) / c;
    sphere(height);
    out_ << "region left plane 0 0 0 0 " << number(-s) << ' ' << number(c) << " units box\n"
         << "region right plane 0 0 0 0 " << number(s) << ' ' << number(c) << " units box\n";
    for (const char* slope : {"left", "right"})
      out_ << "fix " << slope << " all wall/gran/region granular " << contact(e_.substrate, e_.load)
           << " region " << slope << " contacts\n";
    out_ << plate(height + R_ - above)
         << "fix move all nve/sphere\ncompute rotation all property/atom omegay\n";
    trace({"v_plate", "f_plate[1][2]", "x[1]", "c_rotation[1]", "sqrt(f_left[1][3]^2+f_left[1][4]^2)",
           number(R_) + "-z[1]*" + number(c)});
    run_plate_legs();
  }

  void twisting() {
    sphere(R_ - e_.substrate.hertz().approach(e_.load));
    out_ << "fix substrate all wall/gran granular " << contact(e_.substrate, e_.load)
         << " zplane 0 NULL contacts\n"
         << "compute torque all property/atom tqz  # nothing integrates: the sphere spins in place as it is "
            "told\n"
         << "variable angle equal 0\n";
    trace({"v_angle", "-c_torque[1]", "0", "0", "f_substrate[1][4]", number(R_) + "-z[1]"});
    run_legs_in_one_go([](double speed, double drive, long step) {
      return "set atom 1 omega 0 0 " + number(speed) + "\nvariable angle equal \"" + number(drive) + " + " +
             number(speed) + "*(step - " + std::to_string(step) + ")*dt\"\n";
    });
  }

  const EngineExperiment& e_;
  const MotionPlan& plan_;
  const Lammps& lammps_;
  const double R_;
  std::ostringstream out_;
};

}  // namespace

std::string lammps_script(const EngineExperiment& experiment, const MotionPlan& plan, const Lammps& lammps) {
  return Script(experiment, plan, lammps).text();
}

}  // namespace asperity
