#include "app/study_runner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>

#include "app/expected_times.h"
#include "app/folder_lock.h"
#include "app/study_folders.h"
#include "core/atomic_file.h"
#include "core/child_process.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "core/wait_text.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using State = CaseProgress::State;

constexpr auto poll_interval = std::chrono::milliseconds(50);
constexpr auto look_interval = std::chrono::seconds(1);
constexpr auto report_interval = std::chrono::seconds(30);
constexpr auto stop_grace = std::chrono::seconds(10);

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

volatile sig_atomic_t stop_requested = 0;

/// While it lives, SIGINT and SIGTERM ask the study to stop.
class StopOnSignal {
 public:
  StopOnSignal() {
    stop_requested = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { stop_requested = 1; };
    ::sigaction(SIGINT, &action, &interrupt_before_);
    ::sigaction(SIGTERM, &action, &terminate_before_);
  }
  ~StopOnSignal() {
    ::sigaction(SIGINT, &interrupt_before_, nullptr);
    ::sigaction(SIGTERM, &terminate_before_, nullptr);
  }
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

 private:
  struct sigaction interrupt_before_ {
  }, terminate_before_{};
};

std::string last_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line, last;
  while (std::getline(stream, line)) {
    line = line.substr(line.rfind('\r') + 1);
    if (line.find_first_not_of(" \t") != std::string::npos) last = line;
  }
  return last;
}

class StudyRun {
 public:
  StudyRun(const Study& study, const StudyRunOptions& options)
      : study_(study), options_(options), progress_(study.cases.size()), folders_(study, options.output) {}

  std::vector<CaseProgress> run() {
    prepare();
    const StopOnSignal stop_on_signal;
    write_study_summary(study_, progress_, options_.output);
    while (!stop_requested) {
      start_waiting_cases();
      if (running_.empty()) break;
      std::this_thread::sleep_for(poll_interval);
      collect_ended_cases();
      stop_cases_with_a_reason();
      report_running_cases();
    }
    if (stop_requested) stop_running_cases();
    write_study_summary(study_, progress_, options_.output);
    return std::move(progress_);
  }

 private:
  struct Running {
    std::size_t index;
    ChildProcess process;
    Clock::time_point start;
    std::string stopped_for;  ///< why it was asked to end
  };

  /// Summaries that an earlier run was killed in writing.
  void remove_unfinished_files() const {
    std::vector<fs::path> unfinished;
    for (const auto& item : fs::directory_iterator(options_.output)) {
      const std::string name = item.path().filename().string();
      if (name.rfind("study.", 0) == 0 && name.find(".tmp") != std::string::npos)
        unfinished.push_back(item.path());
    }
    for (const auto& path : unfinished) fs::remove(path);
  }

  /// What is there of a case from an earlier run: complete ones are kept, those of other inputs set aside.
  void prepare_case(std::size_t i) {
    if (folders_.is_solved(i)) {
      progress_[i].state = State::done;
      return;
    }
    if (folders_.has_result(i) && !chosen(i)) {
      options_.say(study_.cases[i].name +
                   ": its result is of other inputs and left out; it is not among the cases chosen");
      return;
    }
    const fs::path earlier = folders_.prepare(i);
    if (!earlier.empty())
      options_.say(study_.cases[i].name +
                   ": its input has changed; it is solved anew, what was there is in " + earlier.string());
  }

  void prepare() {
    remove_unfinished_files();
    if (!options_.overwrite) folders_.refuse_other_inputs();
    for (std::size_t i = 0; i < study_.cases.size(); ++i) prepare_case(i);
    long to_do = 0, done = 0;
    for (std::size_t i = 0; i < progress_.size(); ++i) {
      if (chosen(i)) ++chosen_;
      if (progress_[i].state == State::done)
        ++done;
      else if (chosen(i))
        ++to_do;
    }
    const int wanted = study_.parallel_cases > 0 ? study_.parallel_cases : options_.cores;
    parallel_ = std::clamp(static_cast<int>(to_do), 1, wanted);
    const std::string all = std::to_string(study_.cases.size());
    options_.say(all + " cases, " + std::to_string(done) + " of them done already; " +
                 (chosen_ < static_cast<long>(study_.cases.size())
                      ? std::to_string(to_do) + " of the others chosen; "
                      : "") +
                 std::to_string(parallel_) + " at a time");
    expect_times(to_do);
  }

  bool chosen(std::size_t index) const { return options_.chosen(study_.cases[index].name); }

  void start_waiting_cases() {
    for (; next_ < study_.cases.size() && running_.size() < static_cast<std::size_t>(parallel_); ++next_)
      if (progress_[next_].state == State::waiting && chosen(next_)) start(next_);
  }

  void start(std::size_t index) {
    const std::string threads = std::to_string(std::max(1, options_.cores / parallel_));
    const fs::path folder = folders_.folder(index);
    std::vector<std::string> arguments{
        options_.program.string(), "solve", folders_.case_file(index).string(), "--output",
        folder.string(),           "--set", "Solver/Threads=" + threads};
    const bool begun = folders_.has_begun(index);
    const std::string objection = begun ? options_.objection_to_resume(folder, folders_.inputs(index)) : "";
    if (begun) arguments.push_back(objection.empty() ? "--resume" : "--overwrite");
    running_.push_back({index, ChildProcess(arguments, folders_.log(index), {"OMP_NUM_THREADS=" + threads}),
                        Clock::now(), ""});
    progress_[index].state = State::running;
    options_.say(study_.cases[index].name + (!begun ? ": started"
                                             : objection.empty()
                                                 ? ": resumed"
                                                 : ": solved anew, for its checkpoint " + objection));
  }

