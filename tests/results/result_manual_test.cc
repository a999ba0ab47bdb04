// docs/result.md names what the files of a solved case hold.
#include <gtest/gtest.h>

#include "core/atomic_file.h"
#include "results/case_result.h"
#include "results/history.h"
#include "tests/support/shared_files.h"

namespace asperity {
namespace {

TEST(ResultManual_behaviour, has_a_line_for_every_column_of_a_history_and_names_the_format) {
  const std::string manual =
      read_file(test::reference_folder().parent_path().parent_path().parent_path() / "docs" / "result.md");
  for (const auto& column : history_columns())
    EXPECT_NE(manual.find("\n| `" + std::string(column.name) + "` | "), std::string::npos) << column.name;
  EXPECT_NE(manual.find(std::string("\"format\": \"") + CaseResult::format + "\""), std::string::npos);
}

}  // namespace
}  // namespace asperity
