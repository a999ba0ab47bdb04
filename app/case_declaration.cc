#include "app/case_declaration.h"

#include "app/case_entry_kinds.h"
#include "app/case_film.h"
#include "app/case_interface.h"
#include "app/case_times.h"
#include "core/experiment_declaration.h"
#include "core/motion_program.h"
#include "fem/materials/material_law.h"

namespace asperity {
namespace {

CaseEntry topography(std::string section, const Member<TopographySpec>& member) {
  return {
      std::move(section),
      "Topography",
      "smooth",
      "",
      "smooth | FILE | scan(FILE, size=2.5 um, channel=Height, unit=nm, level=plane, cutoff=80 nm, "
      "outside=mirror) | "
      "generated(rms=1.5 nm, window=2.5 um, hurst=0.8, rolloff=200 nm, cutoff=20 nm, size=10 um, seed=3)",
      "Roughness of the surface: none, a measured scan, or a Gaussian surface from a spectrum. FILE: in any "
      "format of "
      "`asperity surface measure`; a relative name is looked for beside the case file; the scan's centre is "
      "the centre of "
      "contact. Arguments of scan, each optional: size, where the file lacks it; channel, by name or number; "
      "unit of heights, "
      "where the file names none; level, what is taken off (mean, plane, quadratic, rows0, rows1, rows2; "
      "default plane); "
      "cutoff, below which waves are taken out (default: none are; a mesh needs four cells over the shortest "
      "wave, which without cutoff "
      "is the one above which 99 % of the scan's slope variance lies, but no less than four pixels); "
      "outside, for a scan smaller than "
      "the contact region: refuse (default), or mirror, continued by its mirror images. "
      "Arguments of generated but rms are optional: with window, rms is what scans of that side (512 x 512 "
      "pixels, plane "
      "removed) show on average; without, it is that of the whole surface. The surface is decided by these "
      "arguments alone: it is periodic "
      "with size, by default 64 rolloffs or what 2048 pixels carry, and repeats in regions that are larger.",
      [=](CaseInput& input, const std::string& text) { member(input) = text; }};
}

CaseEntry motion_program(std::string section) {
  return {std::move(section),
          "Program",
          "none",
          "",
          "none | parts separated by ';' of motions joined by 'and': press LOAD, slide LENGTH, slide across "
          "LENGTH, roll ANGLE or LENGTH, "
          "spin ANGLE, indenter LENGTH, hold TIME; 'at SPEED in N steps', either or both, ends a part",
          "Motions one after the other, or several at once, after the particle was pressed to Normal load "
          "(Type = program), e.g. "
          "slide 200 nm and spin 20 mrad; press 50 uN; roll 30 mrad in 12 steps. press: to a load (an "
          "approach with Control = "
          "displacement) up to the first one; slide: along x, across: along y; roll: about y, by an angle or "
          "the arc's length, free of lateral force unless "
          "the part also slides; spin: about the normal; indenter: rolls freely under a plane on top that "
          "moves by LENGTH, an arc of half of it; hold: "
          "lasts a time, at rest in steps that last twice as long each. Without it a part moves at the speed "
          "that it or Speed says.",
          [](CaseInput& input, const std::string& text) {
            const std::string program = text == "none" ? "" : text;
            parse_motion_program(program);
            input.experiment.program = program;
          }};
}

/// Entries that both bodies have.
void add_body(std::vector<CaseEntry>& entries, const std::string& section, BodyInput CaseInput::*body,
              const std::string& modulus_example, const std::string& ratio_example) {
  const auto at = [body](auto BodyInput::*member) {
    return [=](CaseInput & input) -> auto& { return input.*body.*member; };
  };
  entries.push_back(quantity(section, "Young modulus", at(&BodyInput::youngs_modulus), Dimension::pressure,
                             positive, "", modulus_example, "Young's modulus E."));
  entries.push_back(quantity(section, "Poisson ratio", at(&BodyInput::poisson_ratio), Dimension::none,
                             {0, 0.5, false, true}, "", ratio_example, "Poisson's ratio nu."));
  for (const auto& parameter : parameters_of(fem::material_laws()))
    entries.push_back(law_entry(section, parameter, at(&BodyInput::parameters)));
  add_film(entries, section, body);
  entries.push_back(topography(section, at(&BodyInput::topography)));
}

/// Motions that asperity knows, and experiments that are programs of them.
CaseEntry experiment_type(const std::string& section) {
  std::vector<std::pair<std::string, Motion>> types;
  for (const Motion motion :
       {Motion::normal, Motion::sliding, Motion::rolling, Motion::torsion, Motion::program})
    types.emplace_back(name_of(motion), motion);
  for (const auto& declared : declared_experiments()) types.emplace_back(declared.name, Motion::program);
  CaseEntry entry = choice<Motion>(
      section, "Type", [](CaseInput& input) -> Motion& { return input.experiment.type; }, types, "normal",
      "How the particle is moved after the normal load is applied; program: as Program says.");
  entry.store = [store = entry.store](CaseInput& input, const std::string& text) {
    store(input, text);
    input.experiment.declared = is_declared_experiment(text) ? text : "";
  };
  return entry;
}

/// What presses: the normal load or approach, its steps and cycles.
void add_loading(std::vector<CaseEntry>& entries) {
  const auto at = [](auto ExperimentInput::*member) {
    return [=](CaseInput & input) -> auto& { return input.experiment.*member; };
  };
  using Control = ExperimentInput::Control;
  const std::string section = "Experiment";
  entries.push_back(experiment_type(section));
  entries.push_back(choice<Control>(section, "Control", at(&ExperimentInput::control),
                                    {{"force", Control::force}, {"displacement", Control::displacement}},
                                    "force", "Whether Normal load or Normal approach is prescribed."));
  entries.push_back(quantity(section, "Normal load", at(&ExperimentInput::normal_load), Dimension::force,
                             not_negative, "0 N", "1 mN", "Largest normal force (control by force)."));
  entries.push_back(quantity(section, "Normal approach", at(&ExperimentInput::normal_approach),
                             Dimension::length, not_negative, "0 m", "",
                             "Largest approach of the bodies (control by displacement)."));
  entries.push_back(not_physical(whole_number(section, "Load steps", at(&ExperimentInput::load_steps), 1,
                                              "10", "Steps from zero to the largest load.")));
  entries.push_back(not_physical(quantity(
      section, "Load step error", at(&ExperimentInput::load_step_error), Dimension::none, not_negative,
      "0.005", "",
      "Share of the approach that finite steps may leave: a step of bodies that yield which leaves more is "
      "divided, into 16 at most; 0: steps stay as they are.")));
  entries.push_back(
      flag(section, "Unload", at(&ExperimentInput::unload), "true", "Return to zero load after loading."));
  entries.push_back(
      quantity(section, "Retract", at(&ExperimentInput::retract), Dimension::length, not_negative, "0 m", "",
               "How far beyond first touch unloading goes on under control by displacement: for pull-off."));
  entries.push_back(not_physical(whole_number(section, "Unload steps", at(&ExperimentInput::unload_steps), 1,
                                              "10", "Steps from the largest load to zero.")));
  entries.push_back(whole_number(section, "Cycles", at(&ExperimentInput::cycles), 1, "1",
                                 "Cycles of loading and unloading; above 1 needs Unload = true."));
  entries.push_back(not_physical(whole_number(section, "Hold steps", at(&ExperimentInput::hold_steps), 0, "0",
                                              "Steps at the largest load before unloading.")));
}

/// What moves the loaded particle.
void add_motion(std::vector<CaseEntry>& entries) {
  const auto at = [](auto ExperimentInput::*member) {
    return [=](CaseInput & input) -> auto& { return input.experiment.*member; };
  };
  const std::string section = "Experiment";
  entries.push_back(quantity(
      section, "Distance", at(&ExperimentInput::distance), Dimension::length, not_negative, "0 m", "",
      "Path length of sliding and rolling in one direction; 0: five radii of Hertz' contact, six where it "
      "rolls, two contact diameters of them steady (five and three radii of a contact wider than 0.07 of the "
      "sphere's radius), or one radius less of a contact that a film or attraction widens by more."));
  entries.push_back(quantity(
      section, "Angle", at(&ExperimentInput::angle), Dimension::angle, not_negative, "0 rad", "",
      "Angle of torsion in one direction; 0: six times that at which a smooth contact slips as a whole, or "
      "four times that of one that attraction draws together, where it is more."));
  entries.push_back(flag(section, "Reverse", at(&ExperimentInput::reverse), "true",
                         "Come back along the path: half a friction loop."));
  entries.push_back(
      quantity(section, "Return distance", at(&ExperimentInput::return_distance), Dimension::length,
               not_negative, "0 m", "",
               "How far sliding and rolling come back with Reverse = true; 0: to where they "
               "began. A contact radius is enough for the rolling stiffness: where the surface was rolled "
               "over before, the conservative topographic part of the moment cancels."));
  entries.push_back(motion_program(section));
  for (const auto& parameter : parameters_of(declared_experiments()))
    entries.push_back(law_entry(section, parameter, at(&ExperimentInput::parameters)));
  entries.push_back(not_physical(whole_number(
      section, "Motion steps", at(&ExperimentInput::motion_steps), 0, "0",
      "Equal steps of the motion in one direction; 0: fine steps where slip begins and after the reversal, "
      "then an interface spacing or an eighth of Hertz' contact radius (a twentieth where smooth bodies of "
      "two materials roll), whichever is less; half a spacing at the rim of a contact that spins.")));
}

void add_mesh_solver_output(std::vector<CaseEntry>& entries) {
  const auto first = static_cast<std::ptrdiff_t>(entries.size());
  entries.push_back(quantity(
      "Mesh", "Interface spacing", [](CaseInput& c) -> double& { return c.mesh.interface_spacing; },
      Dimension::length, not_negative, "0 m", "",
      "Node spacing in the potential contact zone; 0: a twelfth of Hertz' contact radius (that of Derjaguin, "
      "Muller & Toporov where surfaces attract), a quarter of the "
      "roughness' shortest wave or a third of the zone of attraction, whichever is least (the largest "
      "pressure then reads 10 to 25 % too small, with an eighth of a wave some 2 %; real area is good to "
      "some 7 %, the pull-off force 4 % too large; result.json states the errors)."));
  entries.push_back(quantity(
      "Mesh", "Contact region", [](CaseInput& c) -> double& { return c.mesh.contact_region; },
      Dimension::length, not_negative, "0 m", "",
      "Half width of the finely meshed square; 0: derived from load, roughness and attraction."));
  entries.push_back(whole_number(
      "Mesh", "Layers", [](CaseInput& c) -> int& { return c.mesh.layers; }, 1, "4",
      "Cells of each refinement level below the interface: the grading."));
  entries.push_back(choice<std::string>(
      "Mesh", "Sphere", [](CaseInput& c) -> std::string& { return c.mesh.sphere; },
      {{"hemisphere", "hemisphere"}, {"full", "full"}}, "hemisphere",
      "Part of the particle that is meshed: the lower half, driven at its equator, or all of "
      "it, glued over the square of half width 0.45 R at its top."));
  entries.push_back(choice<std::string>(
      "Mesh", "Fine along path", [](CaseInput& c) -> std::string& { return c.mesh.along_path; },
      {{"travelling", "travelling"}, {"whole", "whole"}}, "travelling",
      "Where a contact that rolls or slides finds fine cells: around it and some way ahead, made anew as it "
      "goes (what has yielded keeps its cells), if that saves three tenths of the unknowns; or on the whole "
      "path all the time."));
  entries.push_back(choice<std::string>(
      "Solver", "Backend", [](CaseInput& c) -> std::string& { return c.solver.backend; },
      {{"matrix-free", "matrix-free"}, {"assembled", "assembled"}}, "matrix-free",
      "Matrix-free operators with geometric multigrid, or assembled matrices with "
      "algebraic multigrid."));
  entries.push_back(quantity(
      "Solver", "Tolerance", [](CaseInput& c) -> double& { return c.solver.tolerance; }, Dimension::none,
      {0, 1e-2, true, false}, "1e-6", "",
      "Residual force of an accepted step relative to the contact force."));
  entries.push_back(whole_number(
      "Solver", "Newton steps", [](CaseInput& c) -> int& { return c.solver.newton_steps; }, 1, "60",
      "Newton iterations after which a step is given up, halved and tried again from the last accepted "
      "state; ten times as many with adhesion, where contacts jump."));
  entries.push_back(whole_number(
      "Solver", "Threads", [](CaseInput& c) -> int& { return c.solver.threads; }, 0, "0",
      "Threads of each process; 0: all cores, divided by the processes of this machine."));
  entries.push_back(flag(
      "Output", "Fields", [](CaseInput& c) -> bool& { return c.output.fields; }, "true",
      "Write the fields for ParaView (VTU and PVD of the bodies, VTP of the interface)."));
  entries.push_back(whole_number(
      "Output", "Fields every", [](CaseInput& c) -> int& { return c.output.fields_every; }, 0, "0",
      "Steps between files of fields; 0: ten of them, even in load or path. The largest load and the last "
      "step "
      "always have some."));
  for (auto entry = entries.begin() + first; entry != entries.end(); ++entry) entry->is_physical = false;
}

std::vector<CaseEntry> declare_entries() {
  std::vector<CaseEntry> entries;
  entries.push_back(not_physical(
      {"", "Title", "untitled", "", "a text", "Name of the case in reports.",
       [](CaseInput& input, const std::string& text) { input.title = text == "untitled" ? "" : text; }}));
  entries.push_back(quantity(
      "Particle", "Radius", [](CaseInput& c) -> double& { return c.radius; }, Dimension::length, positive, "",
      "8.5 um", "Radius R of the sphere."));
  add_body(entries, "Particle", &CaseInput::particle, "71 GPa", "0.17");
  add_body(entries, "Substrate", &CaseInput::substrate, "179 GPa", "0.25");
  add_interface(entries);
  add_loading(entries);
  add_motion(entries);
  add_times(entries);
  add_mesh_solver_output(entries);
  return entries;
}

}  // namespace

const std::vector<CaseSection>& case_sections() {
  static const std::vector<CaseSection> sections{
      {"", "Entries outside of subsections."},
      {"Particle", "The sphere, an elastic-plastic body (J2 plasticity, small strain)."},
      {"Substrate", "The plane, an elastic-plastic body."},
      {"Interface", "The laws at a point of the interface."},
      {"Experiment", "How the particle is loaded and moved."},
      {"Mesh", "Resolution at the interface; it is coarse away from it."},
      {"Solver", "How the equations are solved; the answer does not depend on it."},
      {"Output", "What is written beside result.json and history.csv."}};
  return sections;
}

const std::vector<CaseEntry>& case_entries() {
  static const std::vector<CaseEntry> entries = declare_entries();
  return entries;
}

}  // namespace asperity
