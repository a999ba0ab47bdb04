#include "app/study_runner.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/error.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using test::smooth_case;
using test::TemporaryFolder;
using State = CaseProgress::State;

/// Writes a result whose stiffness is the seed of the case, says how often it was called, and fails for 2 mN
/// while there is no file `mended` beside it. With a file `slow` beside it, it never ends.
const char* const stand_in_solver = R"(#!/bin/sh
here=$(dirname "$0")
case_file=$2; output=$4
echo "$@" >> "$output/calls"
if [ -e "$here/slow" ]; then echo $$ > "$output/begun"; exec sleep 1000; fi
if grep -q '2 mN' "$case_file" && ! [ -e "$here/mended" ]; then
  printf "the step did not converge\n" >&2
  exit 1
fi
inputs=$(sed -n 's/^# inputs_sha256: //p' "$case_file")
seed=$(sed -n '/set Topography/s/.*seed=\([0-9]*\).*/\1/p' "$case_file")
cat > "$output/result.json" <<END
{"format": "asperity-result/1", "inputs_sha256": "$inputs",
 "effective": {"normal_stiffness": {"value": ${seed:-7}, "unit": "N/m", "sd": 0.5}}}
END
)";

class StudyRunner : public testing::Test {
 protected:
  StudyRunner() {
    options_.output = folder_.path / "results";
    options_.cores = 2;
    options_.program = folder_.write("solver", stand_in_solver);
    fs::permissions(options_.program, fs::perms::owner_all);
    options_.say = [this](const std::string& line) { said_.push_back(line); };
  }

  Study study(const std::string& study_section) const {
    return read_study(folder_.write("study.prm", smooth_case() + study_section));
  }
  Study two_loads() const {
    return study("subsection Study\n subsection Vary\n set Experiment/Normal load = 1 mN, 2 mN\n end\nend\n");
  }
  std::string calls(const std::string& name) const { return read_file(options_.output / name / "calls"); }
  nlohmann::json summary() const { return nlohmann::json::parse(read_file(options_.output / "study.json")); }

  TemporaryFolder folder_;
  StudyRunOptions options_;
  std::vector<std::string> said_;
};

