// A study on a cluster: its cases with their cost, the scripts that solve them one by one, and what gathers
// them; through Snakemake and a Slurm of one node where these are installed.
#include "app/study_plan.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::call_program;
using test::Outcome;
using test::smooth_case;
using test::TemporaryFolder;

const char* const two_loads =
    "subsection Study\n subsection Vary\n set Experiment/Normal load = 1 mN, 2 mN, 3 mN\n end\nend\n";

Study study_in(const TemporaryFolder& folder) {
  return read_study(folder.write("study.prm", smooth_case() + two_loads));
}

/// The second load takes most memory, the third most time of the others.
PlannedCase made_up_cost(const StudyCase& item) {
  if (item.name == "2_mN") return {"", 100, 4e9};
  return {"", item.name == "3_mN" ? 900.0 : 300.0, 3e8};
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream stream(read_file(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(StudyPlan_behaviour, lists_cases_by_memory_and_time_and_asks_for_both_with_a_margin) {
  const TemporaryFolder folder;
  const Study study = study_in(folder);
  const auto cases = prepare_planned_cases(study, folder.path / "out", made_up_cost);
  const auto said = write_study_plan(study, cases, {folder.path / "out", "/opt/it's/asperity", {}});
  EXPECT_NE(said.front().find("3 of 3 cases to solve, about 22 min on one core"), std::string::npos)
      << said.front();
  const fs::path plan = folder.path / "out/plan";
  const auto rows = lines_of(plan / "cases.csv");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[1], "2_mN,100,3815,10,5723");
  EXPECT_EQ(rows[2], "3_mN,900,286,60,430");
  EXPECT_EQ(rows[3], "1_mN,300,286,20,430");
  const std::string slurm = read_file(plan / "submit_to_slurm");
  EXPECT_NE(slurm.find("submit 1-1 5723 10 "), std::string::npos) << slurm;
  EXPECT_NE(slurm.find("submit 2-3 430 60 "), std::string::npos) << slurm;
  EXPECT_NE(read_file(plan / "solve_case").find("'/opt/it'\\''s/asperity'"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder.path / "out/1_mN/case.prm"));
  for (const char* script : {"solve_case", "gather", "submit_to_slurm", "slurm_case"}) {
    EXPECT_EQ(call_program("sh", "-n " + (plan / script).string()).status, 0) << script;
    EXPECT_NE(fs::status(plan / script).permissions() & fs::perms::owner_exec, fs::perms::none) << script;
  }
}

/// Writes a result of the case's inputs, slowly enough to be seen.
const char* const solver_that_writes_a_result = R"(#!/bin/sh
echo "$@" >> "$4/calls"
inputs=$(sed -n 's/^# inputs_sha256: //p' "$2")
printf '{"format": "asperity-result/1", "inputs_sha256": "%s", "effective": {}}' "$inputs" > "$4/result.json"
)";

TEST(StudyPlan_behaviour, a_case_is_solved_by_its_script_and_is_then_left_out) {
  const TemporaryFolder folder;
  const Study study = study_in(folder);
  const fs::path output = folder.path / "out", solver = folder.write("solver", solver_that_writes_a_result);
  fs::permissions(solver, fs::perms::owner_all);
  write_study_plan(study, prepare_planned_cases(study, output, made_up_cost), {output, solver, {}});
  ASSERT_EQ(call_program((output / "plan/solve_case").string(), "2_mN 2").status, 0);
  EXPECT_EQ(read_file(output / "2_mN/calls"),
            "solve ./2_mN/case.prm --output ./2_mN --set Solver/Threads=2 --resume\n");
  EXPECT_EQ(call_program("env", "SLURM_ARRAY_TASK_ID=3 SLURM_CPUS_PER_TASK=1 sh -c 'cd " + output.string() +
                                    " && plan/slurm_case'")
                .status,
            0);
  EXPECT_TRUE(fs::exists(output / "1_mN/result.json")) << "the third row";
  EXPECT_EQ(gather_study(study, output), 2u);
  const auto summary = nlohmann::json::parse(read_file(output / "study.json"));
  EXPECT_NE(summary.dump().find("waiting"), std::string::npos);
  const auto left = prepare_planned_cases(study, output, made_up_cost);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left.front().name, "3_mN");

  // What Snakemake noted of a case whose folder is gone does not hold any more.
  fs::create_directories(output / "plan/solved");
  for (const char* name : {"1_mN", "2_mN"}) write_file_atomically(output / "plan/solved" / name, "");
  fs::remove_all(output / "2_mN");
  write_study_plan(study, prepare_planned_cases(study, output, made_up_cost), {output, solver, {}});
  EXPECT_FALSE(fs::exists(output / "plan/solved/2_mN"));
  EXPECT_TRUE(fs::exists(output / "plan/solved/1_mN"));
}

/// A planned study of two coarse cases, by the program itself.
std::string planned(const TemporaryFolder& folder) {
  const auto file =
      folder.write("study.prm", smooth_case() +
                                    "subsection Mesh\n  set Interface spacing = 150 nm\nend\n"
                                    "subsection Output\n  set Fields = false\nend\n" +
                                    "subsection Study\n subsection Vary\n set Experiment/Normal load = "
                                    "1 mN, 2 mN\n end\nend\n");
  const auto output = folder.path / "out";
  const Outcome outcome = call("study " + file.string() + " --output " + output.string() + " --plan");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("2 of 2 cases to solve"), std::string::npos) << outcome.output;
  return output.string();
}

void expect_gathered(const std::string& output) {
  EXPECT_TRUE(fs::exists(output + "/report.html"));
  const std::string summary = read_file(output + "/study.csv");
  EXPECT_NE(summary.find("1_mN,done"), std::string::npos) << summary;
  EXPECT_NE(summary.find("2_mN,done"), std::string::npos) << summary;
}

TEST(StudyPlan_other_code, snakemake_solves_and_gathers_a_planned_study) {
  if (call_program("snakemake", "--version").status != 0)
    GTEST_SKIP() << "Snakemake is not installed: apt-get install snakemake";
  const TemporaryFolder folder;
  const std::string output = planned(folder);
  const Outcome run = call_program("cd " + output + " && HOME=" + folder.path.string() + " snakemake",
                                   "-s plan/Snakefile --cores 2");
  EXPECT_EQ(run.status, 0) << run.output;
  expect_gathered(output);
}

TEST(StudyPlanNightly_other_code, a_slurm_of_one_node_solves_and_gathers_a_planned_study) {
  if (call_program("command -v slurmctld", "").status != 0)
    GTEST_SKIP() << "Slurm is not installed: apt-get install slurm-wlm munge";
  const TemporaryFolder folder;
  const std::string output = planned(folder);
  const Outcome run = call_program(
      std::string(ASPERITY_SOURCE_DIR) + "/tests/cluster/one_node_slurm",
      "sh -c '" + output + "/plan/submit_to_slurm; until [ -z \"$(squeue -h)\" ]; do sleep 1; done'");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_NE(run.output.find("cases 1-2 of plan/cases.csv"), std::string::npos) << run.output;
  expect_gathered(output);
}

}  // namespace
}  // namespace asperity
