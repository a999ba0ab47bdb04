// A mesh that is fine around the contact only, and travels with it, against one that is fine on the whole
// path. ctest runs these tests under mpirun too.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/case/fine_path.h"
#include "fem/contact/carried_state.h"
#include "fem/contact/contact_solver.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using namespace asperity::fem;
using asperity::test::generated;

/// Rough bodies, the asperities yield, under adhesion with hysteresis and friction.
CaseInput long_path(Motion motion, const std::string& along_path) {
  CaseInput input = test::sphere_on_silicon("smooth", generated(1.0, 160, 3), 48e-9, 500e-9);
  input.interface.parameters["Friction coefficient"] = 0.3;
  input.interface.work_of_adhesion = 0.05, input.interface.work_of_separation = 0.1;
  input.interface.adhesion_law = "exponential", input.interface.parameters["Adhesion range"] = 2e-9;
  input.particle.parameters["Yield stress"] = 1.5e9, input.substrate.parameters["Yield stress"] = 2e9;
  input.experiment.type = motion;
  input.experiment.load_steps = 3;
  input.experiment.unload = false;
  input.experiment.distance = 1000e-9;
  input.experiment.motion_steps = 20;
  input.mesh.along_path = along_path;
  input.output.fields = false;
  return input;
}

FinePath path_of(const CaseInput& input) {
  const CaseSetup setup = set_up(input);
  return FinePath(input, setup, make_program(input.experiment, setup.motion));
}

TEST(FinePath_behaviour, travels_where_that_saves_enough_and_the_case_lets_it) {
  CaseInput input = long_path(Motion::rolling, "travelling");
  const FinePath rolling = path_of(input);
  EXPECT_TRUE(rolling.travels());
  EXPECT_LT(rolling.share_at_a_time(), 0.7);
  input.experiment.distance = 100e-9;
  EXPECT_FALSE(path_of(input).travels());
  EXPECT_FALSE(path_of(long_path(Motion::rolling, "whole")).travels());
  EXPECT_FALSE(path_of(long_path(Motion::normal, "travelling")).travels());
}

TEST(FinePath_behaviour, holds_the_contact_from_where_it_is_to_some_way_ahead_on_both_bodies) {
  const FinePath path = path_of(long_path(Motion::rolling, "travelling"));
  const double R = 8.5e-6;
  const auto rolled = [&](double x) { return RigidMotion{x, 0, 0, x / R}; };
  const FineParts parts = path.onwards(rolled(100e-9), rolled(150e-9));
  EXPECT_TRUE(path.holds(parts, rolled(100e-9)));
  EXPECT_TRUE(path.holds(parts, rolled(200e-9)));
  EXPECT_FALSE(path.holds(parts, rolled(90e-9)));
  EXPECT_FALSE(path.holds(parts, rolled(400e-9)));
  const FineParts back = path.onwards(rolled(100e-9), rolled(50e-9));
  EXPECT_TRUE(path.holds(back, rolled(0)));
  EXPECT_FALSE(path.holds(back, rolled(110e-9)));
}

/// Calls visit(index of the unknown, logical coordinate) for all unknowns of owned nodes of the cap and the
/// block.
template <typename Visit>
void for_coordinates(const ContactSystem& system, const Visit& visit) {
  const int owned = static_cast<int>(system.positions().locally_owned_size());
  for (const auto& cell : system.level().dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const auto box = meshing::logical_box(cell);
    if (box.tree != meshing::cap && box.tree != meshing::block) continue;
    const auto [batch, lane] = system.level().place_of(cell->active_cell_index());
    for (int v = 0; v < 8; ++v)
      for (int c = 0; c < 3; ++c) {
        const int dof = 3 * system.level().batches()[batch].node[v][lane] + c;
        if (dof < owned) visit(dof, box.vertex(v)[c]);
      }
  }
}

