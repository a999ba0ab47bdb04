// The case and study files that ship are accepted.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/case_file.h"
#include "app/study.h"

namespace asperity {
namespace {

const std::filesystem::path runs = std::filesystem::path(ASPERITY_SOURCE_DIR) / "runs";

}  // namespace

TEST(ShippedRuns, the_quick_case_is_accepted) { EXPECT_GT(read_case(runs / "quick" / "case.prm").experiment.normal_load, 0); }

TEST(ShippedRuns, the_main_job_holds_the_three_surfaces_and_the_smooth_yardstick) {
  const Study study = read_study(runs / "paper" / "surfaces.prm");
  ASSERT_EQ(study.axes.size(), 2u);
  EXPECT_EQ(study.axes[1].name, "Surface");
  EXPECT_EQ(study.axes[1].labels.size(), 4u);
  const std::size_t loads = study.axes[0].labels.size(), rough_surfaces = 3;
  EXPECT_EQ(study.cases.size(), loads * (1 + rough_surfaces * static_cast<std::size_t>(study.realisations)));
}

}  // namespace asperity
