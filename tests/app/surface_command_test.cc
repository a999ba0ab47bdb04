// asperity surface, as a person and a script call it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "surfaces/read_topography.h"
#include "tests/app/called_program.h"
#include "tests/support/peak_memory.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::Outcome;

Outcome surface(const std::string& arguments) { return test::call("surface " + arguments); }

std::string generate(const std::string& file, const std::string& seed) {
  return "generate --rms \"1.5 nm\" --size \"1 um\" --pixels 256 --seed " + seed + " --output " + file;
}

}  // namespace

TEST(SurfaceCommand_behaviour, generates_what_it_then_measures) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path / "surface.gsf").string();
  ASSERT_EQ(surface(generate(file, "3")).status, 0);
  const Outcome measured = surface("measure " + file + " --json");
  ASSERT_EQ(measured.status, 0) << measured.output;
  const auto json = nlohmann::json::parse(measured.output);
  EXPECT_NEAR(json["Sq_m"].get<double>(), 1.5e-9, 0.15e-9);
  EXPECT_EQ(json["pixels"], nlohmann::json({256, 256}));
  EXPECT_NEAR(json["size_m"][0].get<double>(), 1e-6, 1e-12);
  EXPECT_EQ(json["level"], "plane");
  const Outcome spoken = surface("measure " + file);
  EXPECT_EQ(spoken.status, 0);
  EXPECT_NE(spoken.output.find("Sq (RMS height)"), std::string::npos);
}

TEST(SurfaceCommand_behaviour, refuses_with_status_2) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path / "surface.gsf").string();
  EXPECT_EQ(surface("measure " + file).status, 2);  // not there
  EXPECT_EQ(surface(generate(file, "-3")).status, 2);
  EXPECT_EQ(surface(generate(file, "3") + " --cutoff \"1 nm\"").status, 2);  // below two pixels
  ASSERT_EQ(surface(generate(file, "3")).status, 0);
  EXPECT_EQ(surface("measure " + file + " --level plain").status, 2);
  EXPECT_EQ(surface("afm --rms \"1.5 nm\"").status, 2);  // neither peak to valley nor roll-off
}

TEST(SurfaceCommand_analytic, scales_a_spectrum_so_that_scans_show_the_rms) {
  const Outcome outcome = surface("afm --rms \"1.5 nm\" --rolloff \"1 um\" --hurst 0.8 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_NEAR(json[0]["measured_rms_m"].get<double>(), 1.5e-9, 1e-15);
  EXPECT_GT(json[0]["rms_m"].get<double>(), 1.01 * 1.5e-9);  // levelling takes 1 to 20 %
  EXPECT_LT(json[0]["rms_m"].get<double>(), 1.20 * 1.5e-9);
}

/// Resident set of `asperity surface measure FILE` at its largest [byte], as a user starts it.
test::ChildOutcome measuring(const std::string& file) {
  return test::in_child([&] {
    ::unsetenv("GLIBC_TUNABLES");  // with which the tests run
    ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
    ::dup2(STDOUT_FILENO, STDERR_FILENO);
    ::execl(ASPERITY_EXECUTABLE, ASPERITY_EXECUTABLE, "surface", "measure", file.c_str(), nullptr);
  });
}

// It took fifteen once: padded copies, a mask of ones, and the autocorrelation twice.
TEST(SurfaceCommand_analytic, measures_in_the_memory_of_five_maps_at_most) {
  const test::TemporaryFolder folder;
  constexpr int pixels = 2048;
  constexpr std::uint64_t copy = sizeof(double) * pixels * pixels;
  const std::uint64_t program = measuring((folder.path / "none.gsf").string()).peak_bytes;
  const std::string file = (folder.path / "surface.gsf").string();
  ASSERT_EQ(surface("generate --rms '2 nm' --size '2 um' --pixels 2048 --seed 1 --output " + file).status, 0);
  const auto whole = measuring(file);
  EXPECT_EQ(whole.end, test::ChildOutcome::End::done);
  EXPECT_LT(whole.peak_bytes, program + 5 * copy);
  Topography map = read_topography(file);
  map.periodic = false;
  map.missing.assign(map.heights.size(), 0);
  map.missing[1000] = 1;
  write_gsf(file, map);
  map = {};
  const auto with_missing = measuring(file);
  EXPECT_EQ(with_missing.end, test::ChildOutcome::End::done);
  EXPECT_LT(with_missing.peak_bytes, program + 5 * copy);
}

}  // namespace asperity
