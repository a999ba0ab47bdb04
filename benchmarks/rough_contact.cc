// Rough normal contact of two yielding bodies, loaded and unloaded in twenty steps, at a growing number of
// unknowns: wall time, iterations and memory, and how the iterations grow. Each size is solved in a process
// of its own, as `asperity solve` would, so that its peak memory is its own.
//
//   rough_contact [--spacing "20 nm,10 nm,5 nm"] [--threads 2] [--output DIR] [--set
//   "Section/Entry=value"]...
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>
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

// What is asked of the largest size, and of the growth from the smallest to the largest.
constexpr double asked_seconds = 90, asked_bytes = 0.6 * (1ull << 30), asked_growth = 1.3;

struct Size {
  std::string spacing;
  double unknowns = 0, contact_nodes = 0, steps = 0;
  double wall_time = 0;           ///< meshing, far-field solution, all steps and their files [s]
  double peak_memory = 0;         ///< largest resident set of the process [B]
  double newton = 0, linear = 0;  ///< iterations, all steps
  double most_newton = 0;         ///< in one step
  double area = 0, approach = 0, plastic_volume = 0;  ///< at the largest load, at the end
  double force_error = 0, energy_error = 0;

  double newton_per_step() const { return newton / steps; }
  double linear_per_newton() const { return linear / newton; }
  json to_json() const {
    return {{"spacing", spacing},
            {"unknowns", unknowns},
            {"contact_nodes", contact_nodes},
            {"steps", steps},
            {"wall_time", wall_time},
            {"time_per_step", wall_time / steps},
            {"newton_per_step", newton_per_step()},
            {"most_newton_in_a_step", most_newton},
            {"cg_per_step", linear / steps},
            {"cg_per_newton", linear_per_newton()},
            {"peak_memory", peak_memory},
            {"bytes_per_unknown", peak_memory / unknowns},
            {"contact_area_at_largest_load", area},
            {"approach_at_largest_load", approach},
            {"plastic_volume", plastic_volume},
            {"balance", {{"force", force_error}, {"energy", energy_error}}}};
  }
};

Size read_size(const std::string& spacing, const fs::path& folder, double peak_memory) {
  const json result = json::parse(asperity::read_file(folder / "result.json"));
  const asperity::CsvTable history = asperity::read_csv(folder / "history.csv");
  const auto newton = history.numbers("newton_iterations"), linear = history.numbers("linear_iterations");
  const auto force = history.numbers("normal_force [N]");
  const auto peak = static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
  Size size;
  size.spacing = spacing;
  size.unknowns = result.at("mesh").at("dofs");
  size.contact_nodes = result.at("mesh").at("contact_nodes");
  size.steps = static_cast<double>(force.size());
  size.wall_time = result.at("cost").at("wall_time");
  size.peak_memory = peak_memory;
  size.newton = std::accumulate(newton.begin(), newton.end(), 0.0);
  size.linear = std::accumulate(linear.begin(), linear.end(), 0.0);
  size.most_newton = *std::max_element(newton.begin(), newton.end());
  size.area = history.numbers("contact_area [m^2]")[peak];
  size.approach = history.numbers("normal_displacement [m]")[peak];
  size.plastic_volume = history.numbers("plastic_volume [m^3]").back();
  size.force_error = result.at("balance").at("force");
  size.energy_error = result.at("balance").at("energy");
  return size;
}

void print(const std::vector<Size>& sizes) {
  std::printf("\n%9s %10s %6s %9s %9s %7s %5s %9s %9s %9s %11s %9s\n", "spacing", "unknowns", "steps",
              "wall [s]", "s/step", "newton", "most", "cg/step", "cg/newton", "GiB", "B/unknown", "area um2");
  for (const auto& s : sizes)
    std::printf("%9s %10.0f %6.0f %9.1f %9.2f %7.2f %5.0f %9.1f %9.2f %9.2f %11.0f %9.5f\n",
                s.spacing.c_str(), s.unknowns, s.steps, s.wall_time, s.wall_time / s.steps,
                s.newton_per_step(), s.most_newton, s.linear / s.steps, s.linear_per_newton(),
                s.peak_memory / (1ull << 30), s.peak_memory / s.unknowns, s.area * 1e12);
}

