// The forests on all ranks of MPI are those of one rank. ctest runs these tests under mpirun too.
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "fem/levels/mesh_level.h"
#include "meshing/contact_mesh.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;
using namespace asperity::meshing;

ContactMeshOptions sphere_of_8p5_um(double spacing, bool full) {
  ContactMeshOptions options;
  options.sizes.radius = 8.5e-6;
  options.sizes.full_sphere = full;
  options.sizes.block_half_width = 6e-6;
  options.sizes.spacing_particle = spacing;
  options.sizes.spacing_substrate = 1.13 * spacing;
  options.sizes.region_particle = options.sizes.region_substrate = 0.7e-6;
  return options;
}

/// Unknowns of all ranks that belong to a node of a cell of their own rank.
long unknowns_with_a_cell(const MeshLevel& level) {
  std::set<int> seen;
  const int owned = static_cast<int>(level.partitioner()->locally_owned_size()) / 3;
  for (const auto& batch : level.batches())
    for (const auto& nodes : batch.node)
      for (const int node : nodes)
        if (node < owned) seen.insert(node);
  return dealii::Utilities::MPI::sum(3 * static_cast<long>(seen.size()), level.communicator());
}

/// A neighbour that p4est misses leaves unknowns that no cell of their rank has: the mesh is torn between
/// ranks.
TEST(ParallelForest_behaviour, of_every_level_has_the_cells_and_unknowns_of_one_rank) {
  int levels = 0, other = 0;
  for (const bool full : {false, true})
    for (const double spacing : {40e-9, 60e-9})
      for (int coarsenings = 0; coarsenings < 6; ++coarsenings) {
        const auto options = sphere_of_8p5_um(spacing, full);
        const auto one = make_forest(MPI_COMM_SELF, options, coarsenings),
                   all = make_forest(MPI_COMM_WORLD, options, coarsenings);
        const MeshLevel level_of_one(*one, Control::force), level_of_all(*all, Control::force);
        const bool is_same = all->n_global_active_cells() == one->n_global_active_cells() &&
                             level_of_all.size() == level_of_one.size() &&
                             static_cast<long>(level_of_all.size()) == unknowns_with_a_cell(level_of_all);
        EXPECT_TRUE(is_same) << full << spacing << coarsenings;
        ++levels, other += !is_same;
      }
  EXPECT_EQ(levels, 24);
  const asperity::test::Verified verified{
      "Meshes", "levels with other cells or unknowns than on one rank, or unknowns without a cell, of 24",
      "one rank"};
  EXPECT_TRUE(verified.below(other, 0));
}

/// Cells of a forest that are neither cells of the next coarser one nor children of these.
int torn_cells(const ContactMeshOptions& options, int coarsenings) {
  const auto fine = make_forest(MPI_COMM_SELF, options, coarsenings - 1),
             coarse = make_forest(MPI_COMM_SELF, options, coarsenings);
  std::set<dealii::CellId> known;
  for (const auto& cell : coarse->active_cell_iterators()) known.insert(cell->id());
  int torn = 0;
  for (const auto& cell : fine->active_cell_iterators())
    torn += !known.count(cell->id()) && !(cell->level() > 0 && known.count(cell->parent()->id()));
  return torn;
}

TEST(Forest_behaviour, of_each_level_is_the_next_coarser_one_refined_once_at_most) {
  int torn = 0;
  for (const double region : {0.41e-6, 0.46e-6, 0.512e-6, 0.561e-6})
    for (const double reach : {0.2e-6, 0.384e-6, 0.5e-6}) {
      auto options = sphere_of_8p5_um(32e-9, false);
      options.layers = 2;
      options.sizes.spacing_substrate = 32e-9;
      options.sizes.region_particle = region, options.sizes.region_substrate = region + 96e-9;
      options.sizes.reach_particle = options.sizes.reach_substrate = reach;
      for (int coarsenings = 1; coarsenings < 6; ++coarsenings) torn += torn_cells(options, coarsenings);
    }
  const asperity::test::Verified verified{
      "Meshes", "cells that are more than one refinement from the next coarser level, 12 regions, 5 levels",
      "none"};
  EXPECT_TRUE(verified.below(torn, 0));
}

