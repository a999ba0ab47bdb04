// asperity on the problem of deal.II's tutorial step-42: a rigid sphere of radius 0.6 is pressed 0.01 deep
// into the unit cube (E 200000, nu 0.3), fixed at its bottom.
//
// What is the same: cube, sphere, depth, friction (none), material. The tutorial's law, dev(sigma) = (gamma +
// (1 - gamma) sigma_0 / |2 mu dev(eps)|) 2 mu dev(eps) once |2 mu dev(eps)| > sigma_0, is what the radial
// return gives in one step from the virgin state with yield stress sqrt(3/2) sigma_0 and hardening modulus 3
// mu gamma / (1 - gamma): a single step is taken. What is not: the sphere is a body 1000 times stiffer; the
// cube's sides are free, while the tutorial's slide in their planes (its variant step_42_free_sides does not
// hold them either); elements have mean dilatation.
#include <deal.II/base/mpi.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "fem/contact/contact_solver.h"
#include "fem/materials/hardening/linear_and_voce.h"

namespace {

using namespace asperity::fem;

constexpr double youngs_modulus = 200000, poisson_ratio = 0.3, sigma_0 = 400, gamma_hardening = 0.01;
constexpr double sphere_radius = 0.6, depth = 0.01, cube_half_width = 0.5;
constexpr double stiffness_of_sphere = 1000;  // over the cube's

J2Material material_of_cube() {
  J2Material m = J2Material::elastic(youngs_modulus, poisson_ratio);
  m.yield_stress = std::sqrt(1.5) * sigma_0;
  m.hardening =
      std::make_shared<LinearAndVoce>(3 * m.shear_modulus * gamma_hardening / (1 - gamma_hardening));
  return m;
}

ContactSystemOptions options_for(double spacing, double layers) {
  ContactSystemOptions o;
  auto& s = o.mesh.sizes;
  s.radius = sphere_radius;
  s.block_half_width = cube_half_width;
  // Pressures live on the sphere's nodes: the softer body must be the finer mesh (docs/verification.md).
  constexpr double sphere_over_cube = 1 / 0.7;
  s.spacing_substrate = spacing;
  s.spacing_particle = sphere_over_cube * spacing;
  const double largest_contact =
      std::sqrt(2 * sphere_radius * depth);  // where the undeformed surface cuts the sphere
  s.region_particle = std::max(1.1 * largest_contact, 3.1 * s.spacing_particle);
  s.region_substrate = s.region_particle + 3 * spacing;
  o.mesh.layers = layers;
  o.materials = {J2Material::elastic(stiffness_of_sphere * youngs_modulus, poisson_ratio),
                 material_of_cube()};
  o.control = Control::displacement;
  return o;
}

void solve(double spacing, double layers, bool talk) {
  const auto began = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  ContactSystem system(MPI_COMM_WORLD, options_for(spacing, layers));
  const double set_up = seconds();
  ContactSolver solver(system, {});
  if (talk) solver.log = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  ContactState state = solver.first_touch();
  const SolveReport report = solver.solve(state, depth);
  if (!report.converged) throw asperity::WorkError("no equilibrium found");
  const ContactResultants r = solver.resultants(state);
  long in_cube = 0;
  for (const auto& batch : system.level().batches())
    for (int l = 0; l < batch.count; ++l) in_cube += batch.body[l] == 1;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const nlohmann::json result{{"unknowns", system.level().size()},
                              {"cells_of_cube", in_cube},
                              {"spacing", spacing},
                              {"newton", report.newton},
                              {"cg", report.linear},
                              {"contact_force", r.force},
                              {"reaction", r.reaction_fixed},
                              {"contact_area", r.area},
                              {"closed_nodes", r.active},
                              {"set_up_time", set_up},
                              {"wall_time", seconds()},
                              {"peak_memory", 1024.0 * static_cast<double>(usage.ru_maxrss)}};
  std::printf("%s\n", result.dump().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  double spacing = 1.0 / 32, layers = 2;
  int threads = 1;
  bool talk = false;
  CLI::App app{
      "A rigid sphere pressed into the unit cube, the problem of deal.II's step-42; prints one line of JSON"};
  app.add_option("--spacing", spacing, "Node spacing of the cube's surface at the contact")
      ->capture_default_str();
  app.add_option("--layers", layers, "Cells of each refinement level below the interface; 200: uniform mesh")
      ->capture_default_str();
  app.add_option("--threads", threads, "Threads")->capture_default_str();
  app.add_flag("--talk", talk, "Iterations on the error stream");
  CLI11_PARSE(app, argc, argv);
  try {
    const dealii::Utilities::MPI::MPI_InitFinalize session(argc, argv, static_cast<unsigned>(threads));
    solve(spacing, layers, talk);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sphere_on_cube: %s\n", error.what());
    return 1;
  }
  return 0;
}