/// A state that is carried to another mesh and back again.
struct Carried {
  double away = 0;       ///< largest error of the displacement, which is the place in the lattice
  double strain = 0;     ///< sum of equivalent plastic strains over the points of the other mesh
  double changed = 0;    ///< largest change of a pressure that came back [Pa]
  std::size_t lost = 0;  ///< pressures that did not
};

Carried carried_there_and_back(MPI_Comm communicator) {
  const CaseInput input = long_path(Motion::rolling, "travelling");
  ContactSystemOptions options = set_up(input).system;
  options.mesh.fine = {meshing::FinePart{-500e-9, -350e-9}, meshing::FinePart{-500e-9, -350e-9}};
  ContactSystem here(communicator, options);
  ContactState state = ContactSolver(here, {}).first_touch();
  for_coordinates(here,
                  [&](int dof, double coordinate) { state.displacement.local_element(dof) = coordinate; });
  state.displacement.update_ghost_values();
  for (std::size_t r = 0; r < here.rows().size(); ++r) state.multiplier[r] = 1e9 + static_cast<double>(r);
  // What yields lies under the contact.
  for (const auto& cell : here.level().dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const auto box = meshing::logical_box(cell);
    const auto centre = here.geometry().position(box.tree, box.centre());
    if (std::hypot(centre[0] + 500e-9, centre[1], centre[2]) > 200e-9) continue;
    PlasticBodies::CellHistory history{};
    for (auto& point : history) point[6] = 1e-3;
    const auto [batch, lane] = here.level().place_of(cell->active_cell_index());
    here.bodies().take_history_of_cell(batch, lane, history);
  }
  const CarriedState taken_along(here, state, {});

  options.mesh.fine = {meshing::FinePart{-300e-9, -150e-9}, meshing::FinePart{-300e-9, -150e-9}};
  options.mesh.kept = taken_along.yielded();
  ContactSystem there(communicator, options);
  const ContactState on_the_other = taken_along.taken_by(there, ContactSolver(there, {}).first_touch()).state;
  Carried result;
  const auto compare = [&](const ContactSystem& system, const ContactState& with) {
    for_coordinates(system, [&](int dof, double coordinate) {
      result.away = std::max(result.away, std::abs(with.displacement.local_element(dof) - coordinate));
    });
  };
  compare(there, on_the_other);
  for (const auto& cell : there.level().dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const auto [batch, lane] = there.level().place_of(cell->active_cell_index());
    if (const auto history = there.bodies().history_of_cell(batch, lane))
      for (const auto& point : *history) result.strain += point[6];
  }
  const ContactState back = CarriedState(there, on_the_other, {}).taken_by(here, state).state;
  compare(here, back);
  for (std::size_t r = 0; r < here.rows().size(); ++r)
    if (back.multiplier[r] != 0)
      result.changed = std::max(result.changed, std::abs(back.multiplier[r] - state.multiplier[r]));
    else
      ++result.lost;
  result.strain = dealii::Utilities::MPI::sum(result.strain, communicator);
  result.away = dealii::Utilities::MPI::max(result.away, communicator);
  return result;
}

TEST(ParallelCarriedState_behaviour, comes_back_from_another_mesh_and_is_the_same_on_all_ranks) {
  const Carried one = carried_there_and_back(MPI_COMM_SELF), all = carried_there_and_back(MPI_COMM_WORLD);
  for (const Carried* carried : {&one, &all}) {
    // What is linear in the lattice, trilinear cells of any size hold.
    EXPECT_LT(carried->away, 1e-14);
    EXPECT_EQ(carried->changed, 0);
    EXPECT_GT(carried->lost, 0u);  // those behind the other mesh's fine cells
  }
  EXPECT_GT(one.strain, 0);
  EXPECT_NEAR(all.strain, one.strain, 1e-12 * one.strain);
  EXPECT_EQ(all.lost, one.lost);
}

