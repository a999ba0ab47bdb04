// The case and study files that ship are accepted.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/case_file.h"
#include "app/study.h"

namespace asperity {
namespace {

const std::filesystem::path runs = std::filesystem::path(ASPERITY_SOURCE_DIR) / "runs";

}  // namespace

TEST(ShippedRuns_behaviour, the_quick_case_is_accepted) {
  EXPECT_GT(read_case(runs / "quick" / "case.prm").experiment.normal_load, 0);
}

TEST(ShippedRuns_behaviour, the_main_job_holds_three_surfaces_two_more_spectra_and_the_smooth_yardstick) {
  const Study study = read_study(runs / "paper" / "surfaces.prm");
  ASSERT_FALSE(study.axes.empty());
  EXPECT_EQ(study.axes.back().name, "Surface");
  EXPECT_EQ(study.axes.back().labels.size(), 6u);
  std::size_t settings = 1;  // loads and spacings
  for (std::size_t axis = 0; axis + 1 < study.axes.size(); ++axis) settings *= study.axes[axis].labels.size();
  const std::size_t rough_surfaces = 5;
  EXPECT_EQ(study.cases.size(),
            settings * (1 + rough_surfaces * static_cast<std::size_t>(study.realisations)));
}

TEST(ShippedRuns_behaviour,
     the_study_of_motions_varies_roughness_load_and_radius_and_switches_yielding_and_adhesion_off) {
  const Study study = read_study(runs / "paper" / "motions.prm");
  ASSERT_EQ(study.axes.size(), 2u);
  EXPECT_EQ(study.axes[0].labels, (std::vector<std::string>{"rolling", "sliding", "torsion"}));
  EXPECT_EQ(study.cases.size(), study.axes[0].labels.size() * study.axes[1].labels.size() *
                                    static_cast<std::size_t>(study.realisations));
  for (const std::string contact : {"2.7 nm elastic", "2.7 nm without adhesion", "1.5 nm R 2.5 um",
                                    "1.5 nm R 50 um", "1.5 nm 200 uN", "1.5 nm finer mesh"})
    EXPECT_EQ(std::count(study.axes[1].labels.begin(), study.axes[1].labels.end(), contact), 1) << contact;
}

TEST(ShippedRuns_behaviour, the_study_of_motions_has_every_load_with_every_roughness_and_both_spectra) {
  const Study study = read_study(runs / "paper" / "motions.prm");
  for (const std::string rms : {"0.3 nm", "1.5 nm", "2.7 nm"})
    for (const std::string spectrum : {"", " long waves"})
      for (const std::string load : {"", " 30 uN", " 200 uN"})
        EXPECT_EQ(std::count(study.axes[1].labels.begin(), study.axes[1].labels.end(), rms + spectrum + load),
                  1)
            << rms << spectrum << load;
  EXPECT_GE(study.realisations, 2);
}

TEST(ShippedRuns_behaviour, the_papers_rolling_and_rails_roll_wafers_and_indenter_and_spin_by_the_tangent) {
  const Study rolling = read_study(runs / "paper" / "rolling_loads.prm");
  ASSERT_EQ(rolling.axes.size(), 2u);
  EXPECT_EQ(rolling.axes[0].labels, (std::vector<std::string>{"100 uN", "1 mN", "3 mN"}));
  EXPECT_EQ(rolling.axes[1].labels, (std::vector<std::string>{"0.3 nm", "1.5 nm", "2.7 nm", "diamond"}));
  const Study rails = read_study(runs / "paper" / "rails.prm");
  ASSERT_EQ(rails.axes.size(), 2u);
  EXPECT_EQ(rails.axes[0].labels,
            (std::vector<std::string>{"rolling", "torsion", "25 degrees", "45 degrees", "60 degrees"}));
  EXPECT_EQ(rails.cases.size(), 15u);
}

TEST(ShippedRuns_behaviour, single_motions_and_the_benchmark_are_accepted) {
  EXPECT_GT(read_case(runs / "paper" / "sliding.prm").experiment.distance, 0);
  EXPECT_EQ(read_case(runs / "paper" / "program.prm").experiment.type, Motion::program);
  EXPECT_GT(read_case(runs / "paper" / "rolling.prm").interface.work_of_separation, 0);
  EXPECT_EQ(read_case(runs / ".." / "benchmarks" / "rough_sliding.prm").experiment.type, Motion::sliding);
}

}  // namespace asperity