  void collect_ended_cases() {
    bool any = false;
    for (auto& running : running_) {
      const auto status = running.process.exit_status();
      if (!status) continue;
      any = true;
      finish(running, *status);
    }
    if (!any) return;
    std::vector<Running> still;
    for (auto& running : running_)
      if (progress_[running.index].state == State::running) still.push_back(std::move(running));
    running_.swap(still);
    write_study_summary(study_, progress_, options_.output);
  }

  void finish(const Running& running, int status) {
    CaseProgress& progress = progress_[running.index];
    progress.seconds = seconds_since(running.start);
    const std::string& name = study_.cases[running.index].name;
    if (status == 0 && folders_.has_result(running.index)) {
      progress.state = State::done;
      times_.was_solved(running.index, progress.seconds);
    } else if (!running.stopped_for.empty()) {
      progress.state = State::stopped;
      progress.message = running.stopped_for;
    } else {
      progress.state = State::failed;
      progress.message = last_line(folders_.log(running.index));
      if (progress.message.empty())
        progress.message = status == 0 ? "it left no complete result.json"
                                       : "it ended with status " + std::to_string(status);
    }
    long ended = 0;
    for (std::size_t i = 0; i < progress_.size(); ++i)
      if (chosen(i) && progress_[i].state != State::waiting && progress_[i].state != State::running) ++ended;
    const std::string counter = "[" + std::to_string(ended) + "/" + std::to_string(chosen_) + "] ";
    options_.say(counter + name + ": " +
                 (progress.state == State::done      ? "done in " + wait_text(progress.seconds)
                  : progress.state == State::stopped ? "stopped: " + progress.message
                                                     : "failed: " + progress.message) +
                 time_left());
  }

  /// Of the cases that are to be solved in this run.
  void expect_times(long to_do) {
    std::vector<double> expected(study_.cases.size(), 1.0);
    double sum = 0;
    for (std::size_t i = 0; i < study_.cases.size() && options_.expected_seconds; ++i)
      if (progress_[i].state == State::waiting && chosen(i))
        sum += expected[i] = options_.expected_seconds(study_.cases[i]);
    if (to_do > 1 && sum > 0)
      options_.say("all together about " + wait_text(sum / parallel_) + ", to a factor of two");
    times_ = ExpectedTimes(std::move(expected));
  }

  std::string time_left() const {
    if (!times_.are_known()) return "";
    double seconds = 0;
    for (std::size_t i = 0; i < progress_.size(); ++i)
      if (progress_[i].state == State::waiting && chosen(i)) seconds += times_.left_of(i, 0);
    for (const auto& running : running_)
      if (progress_[running.index].state == State::running)
        seconds += times_.left_of(running.index, seconds_since(running.start));
    return seconds > 0 ? "; about " + wait_text(seconds / parallel_) + " left" : "";
  }

  void stop_cases_with_a_reason() {
    if (!options_.reason_to_stop || Clock::now() - last_look_ < look_interval) return;
    last_look_ = Clock::now();
    for (auto& running : running_) {
      if (!running.stopped_for.empty()) continue;
      running.stopped_for =
          options_.reason_to_stop(folders_.folder(running.index), seconds_since(running.start));
      if (!running.stopped_for.empty()) running.process.ask_to_stop();
    }
  }

  void report_running_cases() {
    if (Clock::now() - last_report_ < report_interval) return;
    last_report_ = Clock::now();
    for (const auto& running : running_) {
      const std::string line = last_line(folders_.log(running.index));
      if (!line.empty()) options_.say("  " + study_.cases[running.index].name + ": " + line);
    }
  }

  void stop_running_cases() {
    options_.say("stopping " + std::to_string(running_.size()) + " running cases, which keep what they have");
    for (auto& running : running_) running.process.ask_to_stop();
    const auto start = Clock::now();
    const auto all_ended = [&] {
      return std::all_of(running_.begin(), running_.end(),
                         [](Running& r) { return r.process.exit_status().has_value(); });
    };
    while (!all_ended() && Clock::now() - start < stop_grace) std::this_thread::sleep_for(poll_interval);
    for (const auto& running : running_)
      progress_[running.index].state = folders_.has_result(running.index) ? State::done : State::stopped;
    running_.clear();
  }

  const Study& study_;
  const StudyRunOptions& options_;
  std::vector<CaseProgress> progress_;
  const StudyFolders folders_;
  std::vector<Running> running_;
  std::size_t next_ = 0;
  int parallel_ = 1;
  long chosen_ = 0;
  ExpectedTimes times_;
  Clock::time_point last_report_ = Clock::now(), last_look_ = Clock::now();
};

}  // namespace

std::vector<CaseProgress> run_study(const Study& study, const StudyRunOptions& options) {
  make_folder(options.output);
  const FolderLock lock(options.output);
  if (!options.resume && !options.overwrite && fs::exists(options.output / "study.json"))
    throw InputError("'" + options.output.string() +
                     "' holds a study already; add --resume to go on with it, or choose another folder");
  return StudyRun(study, options).run();
}

}  // namespace asperity
