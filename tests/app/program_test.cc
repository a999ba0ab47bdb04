// The program as a person calls it: exit status and messages.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <nlohmann/json.hpp>
#include <string>

#include "app/case_file.h"
#include "core/atomic_file.h"
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

TEST(Program_behaviour, helps_and_says_its_version) {
  EXPECT_EQ(call("--help").status, 0);
  EXPECT_CONTAINS(call("--help").output, "study");
  EXPECT_EQ(call("study --help").status, 0);
  EXPECT_EQ(call("--version").status, 0);
  EXPECT_EQ(call("--version").output.rfind("asperity ", 0), 0u);
  for (const char* package : {"\nbuilt with ", "deal.II 9.", "VTK 9.", "Eigen 3.", "Trilinos 1", "PETSc 3."})
    EXPECT_NE(call("--version").output.find(package), std::string::npos)
        << package << call("--version").output;
}

TEST(Program_behaviour, quiet_prints_errors_alone_and_what_json_asks_for) {
  const TemporaryFolder folder;
  const std::string map = (folder.path / "map.gsf").string();
  const std::string generate =
      "surface generate --rms '1 nm' --size '1 um' --pixels 64 --seed 1 --output " + map;
  EXPECT_NE(call(generate).output, "");
  const Outcome quiet = call(generate + " --quiet");
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.output, "");
  EXPECT_TRUE(std::filesystem::exists(map));
  const auto file = folder.write("case.prm", smooth_case() + "subsection Mesh\n  set Layer = 2\nend\n");
  const Outcome refused =
      call("solve " + file.string() + " --output " + (folder.path / "out").string() + " --quiet");
  EXPECT_EQ(refused.status, 2);
  EXPECT_CONTAINS(refused.output, "Layers");
  const Outcome printed =
      call("engine-input " ASPERITY_SOURCE_DIR "/runs/paper/parameters_silicon.json --engine lammps --quiet");
  EXPECT_CONTAINS(printed.output, "wall/gran granular") << "without --output the input is what was asked for";
}

/// It named the largest double, in 309 digits.
TEST(Program_behaviour, refuses_what_is_no_positive_number_in_one_sentence) {
  for (const char* reach : {"'20 nm'", "0", "-1", "nan", "x"}) {
    const Outcome refused = call(std::string("law-curve --law hertz --reach ") + reach);
    EXPECT_EQ(refused.status, 2) << reach;
    EXPECT_CONTAINS(refused.output, "is no number above 0; give one without a unit");
    EXPECT_LT(refused.output.size(), 200u) << refused.output;
  }
}

TEST(Program_behaviour, refuses_a_wrong_call_with_status_2) {
  EXPECT_EQ(call("").status, 2);
  EXPECT_EQ(call("study").status, 2);
  const Outcome wrong = call("sutdy x.prm");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_CONTAINS(wrong.output, "did you mean 'study'?");
  EXPECT_EQ(call("study nothing.prm --output nowhere").status, 2);
}

TEST(Program_behaviour, says_no_character_of_a_file_that_a_terminal_obeys) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", "set Title\x1b]0;x\x07 = \u202e\nset Ti\xFFtle = µ\n");
  const Outcome outcome = call("solve " + file.string() + " --output " + (folder.path / "r").string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_CONTAINS(outcome.output, "\\x1b]0;x\\x07");
  for (const char* obeyed : {"\x1b", "\x07", "\u202e", "\xFF"})
    EXPECT_EQ(outcome.output.find(obeyed), std::string::npos) << outcome.output;
}

TEST(Program_behaviour, refuses_a_wrong_study_with_status_2_and_one_sentence) {
  const TemporaryFolder folder;
  const auto file = folder.write("study.prm", "subsection Particle\n set Radus = 1 um\nend\n");
  const Outcome outcome = call("study " + file.string() + " --output " + (folder.path / "results").string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.output,
            "asperity: " + file.string() +
                ":2: there is no entry 'Radus' in subsection Particle; did you mean 'Radius'?\n");
}

