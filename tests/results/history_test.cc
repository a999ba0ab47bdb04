#include "results/history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// Each column counts in steps of its own.
std::vector<HistoryRow> three_rows() {
  std::vector<HistoryRow> rows(3);
  double unit = 1;
  for (const auto& column : history_columns()) {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*column.of_row = unit * static_cast<double>(i + 1);
    unit += 0.125;
  }
  return rows;
}

TEST(History_analytic, of_rows_has_their_values_in_each_column_and_comes_back_from_its_file) {
  const test::TemporaryFolder folder;
  const History made = history_of(three_rows());
  write_file_atomically(folder.path / "history.csv", format_history(made));
  const History read = read_history(folder.path / "history.csv");
  EXPECT_EQ(read.size(), 3u);
  double unit = 1;
  std::set<std::string> names;
  for (const auto& column : history_columns()) {
    EXPECT_EQ(made.*column.values, (std::vector<double>{unit, 2 * unit, 3 * unit})) << column.name;
    EXPECT_EQ(read.*column.values, made.*column.values) << column.name;
    EXPECT_TRUE(names.insert(column.name).second) << column.name << " stands twice";
    unit += 0.125;
  }
}

TEST(History_behaviour, columns_that_not_every_history_has_may_be_missing_and_others_are_passed_over) {
  const test::TemporaryFolder folder;
  History few;
  few.normal_force = {1, 2};
  std::string text = format_history(few);
  EXPECT_EQ(text.find("friction_work"), std::string::npos);
  text.insert(text.find('\n'), ",something else"), text.insert(text.find('\n', text.find('\n') + 1), ",7"),
      text.insert(text.size() - 1, ",8");
  write_file_atomically(folder.path / "history.csv", text);
  const History read = read_history(folder.path / "history.csv");
  EXPECT_EQ(read.normal_force, few.normal_force);
  EXPECT_EQ(read.rolling_angle, (std::vector<double>{0, 0})) << "an experiment without it";
  EXPECT_TRUE(read.friction_work.empty());
  EXPECT_EQ(&read.radius_of_whole(), &read.contact_radius);
}

TEST(History_analytic, an_added_column_stands_behind_the_others_and_is_read_where_it_is_named) {
  const test::TemporaryFolder folder;
  std::vector<HistoryRow> rows = three_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].added = {0.5 * static_cast<double>(i), 7};
  const std::vector<std::string> names{"own path [m]", "own count"};
  const std::string text = format_history(history_of(rows, names));
  EXPECT_NE(text.find(",own path [m],own count\n"), std::string::npos);
  write_file_atomically(folder.path / "history.csv", text);
  EXPECT_TRUE(read_history(folder.path / "history.csv").added.empty());
  const History read = read_history(folder.path / "history.csv", names);
  ASSERT_EQ(read.added.size(), 2u);
  EXPECT_EQ(read.added[0].name, "own path [m]");
  EXPECT_EQ(read.added[0].values, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(read.added[1].values, (std::vector<double>{7, 7, 7}));
  const std::string message =
      test::message_of<InputError>([&] { read_history(folder.path / "history.csv", {"another"}); });
  EXPECT_NE(message.find("history.csv"), std::string::npos);
  EXPECT_NE(message.find("another"), std::string::npos);
}

TEST(History_behaviour, without_a_column_that_every_history_has_is_refused_by_file_and_column) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder.path / "history.csv", "step,time [s]\n1,2\n");
  const std::string message =
      test::message_of<InputError>([&] { read_history(folder.path / "history.csv"); });
  EXPECT_NE(message.find("history.csv"), std::string::npos);
  EXPECT_NE(message.find("normal_displacement [m]"), std::string::npos);
}

TEST(HistoryBranches_analytic, are_cut_where_the_load_turns_and_hold_where_it_stays) {
  History history;
  history.normal_force = {0, 1, 2, 2, 2, 1, 0.5, 1};
  const auto branches = history_branches(history);
  using Kind = HistoryBranch::Kind;
  ASSERT_EQ(branches.size(), 4u);
  const Kind kinds[] = {Kind::loading, Kind::hold, Kind::unloading, Kind::loading};
  const std::size_t first[] = {0, 2, 4, 6}, last[] = {2, 4, 6, 7};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(branches[k].kind, kinds[k]) << k;
    EXPECT_EQ(branches[k].first, first[k]) << k;
    EXPECT_EQ(branches[k].last, last[k]) << k;
    EXPECT_EQ(branches[k].size(), last[k] - first[k] + 1);
  }
}

// A contact that moves under its largest load: round-off decides which of its rows has the largest force.
TEST(History_behaviour, the_largest_load_is_where_it_is_first_reached) {
  EXPECT_EQ(row_of_largest_load({1, 2, 3, 3.000003, 3.000006, 2.999999, 1}), 2U);
  EXPECT_EQ(row_of_largest_load({1, 2.9, 3, 2}), 2U);
  EXPECT_EQ(row_of_largest_load({-3, -1, -1.000001, -2}), 1U);
  EXPECT_EQ(row_of_largest_load({}), 0U);
}

}  // namespace
}  // namespace asperity
