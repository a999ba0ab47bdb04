#include "benchmarks/hot_paths/scene.h"

#include <stdexcept>

#include "app/case_file.h"
#include "fem/case/case_setup.h"

namespace asperity::hot_paths {
namespace {

ContactSystemOptions scene_options() {
  return set_up(
             read_case(ASPERITY_SOURCE_DIR "/benchmarks/rough_contact.prm", {"Mesh/Interface spacing=10 nm"}))
      .system;
}

}  // namespace

std::unique_ptr<Scene> scene;

Scene::Scene()
    : system(std::make_unique<ContactSystem>(MPI_COMM_WORLD, scene_options())),
      exact(system->level(), system->positions(), system->options().materials),
      single(system->level(), system->positions(), system->options().materials) {
  const CaseSetup setup = set_up(
      read_case(ASPERITY_SOURCE_DIR "/benchmarks/rough_contact.prm", {"Mesh/Interface spacing=10 nm"}));
  ContactSolver solver(*system, {});
  state = solver.first_touch();
  solver.push_rigidly(state, 0.8 * setup.hertz_approach);
  if (!solver.solve(state, setup.largest_load).converged)
    throw std::runtime_error("the contact to be measured was not solved");
  for (std::size_t r = 0; r < state.multiplier.size(); ++r)
    stiffness.push_back(state.multiplier[r] > 0
                            ? 8 * system->reduced_modulus() / system->options().mesh.sizes.spacing_particle *
                                  system->areas()[r]
                            : 0.0);
  Vector<double> force = vector<double>();
  system->bodies().internal_force(state.displacement, force, &tangent);
  for (const auto& batch : tangent.batch)
    yielding += batch ? 1.0 / static_cast<double>(tangent.batch.size()) : 0.0;
  system->interface().set_stiffness(stiffness);
  exact.set_interface(&system->interface());
  single.set_interface(&system->interface());
  multigrid().update(stiffness, &tangent, 0.0);
  coarse_forest = meshing::make_forest(MPI_COMM_WORLD, system->options().mesh, 1);
  coarse = std::make_unique<MeshLevel>(*coarse_forest, system->options().control);
}

Multigrid& Scene::multigrid() { return dynamic_cast<MatrixFreeSolver&>(system->linear()).multigrid(); }

}  // namespace asperity::hot_paths