TEST(Program_behaviour, reads_an_entry_under_its_former_name_and_says_the_present_one_once) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("study.prm", smooth_case() +
                                    "subsection Interface\n set Work of adhesion = 0.1 J/m^2\n"
                                    " set Opening work = 0.2 J/m^2\n set Adhesion range = 10 nm\nend\n"
                                    "subsection Study\n subsection Vary\n"
                                    "  set Experiment/Normal load = 1 mN, 2 mN\n end\nend\n");
  const Outcome outcome = call("study " + file.string() + " --check");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const std::string hint = "asperity: " + file.string() +
                           ":15: 'Opening work' is now called 'Work of adhesion on separation'; the former "
                           "name is still read\n";
  EXPECT_CONTAINS(outcome.output, hint);
  EXPECT_EQ(outcome.output.find("'Opening work'"), outcome.output.rfind("'Opening work'"));
}

TEST(Program_behaviour, ends_with_status_1_when_a_case_of_a_study_fails) {
  const TemporaryFolder folder;
  const auto file = folder.write("study.prm", smooth_case());
  const auto arguments =
      "study " + file.string() + " --output " + (folder.path / "results").string() + " --solver ";
  const Outcome failed = call(arguments + "/bin/false");
  EXPECT_EQ(failed.status, 1);
  EXPECT_CONTAINS(failed.output, "1 of 1 cases failed");
  EXPECT_CONTAINS(failed.output, "--resume");
}

TEST(Program_behaviour, refuses_a_study_with_a_case_that_the_bodies_have_no_room_for) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "study.prm", smooth_case() +
                       "subsection Experiment\n set Type = rolling\nend\nsubsection Study\n subsection Vary\n"
                       "  set Experiment/Distance = short: 1 um, long: 40 um\n end\nend\n");
  const auto output = folder.path / "results";
  const Outcome outcome = call("study " + file.string() + " --output " + output.string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_CONTAINS(outcome.output, file.string() +
                                      ": Experiment/Distance of 40 um rolls the contact out of the "
                                      "particle's finely meshed cap; set it to ");
  EXPECT_CONTAINS(outcome.output, "or less (case long)");
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST(Program_behaviour, solves_over_no_finished_result_unless_told_and_leaves_case_and_result_of_one_input) {
  const TemporaryFolder folder;
  std::string text = smooth_case();
  text.replace(text.find("1 mN"), 4, "20 uN");
  const auto file =
      folder.write("case.prm", text +
                                   "subsection Experiment\n set Load steps = 1\n set Unload = false\nend\n"
                                   "subsection Mesh\n set Interface spacing = 30 nm\n set Layers = "
                                   "1\nend\nsubsection Output\n set Fields = false\nend\n"
                                   "subsection Solver\n set Threads = 1\nend\n");
  const auto output = folder.path / "out";
  const auto modulus = [&] {
    return nlohmann::json::parse(read_file(output / "result.json"))["inputs"]["substrate"]["youngs_modulus"]
        .get<double>();
  };
  const Outcome solved = call("solve " + file.string() + " --output " + output.string());
  ASSERT_EQ(solved.status, 0) << solved.output;
  const std::string first = read_file(output / "result.json");
  const std::string again = "solve " + (output / "case.prm").string() + " --output " + output.string() +
                            " --set 'Substrate/Young modulus=150 GPa'";
  for (const char* flag : {"", " --resume"}) {
    const Outcome refused = call(again + flag);
    EXPECT_EQ(refused.status, 2) << refused.output;
    EXPECT_CONTAINS(refused.output, "--overwrite");
    EXPECT_EQ(read_file(output / "result.json"), first);
  }
  EXPECT_EQ(call("solve " + file.string() + " --output " + output.string() + " --resume").status, 0);
  EXPECT_EQ(read_file(output / "result.json"), first) << "nothing was left to do";
  // A case that cannot be meshed leaves the result that it was to replace.
  EXPECT_EQ(call(again + " --overwrite --set 'Mesh/Interface spacing=900 nm'").status, 2);
  EXPECT_EQ(read_file(output / "result.json"), first);
  ASSERT_EQ(call(again + " --overwrite").status, 0);
  EXPECT_EQ(modulus(), 150e9);
  EXPECT_EQ(read_case(output / "case.prm").substrate.youngs_modulus, 150e9);
}

TEST(Program_behaviour, checks_a_case_and_a_study_without_solving) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const Outcome accepted = call("solve " + file.string() + " --check"),
                refused = call("solve " + file.string() + " --check --set 'Experiment/Normal load=-1 mN'");
  EXPECT_EQ(accepted.status, 0) << accepted.output;
  EXPECT_CONTAINS(accepted.output, "is accepted; nothing was solved");
  EXPECT_EQ(refused.status, 2);
  const Outcome study = call("study " + file.string() + " --check --set 'Experiment/Normal load=1 mN'");
  EXPECT_EQ(study.status, 0) << study.output;
  EXPECT_CONTAINS(study.output, "all 1 cases of");
}