TEST(Forest_behaviour, that_is_fine_around_the_contact_and_where_cells_are_kept_is_nested_too) {
  auto options = sphere_of_8p5_um(32e-9, false);
  options.layers = 2;
  options.sizes.spacing_substrate = 32e-9;
  options.sizes.region_particle = 0.41e-6, options.sizes.region_substrate = 0.506e-6;
  options.sizes.reach_particle = options.sizes.reach_substrate = 0.9e-6;
  const auto whole = make_forest(MPI_COMM_SELF, options);
  int torn = 0, lost = 0;
  const auto shares_of_whole = [&](double low) {
    options.fine = {FinePart{low, low + 0.1e-6}, FinePart{low, low + 0.1e-6}};
    for (int coarsenings = 1; coarsenings < 6; ++coarsenings) torn += torn_cells(options, coarsenings);
    const auto part = make_forest(MPI_COMM_SELF, options);
    std::set<dealii::CellId> there;
    std::set<CellKey> keys;
    for (const auto& cell : part->active_cell_iterators()) {
      there.insert(cell->id());
      keys.insert(cell_key(logical_box(cell)));
    }
    // What is in the part, is as in the whole.
    const BodyMap map(options.sizes);
    std::vector<LogicalBox> kept;
    for (const auto& cell : whole->active_cell_iterators()) {
      const LogicalBox box = logical_box(cell);
      if (box.tree != cap && box.tree != block) continue;
      const double x = map.aside(box.tree, box.centre())[0], y = map.aside(box.tree, box.centre())[1];
      const bool surface = map.depth(box.tree, box.centre()) < 32e-9;
      if (surface && std::abs(y) < 0.4e-6 && x > low - 0.4e-6 && x < low + 0.5e-6) {
        lost += !there.count(cell->id());
        if (std::abs(y) < 0.1e-6) kept.push_back(box);
      }
    }
    if (options.kept)
      for (const auto& box : options.kept->cells()) lost += !keys.count(cell_key(box));
    options.kept = std::make_shared<KeptCells>(kept);
    return static_cast<double>(part->n_active_cells()) / whole->n_active_cells();
  };
  const double first = shares_of_whole(-0.9e-6), with_wake = shares_of_whole(0.1e-6);
  EXPECT_LT(first, 0.75);
  EXPECT_GT(with_wake, first);
  EXPECT_LT(with_wake, 0.85);
  const asperity::test::Verified verified{"Meshes",
                                          "fine around a contact on its way: torn cells, and cells of the "
                                          "contact and kept ones that are not there",
                                          "none"};
  EXPECT_TRUE(verified.below(torn + lost, 0));
}

/// p4est takes it for granted, and deal.II does not check it.
TEST(CoarseMesh_behaviour, has_edges_of_the_same_direction_in_all_trees_that_share_them) {
  const BodyMap map(sphere_of_8p5_um(40e-9, true).sizes);
  const auto name = [&](int tree, int v) {
    const Point3 p = map.position(tree, {double(v & 1), double((v >> 1) & 1), double(v >> 2)});
    return std::array<long, 3>{std::lround(p[0] * 1e12), std::lround(p[1] * 1e12), std::lround(p[2] * 1e12)};
  };
  std::set<std::pair<std::array<long, 3>, std::array<long, 3>>> edges;
  int shared = 0, opposite = 0;
  for (int tree = 0; tree < map.tree_count(); ++tree) {
    if (tree == block) continue;
    for (int v = 0; v < 8; ++v)
      for (const int direction : {1, 2, 4}) {
        if (v & direction) continue;
        const auto from = name(tree, v), to = name(tree, v + direction);
        opposite += edges.count({to, from}) > 0;
        shared += !edges.insert({from, to}).second;
      }
  }
  EXPECT_GT(shared, 30);
  EXPECT_TRUE(
      (asperity::test::Verified{"Meshes", "edges of trees that run against those of another tree", "none"}
           .below(opposite, 0)));
}

}  // namespace
