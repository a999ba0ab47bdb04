// A rough yielding contact that slides, rolls or spins, at one or more spacings: what its first solution
// costs and what the accepted steps of its path cost after it, in time, iterations and memory.
//
//   rough_sliding [CASE.prm] [--spacing "20 nm,10 nm"] [--threads 2] [--output DIR] [--set
//   "Section/Entry=value"]...
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/case_file.h"
#include "benchmarks/machine_state.h"
#include "benchmarks/solve_in_child.h"
#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/quantity.h"

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr double asked_seconds = 3 * 60;

/// Steps of one kind: pressing down, or moving.
struct Phase {
  int steps = 0;
  double seconds = 0, newton = 0, linear = 0;
  double per_step(double sum) const { return steps > 0 ? sum / steps : 0.0; }
  json to_json() const {
    return {{"steps", steps},
            {"seconds", seconds},
            {"seconds_per_step", per_step(seconds)},
            {"newton_per_step", per_step(newton)},
            {"cg_per_step", per_step(linear)}};
  }
};

struct Path {
  std::string spacing;
  double unknowns = 0, wall_time = 0, peak_memory = 0, way = 0, force_error = 0, energy_error = 0;
  double first_step = 0;  ///< [s]
  Phase loading, motion;
  json to_json() const {
    return {{"spacing", spacing},
            {"unknowns", unknowns},
            {"wall_time", wall_time},
            {"peak_memory", peak_memory},
            {"way", way},
            {"first_step_seconds", first_step},
            {"loading", loading.to_json()},
            {"motion", motion.to_json()},
            {"motion_step_over_loading", motion.per_step(motion.seconds) / loading.seconds},
            {"balance", {{"force", force_error}, {"energy", energy_error}}}};
  }
};

Path read_path(const std::string& spacing, const fs::path& folder, double peak_memory) {
  const json result = json::parse(asperity::read_file(folder / "result.json"));
  const asperity::CsvTable history = asperity::read_csv(folder / "history.csv");
  const auto newton = history.numbers("newton_iterations"), linear = history.numbers("linear_iterations"),
             wall = history.numbers("wall_time [s]");
  const auto shift = history.numbers("shift [m]"), roll = history.numbers("rolling_angle [rad]"),
             spin = history.numbers("torsion_angle [rad]");
  Path path;
  path.spacing = spacing;
  path.unknowns = result.at("mesh").at("dofs");
  path.wall_time = result.at("cost").at("wall_time");
  path.peak_memory = peak_memory;
  path.force_error = result.at("balance").at("force");
  path.energy_error = result.at("balance").at("energy");
  for (std::size_t k = 0; k < wall.size(); ++k) {
    const bool moved = shift[k] != 0 || roll[k] != 0 || spin[k] != 0 || (k > 0 && path.motion.steps > 0);
    Phase& phase = moved ? path.motion : path.loading;
    ++phase.steps;
    // The first step's includes meshing and the far field: what a first solution costs.
    phase.seconds += wall[k] - (k > 0 ? wall[k - 1] : 0.0), phase.newton += newton[k],
        phase.linear += linear[k];
    if (k > 0) path.way += std::abs(shift[k] - shift[k - 1]);
  }
  path.first_step = wall.front();
  return path;
}

void print(const std::vector<Path>& paths) {
  std::printf("\n%9s %10s %9s %9s | loading: %5s %8s %7s | motion: %5s %8s %7s %7s %8s | %9s %8s %9s\n",
              "spacing", "unknowns", "path [nm]", "wall [s]", "steps", "s", "newton", "steps", "s/step",
              "newton", "cg", "of load", "GiB", "B/unkn.", "energy");
  for (const auto& p : paths)
    std::printf(
        "%9s %10.0f %9.0f %9.1f |          %5d %8.1f %7.1f |         %5d %8.2f %7.1f %7.1f %8.3f | %9.2f "
        "%8.0f %9.1e\n",
        p.spacing.c_str(), p.unknowns, 1e9 * p.way, p.wall_time, p.loading.steps, p.loading.seconds,
        p.loading.per_step(p.loading.newton), p.motion.steps, p.motion.per_step(p.motion.seconds),
        p.motion.per_step(p.motion.newton), p.motion.per_step(p.motion.linear),
        p.motion.per_step(p.motion.seconds) / p.loading.seconds, p.peak_memory / (1ull << 30),
        p.peak_memory / p.unknowns, p.energy_error);
  const Path& last = paths.back();
  std::printf("\nat %s: %.1f min (asked of a loop at 10 nm: %.0f min): %s\n", last.spacing.c_str(),
              last.wall_time / 60, asked_seconds / 60, last.wall_time <= asked_seconds ? "met" : "NOT MET");
}

}  // namespace

int main(int argc, char** argv) {
  std::string file = ASPERITY_SOURCE_DIR "/benchmarks/rough_sliding.prm", output = "output/rough_sliding";
  std::vector<std::string> spacings{"20 nm", "10 nm"}, overrides;
  int threads = std::min(2, omp_get_num_procs());
  CLI::App app{"Times a rough yielding contact in motion"};
  app.add_option("CASE.prm", file, "Case file")->capture_default_str();
  app.add_option("--spacing", spacings, "Interface spacings, coarsest first")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--threads", threads, "Threads of each solution")->capture_default_str();
  app.add_option("--output", output, "Folder of the results; rough_sliding.json goes there")
      ->capture_default_str();
  app.add_option("--set", overrides, "\"Section/Entry=value\": replaces an entry of the case file")
      ->expected(1)
      ->take_all();
  CLI11_PARSE(app, argc, argv);
  try {
    fs::create_directories(output);
    std::vector<Path> paths;
    json report{
        {"machine", asperity::machine_state()}, {"case", file}, {"set", overrides}, {"threads", threads}};
    for (const auto& spacing : spacings) {
      auto settings = overrides;
      settings.push_back("Mesh/Interface spacing=" + spacing);
      const fs::path folder =
          fs::path(output) / (std::to_string(std::lround(
                                  asperity::parse_quantity(spacing, asperity::Dimension::length) * 1e12)) +
                              "pm");
      std::printf("spacing %s, %d threads\n", spacing.c_str(), threads);
      const double memory = asperity::solve_in_child(asperity::read_case(file, settings), folder, threads);
      paths.push_back(read_path(spacing, folder, memory));
      report["paths"].push_back(paths.back().to_json());
      asperity::write_file_atomically(fs::path(output) / "rough_sliding.json", report.dump(1) + "\n");
    }
    print(paths);
  } catch (const asperity::InputError& error) {
    std::fprintf(stderr, "rough_sliding: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rough_sliding: %s\n", error.what());
    return 1;
  }
  return 0;
}
