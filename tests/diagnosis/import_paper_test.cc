// The published numbers that ship as recordings: they read, say where they come from, and are the published
// numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/atomic_file.h"
#include "diagnosis/recording/recording.h"
#include "paper/friction_series.h"
#include "paper/published.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

fs::path paper(const std::string& name) {
  return fs::path(__FILE__).parent_path().parent_path().parent_path() / "runs/paper" / name;
}

/// Straight line through the forward rows of a series.
FrictionFit line_of(const Recording& recording) {
  std::vector<FrictionPoint> points;
  const RecordingTable& table = recording.tables[0];
  for (std::size_t i = 0; i < table.rows(); ++i)
    points.push_back({table.column("normal_force")[i],
                      {std::abs(table.column("lateral_force")[i]), table.column("lateral_force_sd")[i]}});
  return fit_friction(points, [](double) { return 1.0; });
}

TEST(PaperRecordings_behaviour, every_folder_reads_and_its_tables_begin_with_where_the_numbers_come_from) {
  int folders = 0;
  for (const auto& folder : fs::directory_iterator(paper("recordings"))) {
    const Recording recording = read_recording(folder.path());
    for (const auto& table : recording.tables)
      EXPECT_EQ(read_file(folder.path() / table.file).rfind("# R. Fuchs, T. Weinhart", 0), 0u)
          << folder.path();
    ++folders;
  }
  EXPECT_EQ(folders, 13);
}

TEST(PaperRecordings_other_code,
     lines_of_sliding_and_rolling_have_the_published_coefficients_offsets_and_uncertainties) {
  const Published published = read_published(paper("published"));
  const char* names[] = {"untreated", "etched_1600", "etched_1800"};
  for (std::size_t i = 0; i < 3; ++i) {
    const PublishedSurface& surface = published.surfaces[i];
    const FrictionFit sliding =
        line_of(read_recording(paper("recordings") / (std::string("sliding_offset_") + names[i])));
    EXPECT_NEAR(sliding.coefficient.value / surface.sliding.value, 1, 1e-4);
    EXPECT_NEAR(sliding.offset.value / surface.sliding_offset.value, 1, 1e-3);
    EXPECT_NEAR(sliding.coefficient.sd / surface.sliding.sd, 1, 0.01);
    EXPECT_NEAR(sliding.offset.sd / surface.sliding_offset.sd, 1,
                0.5);  // not given to the rows: the line's own
    const FrictionFit rolling =
        line_of(read_recording(paper("recordings") / (std::string("rolling_offset_") + names[i])));
    EXPECT_NEAR(rolling.coefficient.value / surface.rolling_r.value, 1, 1e-4);
    EXPECT_NEAR(rolling.offset.value / surface.rolling_r_offset.value, 1, 1e-3);
    EXPECT_NEAR(rolling.coefficient.sd / surface.rolling_r.sd, 1, 0.01);
  }
}

TEST(PaperRecordings_analytic, the_hertz_line_wants_nine_micrometres_and_the_loop_a_tenth_of_mindlins_slope) {
  const Published published = read_published(paper("published"));
  const Recording normal = read_recording(paper("recordings/normal_hertz_fit"));
  const Hertz nominal = published.hertz("fused quartz");
  const auto& table = normal.tables[0];
  EXPECT_NEAR(
      std::pow(
          table.column("normal_force").back() / nominal.force(table.column("normal_displacement").back()), 2),
      9 / 8.5, 1e-4);
  const RecordingTable loop = read_recording(paper("recordings/sliding_reversal_slope")).tables[0];
  const auto &x = loop.column("lateral_displacement"), &f = loop.column("lateral_force");
  EXPECT_NEAR((f[5] - f[0]) / (x[5] - x[0]), 2219, 1);
  EXPECT_NEAR(f[130], 0.23 * 112e-6, 1e-9);
}

}  // namespace
}  // namespace asperity