TEST(Program_behaviour, says_when_what_it_prints_does_not_arrive) {
  const TemporaryFolder folder;
  const auto device = folder.path / "full";
  constexpr unsigned memory_devices = 1, full = 7;  // a device of this test's own that is as /dev/full
  if (::mknod(device.c_str(), S_IFCHR | 0666, makedev(memory_devices, full)) != 0)
    GTEST_SKIP() << "only root may make a device";
  for (const char* command : {"case-template", "laws", "--help", "--version"}) {
    const Outcome outcome = call(std::string(command) + " 2>&1 >" + device.string() + " #");
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_CONTAINS(outcome.output, "asperity: cannot write to standard output, and what");
  }
  EXPECT_EQ(call("case-template >&- #").status, 0) << "a closed output is meant";
  EXPECT_TRUE(std::filesystem::is_character_file(device));
}

TEST(Program_behaviour, writes_through_links_and_fifos_and_takes_no_file_for_a_folder) {
  const TemporaryFolder folder;
  const auto fifo = folder.path / "fifo", link = folder.path / "link", target = folder.path / "target.gsf";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  std::filesystem::create_symlink("target.gsf", link);
  const std::string generate = "surface generate --rms '1 nm' --size '1 um' --pixels 64 --seed 1 --output ";
  EXPECT_EQ(call(generate + link.string()).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  ASSERT_EQ(call(generate + fifo.string() + " & cat " + fifo.string() + " > " +
                 (folder.path / "read.gsf").string() + "; wait #")
                .status,
            0);
  EXPECT_EQ(read_file(folder.path / "read.gsf"), read_file(target));
  EXPECT_TRUE(std::filesystem::is_fifo(fifo));
  EXPECT_EQ(call("paper --output " + fifo.string()).status, 2);
  EXPECT_TRUE(std::filesystem::is_fifo(fifo));
}

TEST(Program_behaviour, solves_chosen_cases_of_a_study) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "study.prm",
      smooth_case() +
          "subsection Study\n subsection Vary\n set Experiment/Normal load = 1 mN, 2 mN\n end\nend\n");
  const auto output = folder.path / "results";
  const auto study = [&](const std::string& only) {
    return call("study " + file.string() + " --output " + output.string() + " --solver /bin/false --only '" +
                only + "'");
  };
  const Outcome unreadable = study("[2"), none = study("3_mN");
  EXPECT_EQ(unreadable.status, 2);
  EXPECT_CONTAINS(unreadable.output,
                  "--only '[2' is not a regular expression; write part of a case's name, such as '1_mN'");
  EXPECT_EQ(none.status, 2);
  EXPECT_CONTAINS(none.output,
                  "--only '3_mN' chooses none of the study's 2 cases; their names are like '1_mN'");
  EXPECT_FALSE(std::filesystem::exists(output / "study.json"));
  const Outcome one = study("2_mn");
  EXPECT_EQ(one.status, 1);
  EXPECT_CONTAINS(one.output, "1 of 1 chosen cases failed");
  EXPECT_CONTAINS(one.output, "--resume --only '2_mn'");
  EXPECT_FALSE(std::filesystem::exists(output / "1_mN" / "solve.log"));
}

}  // namespace asperity
