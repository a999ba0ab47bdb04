// Every command line of docs/commands.md runs, as it is printed or with arguments that make it cheap
// (readme_lines.cc says how).
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <set>

#include "core/atomic_file.h"
#include "tests/readme/readme_lines.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using namespace test;

const fs::path source = ASPERITY_SOURCE_DIR;

/// A scan as a Nanoscope writes it: 32 x 32 heights of 16 bits over 1 um.
std::string nanoscope_scan() {
  constexpr int pixels = 32, header_size = 4096;
  std::string header =
      "\\*File list\r\n\\Version: 0x07200000\r\n\\*Scanner list\r\n\\@Sens. Zsens: V 16.00000 "
      "nm/V\r\n\\*Ciao scan list\r\n"
      "\\Scan Size: 1000 nm\r\n\\*Ciao image list\r\n\\Data offset: 4096\r\n\\Data length: "
      "2048\r\n\\Bytes/pixel: 2\r\n"
      "\\Samps/line: 32\r\n\\Number of lines: 32\r\n\\Scan Size: 1 1 ~m\r\n\\Line Direction: Trace\r\n"
      "\\@2:Image Data: S [ZSensor] \"Height Sensor\"\r\n\\@2:Z scale: V [Sens. Zsens] (0.0000625 V/LSB) "
      "4.096000 V\r\n\\*File list end\r\n";
  header.resize(header_size, '\0');
  for (int i = 0; i < pixels * pixels; ++i) {
    const auto height = static_cast<std::int16_t>(1000 * ((i * i) % 7));
    header.append(reinterpret_cast<const char*>(&height), sizeof height);
  }
  return header;
}

/// A table as Hysitron's program writes it: up in ten seconds, down in ten.
std::string hysitron_text() {
  constexpr int points = 200;
  std::string text =
      "File Version: Hysitron Test\nTest Type: Indentation\nTest Data Points: " + std::to_string(points) +
      "\nTime_s\tDisp_nm\tForce_\xB5N\n";
  for (int i = 0; i < points; ++i) {
    const double share = i < points / 2 ? 2.0 * i / points : 2.0 - 2.0 * i / points;
    text += std::to_string(0.1 * i) + "\t" + std::to_string(40 * share) + "\t" + std::to_string(100 * share) +
            "\n";
  }
  return text;
}

/// The clone of a person who follows docs/commands.md, with a scan and a recording of her own.
class Readme_behaviour : public testing::TestWithParam<std::size_t> {
 protected:
  Readme_behaviour() {
    fs::create_directories(folder_.path / "build");
    fs::create_symlink(ASPERITY_EXECUTABLE, folder_.path / "build" / "asperity");
    fs::create_symlink(source / "runs", folder_.path / "runs");
    folder_.write("scan.spm", nanoscope_scan());
    folder_.write("scan.hld", hysitron_text());
    for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                             "OMPI_MCA_rmaps_base_oversubscribe", "OMP_NUM_THREADS"})
      ::setenv(name, "1", 1);
    ::setenv("HWLOC_COMPONENTS", "-gl", 1);
  }

  void run(const ReadmeLine& line) const {
    SCOPED_TRACE(line.printed + line.added);
    const bool redirects = line.printed.find('>') != std::string::npos;
    const fs::path log = folder_.path / "log";
    const auto start = std::chrono::steady_clock::now();
    const int status =
        std::system(("cd " + folder_.path.string() + " && { " + line.printed + line.added + "; } " +
                     (redirects ? "2> " : "> ") + log.string() + (redirects ? "" : " 2>&1"))
                        .c_str());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%6.1f s  %s%s\n", seconds, line.printed.c_str(),
                line.how.empty() ? "" : ("  (" + line.how + ")").c_str());
    EXPECT_EQ(status, 0) << read_file(log);
    EXPECT_NE(read_file(log).find(line.says), std::string::npos) << read_file(log);
    EXPECT_TRUE(fs::exists(folder_.path / line.leaves)) << line.leaves;
  }

  const TemporaryFolder folder_;
};

std::string name_of_group(const testing::TestParamInfo<std::size_t>& info) {
  return groups_of_readme()[info.param].name;
}

}  // namespace

TEST(ReadmeLines_analytic, each_is_run_by_a_test_and_no_other) {
  std::multiset<std::string> printed, run;
  for (const auto& line : lines_of_readme(source / "docs" / "commands.md")) printed.insert(line);
  for (const auto& group : groups_of_readme())
    for (const auto& line : group.lines) run.insert(line.printed);
  EXPECT_GE(printed.size(), 20u);
  for (const auto& line : printed)
    EXPECT_EQ(run.count(line), printed.count(line)) << "no test runs: " << line;
  for (const auto& line : run)
    EXPECT_EQ(printed.count(line), run.count(line)) << "not in docs/commands.md: " << line;
}

TEST_P(Readme_behaviour, its_lines_run) {
  for (const auto& line : groups_of_readme()[GetParam()].lines) run(line);
}

INSTANTIATE_TEST_SUITE_P(Lines_analytic, Readme_behaviour,
                         testing::Range<std::size_t>(0, groups_of_readme().size()), name_of_group);

}  // namespace asperity
