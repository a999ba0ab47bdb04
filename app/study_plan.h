// A study for a cluster: `asperity study --plan` writes its cases as restartable units with their cost,
// largest first, and how Snakemake and Slurm run them; `--gather` collects what came back. Both are engines
// of other people: nothing here runs a case.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/study.h"

namespace asperity {

/// A case that is still to be solved, on one core.
struct PlannedCase {
  std::string name;    ///< its folder
  double seconds = 0;  ///< to a factor of two [s]
  double memory = 0;   ///< peak, roughly [byte]
};

/// What the files need beside the cases.
struct StudyPlanOptions {
  std::filesystem::path output;        ///< the study's folder
  std::filesystem::path program;       ///< asperity, as the machines of the cluster see it
  std::vector<std::string> overrides;  ///< of the study file, as for read_study
};

/// Estimates time and memory of a case; the name is not looked at.
using CaseCost = std::function<PlannedCase(const StudyCase&)>;

/// Cases without a result of their inputs, by memory and then time, largest first. Makes each case's folder
/// with its case.prm, as run_study does. Throws InputError where a complete case is of other inputs.
std::vector<PlannedCase> prepare_planned_cases(const Study& study, const std::filesystem::path& output,
                                               const CaseCost& cost);

/// Writes into DIR/plan: cases.csv, solve_case (one case, or go on with it), gather, Snakefile,
/// submit_to_slurm and slurm_case. Returns what was written and how it is run, in lines.
std::vector<std::string> write_study_plan(const Study& study, const std::vector<PlannedCase>& cases,
                                          const StudyPlanOptions& options);

/// study.json and study.csv from what is in the folder; solves nothing. Returns how many cases have a result.
/// Throws InputError as above.
std::size_t gather_study(const Study& study, const std::filesystem::path& output);

}  // namespace asperity
