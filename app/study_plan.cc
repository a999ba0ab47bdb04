#include "app/study_plan.h"

#include <algorithm>
#include <cmath>

#include "app/folder_lock.h"
#include "app/study_folders.h"
#include "app/study_summary.h"
#include "core/atomic_file.h"
#include "core/output_folder.h"
#include "core/printed.h"
#include "core/wait_text.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Estimates are good to a factor of two, and nodes differ.
constexpr double time_margin = 4, memory_margin = 1.5;
constexpr double mebibyte = 1024.0 * 1024;

long minutes_asked(double seconds) {
  return std::max(10L, std::lround(std::ceil(time_margin * seconds / 60)));
}
long mebibytes_asked(double bytes) { return std::lround(std::ceil(memory_margin * bytes / mebibyte)); }

/// A text as one word of the shell, whatever is in it.
std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

/// Which program the scripts call.
std::string choice_of_program(const StudyPlanOptions& options) {
  return "[ -n \"$ASPERITY\" ] || ASPERITY=" + shell_word(options.program.string()) + "\n";
}

std::string joined_overrides(const StudyPlanOptions& options) {
  std::string text;
  for (const auto& one : options.overrides) text += " --set " + shell_word(one);
  return text;
}

std::string cases_csv(const std::vector<PlannedCase>& cases) {
  std::string text = "case,seconds [s],memory [MiB],minutes asked for,memory asked for [MiB]\n";
  for (const PlannedCase& one : cases)
    text += printed("%s,%.0f,%.0f,%ld,%ld\n", one.name.c_str(), one.seconds, one.memory / mebibyte,
                    minutes_asked(one.seconds), mebibytes_asked(one.memory));
  return text;
}

std::string solve_case_script(const StudyPlanOptions& options) {
  return "#!/bin/sh\n"
         "# One case of the study, or what is left of it: plan/solve_case CASE [THREADS]. A case that was "
         "solved is "
         "left as it is.\n"
         "# ASPERITY names another program than that below.\n" +
         choice_of_program(options) +
         "cd \"$(dirname \"$0\")/..\" || exit 1\n"
         "threads=${2:-1}\n"
         "export OMP_NUM_THREADS=\"$threads\"\n"
         "exec \"$ASPERITY\" solve \"./$1/case.prm\" --output \"./$1\" --set \"Solver/Threads=$threads\" "
         "--resume >> "
         "\"./$1/solve.log\" 2>&1\n";
}

std::string gather_script(const Study& study, const StudyPlanOptions& options) {
  return "#!/bin/sh\n# Collects what came back: study.csv, study.json and report.html.\n" +
         choice_of_program(options) + "cd \"$(dirname \"$0\")/..\" || exit 1\n\"$ASPERITY\" study " +
         shell_word(fs::absolute(study.file).string()) + joined_overrides(options) +
         " --output . --gather && exec \"$ASPERITY\" report .\n";
}

std::string snakefile(const std::vector<PlannedCase>& cases) {
  std::string text = R"(# Written by asperity study --plan. In the study's folder:
#   snakemake -s plan/Snakefile --cores 2                            on this machine
#   snakemake -s plan/Snakefile --slurm --jobs 100                   on a cluster with Slurm
# A case that was interrupted goes on after its last step.
import os

workdir: os.path.dirname(os.path.dirname(os.path.abspath(workflow.snakefile)))

# name, minutes, MiB; largest first
CASES = [
)";
  for (const PlannedCase& one : cases)
    text += "    (\"" + one.name + "\", " + std::to_string(minutes_asked(one.seconds)) + ", " +
            std::to_string(mebibytes_asked(one.memory)) + "),\n";
  return text + R"(]

rule all:
    input: "plan/gathered"

rule gather:
    input: ["plan/solved/" + name for name, minutes, memory in CASES]
    output: touch("plan/gathered")
    shell: "plan/gather"

for place, (name, minutes, memory) in enumerate(CASES):
    rule:
        name: "case_%d" % (place + 1)
        output: touch("plan/solved/" + name)
        params: case=name
        threads: 1
        priority: len(CASES) - place
        retries: 2
        resources: mem_mb=memory, runtime=minutes
        shell: "plan/solve_case {params.case:q} {threads}"
)";
}

/// Cases that follow each other and ask for memory of one power of two.
struct Array {
  std::size_t first = 0, last = 0;  ///< counted from 1
  long minutes = 0, mebibytes = 0;
};

std::vector<Array> arrays_of(const std::vector<PlannedCase>& cases) {
  std::vector<Array> arrays;
  const auto size_class = [](long mebibytes) { return std::ilogb(static_cast<double>(mebibytes)); };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const long mebibytes = mebibytes_asked(cases[i].memory), minutes = minutes_asked(cases[i].seconds);
    if (arrays.empty() || size_class(arrays.back().mebibytes) != size_class(mebibytes))
      arrays.push_back({i + 1, i + 1, minutes, mebibytes});
    Array& array = arrays.back();
    array.last = i + 1;
    array.minutes = std::max(array.minutes, minutes);
  }
  return arrays;
}

