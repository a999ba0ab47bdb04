#include "app/case_folder.h"

#include <gtest/gtest.h>

#include "app/case_file.h"
#include "app/inputs_hash.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using test::smooth_case;

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

class CaseFolder_analytic : public testing::Test {
 protected:
  FolderedCase now(const std::vector<std::string>& overrides = {}, const std::string& commit = "c1") const {
    return of(folder.path / "case.prm", overrides, commit);
  }
  FolderedCase of(const fs::path& file, const std::vector<std::string>& overrides = {},
                  const std::string& commit = "c1") const {
    const Settings settings = read_settings(file, overrides);
    return {settings, file, results, {inputs_sha256(settings, file), commit}};
  }
  /// What a finished solution leaves, in short.
  void finish(const FolderedCase& done) const {
    claim_folder(done, SolveStart::anew);
    begin(done);
    folder.write("results/result.json", "{\"format\": \"asperity-result/1\", \"inputs_sha256\": \"" +
                                            done.provenance.inputs_sha256 + "\"}");
  }
  void begin(const FolderedCase& begun) const {
    folder.write("results/history.csv", "step\n1\n");
    folder.write("results/checkpoint/latest.json", "{\"inputs_sha256\": \"" + begun.provenance.inputs_sha256 +
                                                       "\", \"commit\": \"" + begun.provenance.commit +
                                                       "\"}");
  }
  std::string resumed(const FolderedCase& item) const {
    return message_of<InputError>([&] { check_folder(item, IfSolved::resume); });
  }

  const test::TemporaryFolder folder;
  const fs::path case_file = folder.write("case.prm", smooth_case()), results = folder.path / "results";
};

}  // namespace

TEST_F(CaseFolder_analytic, a_finished_or_begun_solution_is_not_solved_over_unasked) {
  EXPECT_EQ(check_folder(now(), IfSolved::refuse), SolveStart::anew);
  begin(now());
  EXPECT_SAYS(message_of<InputError>([&] { check_folder(now(), IfSolved::refuse); }),
              "holds a begun solution already; add --resume to go on");
  EXPECT_EQ(check_folder(now(), IfSolved::resume), SolveStart::go_on);
  finish(now());
  EXPECT_SAYS(message_of<InputError>([&] { check_folder(now(), IfSolved::refuse); }),
              "holds a finished solution already; add --resume");
  EXPECT_EQ(check_folder(now(), IfSolved::resume), SolveStart::finished);
  EXPECT_EQ(check_folder(now(), IfSolved::overwrite), SolveStart::anew);
  EXPECT_TRUE(fs::exists(results / "result.json")) << "checking writes nothing";
  claim_folder(now(), SolveStart::anew);
  for (const char* name : {"result.json", "history.csv", "checkpoint"})
    EXPECT_FALSE(fs::exists(results / name)) << name;
}

TEST_F(CaseFolder_analytic, other_inputs_are_not_resumed_and_the_entry_is_named) {
  begin(now());
  claim_folder(now(), SolveStart::go_on);
  EXPECT_SAYS(resumed(now({"Experiment/Normal load=2 mN"})),
              "was solved with Experiment/Normal load = 1 mN, and now it is 2 mN; --overwrite");
  EXPECT_SAYS(resumed(now({"Solver/Tolerance=1e-5"})), "Solver/Tolerance");
  EXPECT_EQ(check_folder(now({"Solver/Threads=1", "Experiment/Normal load=1000 uN"}), IfSolved::resume),
            SolveStart::go_on);
  finish(now());
  EXPECT_SAYS(resumed(now({"Experiment/Normal load=2 mN"})), "Experiment/Normal load = 1 mN");
}

TEST_F(CaseFolder_analytic, nor_are_they_through_the_folders_own_case_file) {
  finish(now());
  const fs::path remembered = results / "case.prm";
  EXPECT_SAYS(resumed(of(remembered, {"Substrate/Young modulus=100 GPa"})),
              "Substrate/Young modulus = 179 GPa");
  EXPECT_EQ(check_folder(of(remembered), IfSolved::resume), SolveStart::finished);
}

TEST_F(CaseFolder_analytic, half_of_a_solution_is_not_gone_on_with_by_another_program) {
  begin(now());
  EXPECT_SAYS(resumed(now({}, "c2")), "was begun by the build of commit c1, and this one is of c2");
  finish(now());
  EXPECT_EQ(check_folder(now({}, "c2"), IfSolved::resume), SolveStart::finished);
}

TEST_F(CaseFolder_analytic, results_that_do_not_say_their_inputs_are_not_resumed) {
  finish(now());
  folder.write("results/result.json", "{\"format\": \"asperity-result/1\"}");
  EXPECT_SAYS(resumed(now()), "a version of asperity that did not record its inputs");
}

TEST_F(CaseFolder_analytic, a_scan_that_has_changed_is_another_input) {
  folder.write("scan.txt", "0 1\n1 0\n");
  const std::vector<std::string> rough{"Substrate/Topography=scan(scan.txt, size=1 um, unit=nm)"};
  finish(now(rough));
  EXPECT_EQ(check_folder(now(rough), IfSolved::resume), SolveStart::finished);
  folder.write("scan.txt", "0 1\n1 2\n");
  EXPECT_SAYS(resumed(now(rough)), "another content of the scan");
}

TEST_F(CaseFolder_analytic, case_prm_says_what_is_solved_and_where_from) {
  const fs::path remembered = results / "case.prm";
  claim_folder(now({"Experiment/Normal load=2 mN"}), SolveStart::anew);
  EXPECT_DOUBLE_EQ(read_case(remembered).experiment.normal_load, 2e-3);
  const FolderedCase next = of(remembered, {"Experiment/Normal load=3 mN"}, "c2");
  claim_folder(next, SolveStart::anew);
  EXPECT_DOUBLE_EQ(read_case(remembered).experiment.normal_load, 3e-3);
  const std::string text = read_file(remembered);
  EXPECT_EQ(text.rfind("# inputs_sha256: " + next.provenance.inputs_sha256 + "\n# commit: c2\n", 0), 0u)
      << text;
  EXPECT_EQ(text.find("# commit: c1"), std::string::npos) << text;
  EXPECT_FALSE(fs::exists(results / "case_given.prm"));
}

TEST_F(CaseFolder_analytic, a_case_file_written_there_by_a_person_is_kept) {
  const fs::path own = folder.write("results/case.prm", smooth_case());
  claim_folder(of(own, {"Solver/Threads=1"}), SolveStart::anew);
  EXPECT_NE(read_file(own).find("# borosilicate"), std::string::npos) << "the same case keeps its comments";
  EXPECT_EQ(read_case(own).solver.threads, 0);
  folder.write("results/case.prm", smooth_case());
  claim_folder(of(own, {"Experiment/Normal load=2 mN"}), SolveStart::anew);
  EXPECT_DOUBLE_EQ(read_case(own).experiment.normal_load, 2e-3);
  EXPECT_EQ(read_file(results / "case_given.prm"), smooth_case());
}

TEST_F(CaseFolder_analytic, a_file_or_a_link_to_nowhere_is_no_folder) {
  folder.write("results", "");
  EXPECT_SAYS(message_of<InputError>([&] { check_folder(now(), IfSolved::overwrite); }), "is no folder");
  fs::remove(results);
  fs::create_symlink("nowhere", results);
  EXPECT_SAYS(message_of<InputError>([&] { check_folder(now(), IfSolved::overwrite); }), "is no folder");
}

}  // namespace asperity