/// Largest difference of a column, of the largest value of `of`.
double difference(const test::SolvedExperiment& one, const test::SolvedExperiment& other,
                  const std::string& column, const std::string& of) {
  const auto a = one.history.numbers(column), b = other.history.numbers(column),
             unit = one.history.numbers(of);
  EXPECT_EQ(a.size(), b.size());
  double largest = 0, whole = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    largest = std::max(largest, std::abs(a[k] - b[k]));
    whole = std::max(whole, std::abs(unit[k]));
  }
  return largest / whole;
}

void expect_same(const std::string& what, const test::SolvedExperiment& whole,
                 const test::SolvedExperiment& travelling) {
  const auto verified = [&](const std::string& column, const std::string& of, double asked) {
    const test::Verified row{"Meshes", "travelling: " + what + ": " + column,
                             "a mesh fine on the whole path"};
    EXPECT_TRUE(row.below(100 * difference(whole, travelling, column, of), 100 * asked, "%"));
  };
  verified("normal_displacement [m]", "normal_displacement [m]", 1e-3);
  verified("contact_area [m^2]", "contact_area [m^2]", 1e-3);
  verified("lateral_force [N]", "normal_force [N]", 1e-3);
  verified("rolling_moment [N m]", "rolling_moment [N m]", 1e-3);
  verified("friction_work [J]", "friction_work [J]", 1e-3);
  verified("plastic_work [J]", "plastic_work [J]", 1e-3);
  verified("plastic_volume [m^3]", "plastic_volume [m^3]", 1e-2);
  verified("adhesion_loss [J]", "adhesion_loss [J]", 1e-3);
  const test::Verified energy{"Meshes",
                              "travelling: " + what + ": energy left open, beside that of the other",
                              "a mesh fine on the whole path"};
  const auto left_open = [](const test::SolvedExperiment& s) {
    return s.result["balance"]["energy"].get<double>();
  };
  EXPECT_TRUE(energy.below(100 * (left_open(travelling) - left_open(whole)), 0.1, "%"));
  for (const auto* solved : {&whole, &travelling})
    EXPECT_FALSE(solved->result["mesh"]["contact_reaches_rim"].get<bool>());
  // Cells and unknowns are of the same mesh, the largest.
  const auto share = [&](const char* of) {
    return travelling.result["mesh"][of].get<double>() / whole.result["mesh"][of].get<double>();
  };
  EXPECT_LT(share("dofs"), 0.85);
  EXPECT_NEAR(share("cells"), share("dofs"), 0.02);
}

TEST(TravellingMesh_behaviour,
     of_a_rolling_contact_that_comes_back_over_its_own_track_gives_the_same_and_resumes) {
  const test::TemporaryFolder folder;
  CaseInput input = long_path(Motion::rolling, "whole");
  input.experiment.motion_steps = 14;
  input.experiment.return_distance = 200e-9;
  const auto whole = test::solve_experiment(input, folder.path / "whole");
  input.mesh.along_path = "travelling";
  const auto travelling =
      test::solve_and_copy_after(input, folder.path / "travelling", folder.path / "cut", 12);
  expect_same("rolling out and back over the track, rough, yielding, adhesive", whole, travelling);
  const auto resumed = test::solve_experiment(input, folder.path / "cut", true);
  EXPECT_LT(difference(travelling, resumed, "rolling_moment [N m]", "rolling_moment [N m]"), 1e-5);
  EXPECT_LT(difference(travelling, resumed, "normal_displacement [m]", "normal_displacement [m]"), 1e-6);
}

TEST(TravellingMeshNightly_behaviour, of_a_sliding_contact_that_turns_gives_the_same) {
  const test::TemporaryFolder folder;
  CaseInput input = long_path(Motion::sliding, "whole");
  input.experiment.reverse = true;
  input.experiment.distance = 1600e-9;
  input.experiment.motion_steps = 12;
  const auto whole = test::solve_experiment(input, folder.path / "whole");
  input.mesh.along_path = "travelling";
  expect_same("sliding out and back, rough, yielding, adhesive", whole,
              test::solve_experiment(input, folder.path / "travelling"));
}

}  // namespace