std::string slurm_submission(const std::vector<PlannedCase>& cases) {
  std::string text =
      "#!/bin/sh\n# Written by asperity study --plan: an array of jobs for each size of memory, largest "
      "first, then "
      "what collects them.\n# Arguments go to each sbatch: plan/submit_to_slurm --partition=short\n"
      "set -e\ncd \"$(dirname \"$0\")/..\"\njobs=\n"
      "submit() {\n  array=$1 memory=$2 minutes=$3\n  shift 3\n"
      "  id=$(sbatch --parsable --job-name=asperity --array=\"$array\" --mem=\"${memory}M\" "
      "--time=\"$minutes\" \\\n"
      "              --cpus-per-task=1 --requeue --open-mode=append --output=plan/slurm_%A_%a.log \"$@\" "
      "plan/slurm_case)\n"
      "  echo \"job ${id%%;*}: cases $array of plan/cases.csv\"\n  jobs=$jobs:${id%%;*}\n}\n";
  for (const Array& array : arrays_of(cases))
    text +=
        printed("submit %zu-%zu %ld %ld \"$@\"\n", array.first, array.last, array.mebibytes, array.minutes);
  return text +
         "id=$(sbatch --parsable --job-name=asperity-gather --dependency=\"afterany$jobs\" --mem=2000M "
         "--time=60 \\\n"
         "            --output=plan/slurm_%A.log \"$@\" --wrap=plan/gather)\n"
         "echo \"job ${id%%;*}: collects them\"\n";
}

const char* const slurm_case_script = R"(#!/bin/sh
# The case in this row of plan/cases.csv, below its title; Slurm starts it in the study's folder.
name=$(sed -n "$((SLURM_ARRAY_TASK_ID + 1))p" plan/cases.csv | cut -d , -f 1)
exec plan/solve_case "$name" "${SLURM_CPUS_PER_TASK:-1}"
)";

std::vector<CaseProgress> progress_in(const Study& study, const StudyFolders& folders) {
  std::vector<CaseProgress> progress(study.cases.size());
  for (std::size_t i = 0; i < progress.size(); ++i)
    if (folders.is_solved(i)) progress[i].state = CaseProgress::State::done;
  return progress;
}

void write_script(const fs::path& path, const std::string& text) {
  write_file_atomically(path, text);
  fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                  fs::perm_options::add);
}

}  // namespace

std::vector<PlannedCase> prepare_planned_cases(const Study& study, const fs::path& output,
                                               const CaseCost& cost) {
  make_folder(output);
  const FolderLock lock(output);
  const StudyFolders folders(study, output);
  folders.refuse_other_inputs();
  std::vector<PlannedCase> cases;
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    if (folders.is_solved(i)) continue;
    folders.prepare(i);
    PlannedCase planned = cost(study.cases[i]);
    planned.name = study.cases[i].name;
    cases.push_back(planned);
  }
  const auto size_class = [](const PlannedCase& one) {
    return std::ilogb(static_cast<double>(mebibytes_asked(one.memory)));
  };
  std::stable_sort(cases.begin(), cases.end(), [&](const PlannedCase& a, const PlannedCase& b) {
    return size_class(a) != size_class(b) ? size_class(a) > size_class(b) : a.seconds > b.seconds;
  });
  write_study_summary(study, progress_in(study, folders), output);
  return cases;
}

std::vector<std::string> write_study_plan(const Study& study, const std::vector<PlannedCase>& cases,
                                          const StudyPlanOptions& options) {
  const fs::path plan = options.output / "plan";
  make_folder(plan);
  // A case that is planned anew, its folder having been removed or set aside, is not solved for Snakemake
  // either.
  for (const PlannedCase& one : cases) fs::remove(plan / "solved" / one.name);
  fs::remove(plan / "gathered");
  write_file_atomically(plan / "cases.csv", cases_csv(cases));
  write_script(plan / "solve_case", solve_case_script(options));
  write_script(plan / "gather", gather_script(study, options));
  write_file_atomically(plan / "Snakefile", snakefile(cases));
  write_script(plan / "submit_to_slurm", slurm_submission(cases));
  write_script(plan / "slurm_case", slurm_case_script);
  double seconds = 0, longest = 0, most_memory = 0;
  for (const PlannedCase& one : cases) {
    seconds += one.seconds;
    longest = std::max(longest, one.seconds), most_memory = std::max(most_memory, one.memory);
  }
  const std::string folder = options.output.string();
  return {
      std::to_string(cases.size()) + " of " + std::to_string(study.cases.size()) + " cases to solve, about " +
          wait_text(seconds) + " on one core in all, the longest " + wait_text(longest) + ", the largest " +
          printed("%.1f GiB", most_memory / (1024 * mebibyte)) + "; to a factor of two",
      "in " + folder + ":",
      "  snakemake -s plan/Snakefile --cores 2       on one machine (--slurm --jobs 100 on a cluster)",
      "  plan/submit_to_slurm                        through Slurm alone",
      "  plan/gather                                 what came back, at any time: study.csv and report.html"};
}

std::size_t gather_study(const Study& study, const fs::path& output) {
  const FolderLock lock(output);
  const StudyFolders folders(study, output);
  folders.refuse_other_inputs();
  const auto progress = progress_in(study, folders);
  write_study_summary(study, progress, output);
  return static_cast<std::size_t>(
      std::count_if(progress.begin(), progress.end(),
                    [](const CaseProgress& one) { return one.state == CaseProgress::State::done; }));
}

}  // namespace asperity