bool waits_for(const fs::path& file) {
  const auto written = [&] { return fs::exists(file) && fs::file_size(file) > 0; };
  for (int i = 0; i < 200 && !written(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return written();
}

/// False also for one that has ended and that nobody has waited for.
bool is_running(pid_t process) {
  std::ifstream stream("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  return std::getline(stream, text) && text.find(") Z") == std::string::npos;
}

}  // namespace

TEST_F(StudyRunner, a_failing_case_is_reported_and_the_others_go_on_behaviour) {
  const auto progress = run_study(two_loads(), options_);
  ASSERT_EQ(progress.size(), 2u);
  EXPECT_EQ(progress[0].state, State::done);
  EXPECT_EQ(progress[1].state, State::failed);
  EXPECT_EQ(progress[1].message, "the step did not converge");
  const auto table = read_csv(options_.output / "study.csv");
  EXPECT_EQ(table.rows[1][table.column("state")], "failed");
  EXPECT_EQ(table.rows[0][table.column("Normal load")], "1 mN");
  EXPECT_DOUBLE_EQ(table.numbers("normal_stiffness [N/m]")[0], 7);
}

TEST_F(StudyRunner, says_how_long_all_takes_and_what_is_left_by_what_each_is_expected_to_take_behaviour) {
  folder_.write("mended", "");
  options_.expected_seconds = [](const StudyCase& item) { return item.name == "1_mN" ? 1.0 : 1e5; };
  Study study = two_loads();
  study.parallel_cases = 1;
  run_study(study, options_);
  const auto said = [&](const std::string& part) {
    return std::any_of(said_.begin(), said_.end(),
                       [&](const std::string& line) { return line.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(said("all together about 27.8 h, to a factor of two")) << said_.at(1);
  // The first took a moment; the other is to take 1e5 times as long.
  const auto first = std::find_if(said_.begin(), said_.end(), [](const std::string& line) {
    return line.find("[1/2] 1_mN: done in ") != std::string::npos;
  });
  ASSERT_NE(first, said_.end());
  EXPECT_NE(first->find(" left"), std::string::npos) << *first;
  EXPECT_EQ(first->find(" s left"), std::string::npos) << *first;
}

TEST_F(StudyRunner, resuming_keeps_complete_cases_and_tries_the_failed_ones_again_behaviour) {
  run_study(two_loads(), options_);
  folder_.write("mended", "");
  options_.resume = true;
  const auto progress = run_study(two_loads(), options_);
  EXPECT_EQ(progress[1].state, State::done);
  const std::string first = calls("1_mN"), second = calls("2_mN");
  EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 1);
  EXPECT_EQ(std::count(second.begin(), second.end(), '\n'), 2);
  EXPECT_NE(second.find("--resume"), std::string::npos);
  EXPECT_EQ(first.find("--resume"), std::string::npos);
}

TEST_F(StudyRunner, cases_that_are_not_chosen_wait_and_are_solved_by_going_on_behaviour) {
  options_.chosen = [](const std::string& name) { return name == "1_mN"; };
  auto progress = run_study(two_loads(), options_);
  EXPECT_EQ(progress[0].state, State::done);
  EXPECT_EQ(progress[1].state, State::waiting);
  EXPECT_EQ(summary()["cases"][1]["state"], "waiting");
  EXPECT_FALSE(fs::exists(options_.output / "2_mN" / "calls"));
  EXPECT_NE(said_.front().find("2 cases, 0 of them done already; 1 of the others chosen"), std::string::npos)
      << said_.front();
  folder_.write("mended", "");
  options_.resume = true, options_.chosen = [](const std::string&) { return true; };
  progress = run_study(two_loads(), options_);
  EXPECT_EQ(progress[1].state, State::done);
  const std::string first = calls("1_mN");
  EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 1);
}

TEST_F(StudyRunner, a_case_whose_checkpoint_cannot_be_gone_on_with_is_solved_anew_behaviour) {
  run_study(two_loads(), options_);
  folder_.write("mended", "");
  options_.objection_to_resume = [](const fs::path& folder, const std::string&) {
    return folder.filename() == "2_mN" ? "is damaged" : "";
  };
  options_.resume = true;
  EXPECT_EQ(run_study(two_loads(), options_)[1].state, State::done);
  EXPECT_EQ(calls("2_mN").find("--resume"), std::string::npos);
  EXPECT_NE(calls("2_mN").find("--overwrite"), std::string::npos);
  EXPECT_NE(std::find(said_.begin(), said_.end(), "2_mN: solved anew, for its checkpoint is damaged"),
            said_.end());
}

TEST_F(StudyRunner, a_result_cut_off_in_writing_is_not_taken_for_complete_behaviour) {
  run_study(two_loads(), options_);
  folder_.write("results/1_mN/result.json", "{\"format\": \"asperity-res");
  options_.resume = true;
  EXPECT_EQ(run_study(two_loads(), options_)[0].state, State::done);
  const std::string first = calls("1_mN");
  EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 2);
}

TEST_F(StudyRunner, a_complete_case_whose_input_changed_is_solved_anew_when_asked_behaviour) {
  run_study(study("subsection Study\nend\n"), options_);
  options_.resume = true;
  const Study changed = study("subsection Mesh\n set Layers = 6\nend\n");
  const std::string message = message_of<InputError>([&] { run_study(changed, options_); });
  EXPECT_NE(message.find("case case: "), std::string::npos) << message;
  EXPECT_NE(message.find("was solved with Mesh/Layers = 4, and now it is 6; --overwrite"), std::string::npos)
      << message;
  EXPECT_NE(read_file(options_.output / "case" / "case.prm").find("Layers = 4"), std::string::npos)
      << "nothing is written before";
  options_.overwrite = true;
  run_study(changed, options_);
  const std::string only = calls("case");
  EXPECT_EQ(std::count(only.begin(), only.end(), '\n'), 1);
  EXPECT_EQ(only.find("--resume"), std::string::npos);
  EXPECT_NE(read_file(options_.output / "case" / "case.prm").find("Layers = 6"), std::string::npos);
  // What was solved before is not lost.
  EXPECT_NE(read_file(options_.output / "earlier" / "case" / "case.prm").find("Layers = 4"),
            std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(options_.output / "earlier" / "case" / "result.json"));
}

TEST_F(StudyRunner, a_complete_case_is_not_kept_if_its_scan_changed_or_it_does_not_say_its_inputs_behaviour) {
  folder_.write("scan.txt", "0 1\n1 0\n");
  const Study rough =
      study("subsection Substrate\n set Topography = scan(scan.txt, size=1 um, unit=nm)\nend\n");
  run_study(rough, options_);
  options_.resume = true;
  EXPECT_EQ(run_study(rough, options_)[0].state, State::done);
  folder_.write("scan.txt", "0 1\n1 2\n");
  EXPECT_NE(message_of<InputError>([&] { run_study(rough, options_); }).find("another content of the scan"),
            std::string::npos);
  folder_.write("results/case/result.json", "{\"format\": \"asperity-result/1\"}");
  EXPECT_NE(message_of<InputError>([&] { run_study(rough, options_); }).find("did not record its inputs"),
            std::string::npos);
  // Other cases can be solved meanwhile; this one's result is then not among the study's.
  options_.overwrite = true, options_.chosen = [](const std::string&) { return false; };
  EXPECT_EQ(run_study(rough, options_)[0].state, State::waiting);
}

TEST_F(StudyRunner, a_case_of_a_program_that_knew_fewer_entries_is_kept_behaviour) {
  run_study(study("subsection Study\nend\n"), options_);
  const auto file = options_.output / "case" / "case.prm";
  std::string text = read_file(file);
  const std::string entry = "  set Layers = 4\n";  // the default
  ASSERT_NE(text.find(entry), std::string::npos);
  text.erase(text.find(entry), entry.size());
  write_file_atomically(file, text);
  options_.resume = true;
  EXPECT_EQ(run_study(study("subsection Study\nend\n"), options_)[0].state, State::done);
  const std::string only = calls("case");
  EXPECT_EQ(std::count(only.begin(), only.end(), '\n'), 1);
}

TEST_F(StudyRunner, an_earlier_study_is_not_overwritten_unasked_behaviour) {
  run_study(two_loads(), options_);
  EXPECT_NE(message_of<InputError>([&] { run_study(two_loads(), options_); }).find("add --resume"),
            std::string::npos);
}

TEST_F(StudyRunner, the_scatter_over_realisations_is_the_sample_standard_deviation_analytic) {
  run_study(study("subsection Study\n set Realisations = 3\n subsection Vary\n"
                  "  set Substrate/Topography = generated(rms=1 nm, seed=5)\n end\nend\n"),
            options_);
  const auto stiffness = summary()["groups"][0]["effective"]["normal_stiffness"];
  // Seeds 5, 1005, 2005.
  EXPECT_DOUBLE_EQ(stiffness["value"].get<double>(), 1005);
  EXPECT_DOUBLE_EQ(stiffness["realisation_sd"].get<double>(), 1000);
  EXPECT_DOUBLE_EQ(stiffness["case_sd"].get<double>(), 0.5);
}

TEST_F(StudyRunner, each_case_runs_from_a_complete_case_file_with_its_share_of_the_cores_behaviour) {
  options_.cores = 4;
  run_study(two_loads(), options_);
  EXPECT_NE(calls("1_mN").find("Solver/Threads=2"), std::string::npos);
  EXPECT_NE(read_file(options_.output / "2_mN" / "case.prm").find("set Normal load = 2 mN"),
            std::string::npos);
}

TEST_F(StudyRunner, a_signal_stops_the_running_cases_and_resuming_finishes_them_behaviour) {
  const Study both = two_loads();
  const fs::path slow = folder_.write("slow", ""), mended = folder_.write("mended", "");
  const pid_t child = ::fork();
  if (child == 0) {
    const auto progress = run_study(both, options_);
    ::_exit(progress[0].state == State::stopped && progress[1].state == State::stopped ? 0 : 1);
  }
  ASSERT_TRUE(waits_for(options_.output / "1_mN" / "begun"));
  ASSERT_TRUE(waits_for(options_.output / "2_mN" / "begun"));
  EXPECT_NE(message_of<InputError>([&] { run_study(both, options_); }).find("another study is running"),
            std::string::npos);
  ::kill(child, SIGINT);
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(summary()["cases"][0]["state"], "stopped");

  fs::remove(slow);
  options_.resume = true;
  for (const auto& progress : run_study(both, options_)) EXPECT_EQ(progress.state, State::done);
}

TEST_F(StudyRunner, a_killed_study_leaves_valid_files_and_no_running_solver_behaviour) {
  const Study both = two_loads();
  const fs::path slow = folder_.write("slow", ""), mended = folder_.write("mended", "");
  const pid_t child = ::fork();
  if (child == 0) {
    run_study(both, options_);
    ::_exit(1);
  }
  ASSERT_TRUE(waits_for(options_.output / "2_mN" / "begun"));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  const fs::path cut_off = folder_.write("results/study.json.tmp123", "{");
  EXPECT_EQ(summary()["cases"].size(), 2u);
  const pid_t solver = std::stoi(read_file(options_.output / "2_mN" / "begun"));
  for (int i = 0; i < 100 && is_running(solver); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(is_running(solver));

  fs::remove(slow);
  options_.resume = true;
  for (const auto& progress : run_study(both, options_)) EXPECT_EQ(progress.state, State::done);
  EXPECT_FALSE(fs::exists(cut_off));
}

}  // namespace asperity