const char* verdict(bool met) { return met ? "met" : "NOT MET"; }

json judge(const std::vector<Size>& sizes) {
  const Size &first = sizes.front(), &last = sizes.back();
  const double newton = last.newton_per_step() / first.newton_per_step();
  const double linear = last.linear_per_newton() / first.linear_per_newton();
  const double both = (last.linear / last.steps) / (first.linear / first.steps);
  std::printf("\nfrom %.3g to %.3g unknowns (asked: at most %.1f)\n", first.unknowns, last.unknowns,
              asked_growth);
  std::printf("  Newton iterations a step grow by %.2f: %s\n", newton, verdict(newton <= asked_growth));
  std::printf("  CG iterations a Newton step grow by %.2f: %s\n", linear, verdict(linear <= asked_growth));
  std::printf("  CG iterations a step grow by %.2f: %s\n", both, verdict(both <= asked_growth));
  std::printf("at %.3g unknowns\n", last.unknowns);
  std::printf("  %.0f s (asked: %.0f s): %s\n", last.wall_time, asked_seconds,
              verdict(last.wall_time <= asked_seconds));
  std::printf("  %.2f GiB (asked: %.1f GiB): %s\n", last.peak_memory / (1ull << 30),
              asked_bytes / (1ull << 30), verdict(last.peak_memory <= asked_bytes));
  return {
      {"newton_per_step", newton}, {"cg_per_newton", linear}, {"cg_per_step", both}, {"asked", asked_growth}};
}

}  // namespace

int main(int argc, char** argv) {
  std::string file = ASPERITY_SOURCE_DIR "/benchmarks/rough_contact.prm", output = "output/rough_contact";
  std::vector<std::string> spacings{"20 nm", "10 nm", "5 nm"}, overrides;
  int threads = std::min(2, omp_get_num_procs());
  CLI::App app{"Times rough normal contact of two yielding bodies at a growing number of unknowns"};
  app.add_option("CASE.prm", file, "Case file")->capture_default_str();
  app.add_option("--spacing", spacings, "Interface spacings, coarsest first")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--threads", threads, "Threads of each solution")->capture_default_str();
  app.add_option("--output", output, "Folder of the results; rough_contact.json goes there")
      ->capture_default_str();
  app.add_option("--set", overrides, "\"Section/Entry=value\": replaces an entry of the case file")
      ->expected(1)
      ->take_all();
  CLI11_PARSE(app, argc, argv);
  try {
    fs::create_directories(output);
    std::vector<Size> sizes;
    json report{
        {"machine", asperity::machine_state()}, {"case", file}, {"set", overrides}, {"threads", threads}};
    for (const auto& spacing : spacings) {
      auto settings = overrides;
      settings.push_back("Mesh/Interface spacing=" + spacing);
      const asperity::CaseInput input = asperity::read_case(file, settings);
      const double metres = asperity::parse_quantity(spacing, asperity::Dimension::length);
      const fs::path folder = fs::path(output) / (std::to_string(std::lround(metres * 1e12)) + "pm");
      std::printf("spacing %s, %d threads\n", spacing.c_str(), threads);
      const double load_before = asperity::machine_state()["load"][0];
      const double memory = asperity::solve_in_child(input, folder, threads);
      sizes.push_back(read_size(spacing, folder, memory));
      json entry = sizes.back().to_json();
      entry["machine_load_before"] = load_before;
      entry["machine_load_after"] = asperity::machine_state()["load"][0];
      report["sizes"].push_back(entry);
      asperity::write_file_atomically(fs::path(output) / "rough_contact.json", report.dump(1) + "\n");
    }
    print(sizes);
    if (sizes.size() > 1) report["growth"] = judge(sizes);
    asperity::write_file_atomically(fs::path(output) / "rough_contact.json", report.dump(1) + "\n");
  } catch (const asperity::InputError& error) {
    std::fprintf(stderr, "rough_contact: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rough_contact: %s\n", error.what());
    return 1;
  }
  return 0;
}
