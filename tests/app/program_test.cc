// The program as a person calls it: exit status and messages.
#include <gtest/gtest.h>

#include <string>

#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::smooth_case;
using test::TemporaryFolder;

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

}  // namespace

TEST(Program, helps_and_says_its_version) {
  EXPECT_EQ(call("--help").status, 0);
  EXPECT_CONTAINS(call("--help").output, "study");
  EXPECT_EQ(call("study --help").status, 0);
  EXPECT_EQ(call("--version").status, 0);
  EXPECT_EQ(call("--version").output.rfind("asperity ", 0), 0u);
}

TEST(Program, refuses_a_wrong_call_with_status_2) {
  EXPECT_EQ(call("").status, 2);
  EXPECT_EQ(call("study").status, 2);
  const Outcome wrong = call("sutdy x.prm");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_CONTAINS(wrong.output, "did you mean 'study'?");
  EXPECT_EQ(call("study nothing.prm --output nowhere").status, 2);
}

TEST(Program, refuses_a_wrong_study_with_status_2_and_one_sentence) {
  const TemporaryFolder folder;
  const auto file = folder.write("study.prm", "subsection Particle\n set Radus = 1 um\nend\n");
  const Outcome outcome = call("study " + file.string() + " --output " + (folder.path / "results").string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.output, "asperity: " + file.string() + ":2: there is no entry 'Radus' in subsection Particle; did you mean 'Radius'?\n");
}

TEST(Program, ends_with_status_1_when_a_case_of_a_study_fails) {
  const TemporaryFolder folder;
  const auto file = folder.write("study.prm", smooth_case());
  const auto arguments = "study " + file.string() + " --output " + (folder.path / "results").string() + " --solver ";
  const Outcome failed = call(arguments + "/bin/false");
  EXPECT_EQ(failed.status, 1);
  EXPECT_CONTAINS(failed.output, "1 of 1 cases failed");
  EXPECT_CONTAINS(failed.output, "--resume");
}

TEST(Program, refuses_a_study_with_a_case_that_the_bodies_have_no_room_for) {
  const TemporaryFolder folder;
  const auto file = folder.write("study.prm", smooth_case() + "subsection Experiment\n set Type = rolling\nend\nsubsection Study\n subsection Vary\n"
                                              "  set Experiment/Distance = short: 1 um, long: 40 um\n end\nend\n");
  const auto output = folder.path / "results";
  const Outcome outcome = call("study " + file.string() + " --output " + output.string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_CONTAINS(outcome.output, file.string() + ": Experiment/Distance of 40 um rolls the contact out of the particle's finely meshed cap; set it to ");
  EXPECT_CONTAINS(outcome.output, "or less (case long)");
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST(Program, solves_chosen_cases_of_a_study) {
  const TemporaryFolder folder;
  const auto file = folder.write("study.prm", smooth_case() + "subsection Study\n subsection Vary\n set Experiment/Normal load = 1 mN, 2 mN\n end\nend\n");
  const auto output = folder.path / "results";
  const auto study = [&](const std::string& only) {
    return call("study " + file.string() + " --output " + output.string() + " --solver /bin/false --only '" + only + "'");
  };
  const Outcome unreadable = study("[2"), none = study("3_mN");
  EXPECT_EQ(unreadable.status, 2);
  EXPECT_CONTAINS(unreadable.output, "--only '[2' is not a regular expression; write part of a case's name, such as '1_mN'");
  EXPECT_EQ(none.status, 2);
  EXPECT_CONTAINS(none.output, "--only '3_mN' chooses none of the study's 2 cases; their names are like '1_mN'");
  EXPECT_FALSE(std::filesystem::exists(output / "study.json"));
  const Outcome one = study("2_mn");
  EXPECT_EQ(one.status, 1);
  EXPECT_CONTAINS(one.output, "1 of 1 chosen cases failed");
  EXPECT_CONTAINS(one.output, "--resume --only '2_mn'");
  EXPECT_FALSE(std::filesystem::exists(output / "1_mN" / "solve.log"));
}

}  // namespace asperity
