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

TEST(ShippedRuns, the_main_job_holds_three_surfaces_two_more_spectra_and_the_smooth_yardstick) {
  const Study study = read_study(runs / "paper" / "surfaces.prm");
  ASSERT_FALSE(study.axes.empty());
  EXPECT_EQ(study.axes.back().name, "Surface");
  EXPECT_EQ(study.axes.back().labels.size(), 6u);
  std::size_t settings = 1;  // loads and spacings
  for (std::size_t axis = 0; axis + 1 < study.axes.size(); ++axis) settings *= study.axes[axis].labels.size();
  const std::size_t rough_surfaces = 5;
  EXPECT_EQ(study.cases.size(), settings * (1 + rough_surfaces * static_cast<std::size_t>(study.realisations)));
}

}  // namespace asperity
