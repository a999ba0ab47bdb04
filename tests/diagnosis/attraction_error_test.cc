// The discretisation error of a solution that attracts, in the force of its contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/csv.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/challenge/challenge_matrix.h"
#include "diagnosis/mapping/solved_attraction.h"

namespace asperity {
namespace {

constexpr double stated_part = 0.02;  ///< of the pull-off force, stated [-]

/// Works of 0.2 and 0.8 J/m^2, solved by finite elements.
SolvedResponse solved_hysteresis() {
  const CsvTable table = read_csv(solved_truth("adhesion_hysteresis") / "history.csv");
  SolvedResponse solved;
  solved.displacement = table.numbers("normal_displacement [m]");
  solved.force = table.numbers("normal_force [N]");
  solved.peak = static_cast<std::size_t>(std::max_element(solved.force.begin(), solved.force.end()) -
                                         solved.force.begin());
  solved.pull_off_error = stated_part * -*std::min_element(solved.force.begin(), solved.force.end());
  return solved;
}

Mechanics hysteresis_law() {
  Mechanics m;
  m.experiment.particle = {71e9, 0.17}, m.experiment.substrate = {179e9, 0.25}, m.experiment.radius = 8.5e-6;
  m.geometry = m.experiment.hertz();
  const double works[] = {0.2, 0.8, 0.7};
  effect_of("adhesion_hysteresis").assemble(m, works);
  return m;
}

/// Forces along the displacements of a solution [N].
std::vector<double> forces_along(const BranchCorrection& correction, const Mechanics& law,
                                 const SolvedResponse& along) {
  const auto contact = correction.contact_for(*law.normal.contact)->clone();
  std::vector<double> list;
  for (const double d : along.displacement) {
    list.push_back(contact->force(d));
    contact->accept(d);
  }
  return list;
}

TEST(AttractionError_analytic, is_that_of_closing_on_loading_and_of_opening_on_unloading) {
  const SolvedResponse solved = solved_hysteresis();
  const Mechanics law = hysteresis_law();
  const auto exact = attraction_of(solved, law, 0, true);
  EXPECT_DOUBLE_EQ(exact->attraction_error(), stated_part);
  const auto off = exact->with_attraction_off();
  ASSERT_EQ(off.size(), 2u);
  const double opening = -*std::min_element(solved.force.begin(), solved.force.end()),
               closing = -*std::min_element(solved.force.begin(),
                                            solved.force.begin() + static_cast<long>(solved.peak));
  ASSERT_GT(closing, 0);
  ASSERT_GT(opening, 1.5 * closing);
  const auto as_solved = forces_along(*exact, law, solved), first = forces_along(*off[0], law, solved),
             second = forces_along(*off[1], law, solved);
  for (std::size_t i = 0; i < solved.force.size(); ++i) {
    if (as_solved[i] == 0) continue;
    const bool loads = i <= solved.peak;
    EXPECT_NEAR(as_solved[i], solved.force[i], 1e-12) << i;
    EXPECT_NEAR(first[i] - as_solved[i], loads ? 0 : stated_part * opening, 1e-14) << i;
    EXPECT_NEAR(second[i] - as_solved[i], loads ? stated_part * closing : 0, 1e-14) << i;
  }
}

TEST(AttractionError_analytic, is_one_where_the_contact_comes_back_as_it_went_and_none_where_none_is_stated) {
  SolvedResponse solved = solved_hysteresis();
  const Mechanics law = hysteresis_law();
  const auto exact = attraction_of(solved, law, 0, false);
  const auto off = exact->with_attraction_off();
  ASSERT_EQ(off.size(), 1u);
  const auto as_solved = forces_along(*exact, law, solved), shifted = forces_along(*off[0], law, solved);
  for (std::size_t i = 0; i < solved.force.size(); ++i)
    if (as_solved[i] != 0) {
      EXPECT_NEAR(shifted[i] - as_solved[i], solved.pull_off_error, 1e-14) << i;
    }
  solved.pull_off_error = 0;
  EXPECT_TRUE(attraction_of(solved, law, 0, true)->with_attraction_off().empty());
  EXPECT_EQ(attraction_of(solved, law, 0, true)->attraction_error(), 0);
}

}  // namespace
}  // namespace asperity
