// The tables that tests compare with lie in the repository, each with its source.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "tests/support/shared_files.h"

namespace asperity {
namespace {

TEST(ReferenceTables_behaviour, each_is_readable_and_has_a_line_with_its_source) {
  const std::string sources = read_file(test::reference_folder() / "README.md");
  int tables = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::reference_folder())) {
    if (entry.path().extension() != ".csv") continue;
    ++tables;
    EXPECT_NE(sources.find("| `" + entry.path().filename().string() + "`"), std::string::npos)
        << entry.path();
    EXPECT_FALSE(read_csv(entry.path()).rows.empty()) << entry.path();
  }
  EXPECT_GE(tables, 25);
}

TEST(ReferenceTables_behaviour, a_missing_one_fails_a_test_instead_of_skipping_it) {
  EXPECT_THROW(test::reference_table("none.csv"), std::runtime_error);
}

}  // namespace
}  // namespace asperity
