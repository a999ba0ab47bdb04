// A case whose roughness is a scan on disk, from the file to the result, as a person calls the program.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/atomic_file.h"
#include "results/history.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::TemporaryFolder;

/// Heights in nm as a bare matrix, without lateral scale: two crossed waves of 1 nm and eight periods, Sq =
/// 1/2 nm.
std::string wavy_matrix() {
  constexpr int pixels = 128, periods = 8;
  std::ostringstream text;
  const auto wave = [](int i) { return std::sin(2 * M_PI * periods * (i + 0.5) / pixels); };
  for (int iy = 0; iy < pixels; ++iy) {
    for (int ix = 0; ix < pixels; ++ix) text << (ix ? " " : "") << wave(ix) * wave(iy);
    text << "\n";
  }
  return text.str();
}

class ScanCase_behaviour : public testing::Test {
 protected:
  /// Solves the case with this topography of the substrate; returns the exit status.
  int solve(const std::string& topography, const std::string& spacing = "30 nm") {
    folder.write("scans/wavy.txt", wavy_matrix());
    const std::string text = "subsection Substrate\n set Topography = " + topography +
                             "\n set Young modulus = 179 GPa\n"
                             " set Poisson ratio = 0.25\nend\nsubsection Particle\n set Radius = 8.5 um\n "
                             "set Young modulus = 71 GPa\n"
                             " set Poisson ratio = 0.17\nend\nsubsection Experiment\n set Normal load = 30 "
                             "uN\n set Load steps = 2\n"
                             " set Unload = false\nend\nsubsection Mesh\n set Interface spacing = " +
                             spacing + "\n set Layers = 1\nend\n";
    const auto file = folder.write("case.prm", text);
    const int status = std::system((std::string(ASPERITY_EXECUTABLE) + " solve " + file.string() +
                                    " --output " + (folder.path / "result").string() + " --overwrite > " +
                                    (folder.path / "log").string() + " 2>&1")
                                       .c_str());
    log = read_file(folder.path / "log");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  TemporaryFolder folder;
  std::string log;
};

}  // namespace

TEST_F(ScanCase_behaviour, a_bare_matrix_beside_the_case_file_is_solved_once_its_size_and_unit_are_given) {
  ASSERT_EQ(solve("scan(scans/wavy.txt, size=1.6 um, unit=nm)"), 0) << log;
  const auto result = nlohmann::json::parse(read_file(folder.path / "result" / "result.json"));
  // Whole periods of 200 nm do not fit the region exactly: 5 %.
  EXPECT_NEAR(result["inputs"]["rms_in_region"]["substrate"].get<double>(), 0.5e-9, 0.05 * 0.5e-9);
  EXPECT_EQ(result["inputs"]["rms_in_region"]["particle"].get<double>(), 0);
  EXPECT_FALSE(result["mesh"]["contact_reaches_rim"].get<bool>());
  const History history = read_history(folder.path / "result" / "history.csv");
  EXPECT_NEAR(history.normal_force.back(), 30e-6, 1e-6 * 30e-6);
}

TEST_F(ScanCase_behaviour, one_without_size_is_refused_by_the_line_of_the_case_file) {
  EXPECT_EQ(solve("scans/wavy.txt"), 2);
  EXPECT_NE(log.find("case.prm:2: Substrate/Topography: "), std::string::npos) << log;
  EXPECT_NE(log.find("scan(FILE, size=2.5 um"), std::string::npos) << log;
}

TEST_F(ScanCase_behaviour, one_smaller_than_the_contact_is_refused_by_line_and_solved_when_mirrored) {
  EXPECT_EQ(solve("scan(scans/wavy.txt, size=0.8 um, unit=nm, level=mean)"), 2);
  EXPECT_NE(log.find("case.prm:2: Substrate/Topography: "), std::string::npos) << log;
  EXPECT_NE(log.find("outside=mirror"), std::string::npos) << log;
  EXPECT_EQ(solve("scan(scans/wavy.txt, size=0.8 um, unit=nm, level=mean, outside=mirror)", "15 nm"), 0)
      << log;
}

/// Eight periods over 400 nm, crossed, are waves of 35 nm; a twelfth of Hertz' contact radius is 13 nm
/// whatever the roughness.
TEST_F(ScanCase_behaviour, without_a_spacing_is_meshed_by_its_own_waves_and_says_what_is_resolved) {
  ASSERT_EQ(solve("scan(scans/wavy.txt, size=0.4 um, unit=nm, outside=mirror)", "0 m"), 0) << log;
  const auto result = nlohmann::json::parse(read_file(folder.path / "result" / "result.json"));
  const auto& roughness = result["mesh"]["roughness"]["substrate"];
  EXPECT_NEAR(roughness["shortest_wave"].get<double>(), 50e-9 / std::sqrt(2.0), 8e-9);
  EXPECT_LT(result["mesh"]["interface_spacing"].get<double>(), 10e-9);
  EXPECT_NEAR(roughness["cells_over_shortest_wave"].get<double>(), 4, 0.01);
  EXPECT_LT(roughness["missed_by_facets"]["slope_variance"].get<double>(), 0.2);
  EXPECT_NE(log.find("4 cells over its shortest wave"), std::string::npos) << log;
  // A mesh of a twelfth of the contact radius misses most of these slopes.
  EXPECT_EQ(solve("scan(scans/wavy.txt, size=0.4 um, unit=nm, outside=mirror)", "27 nm"), 2);
  EXPECT_NE(log.find("slope variance"), std::string::npos) << log;
}

}  // namespace asperity
