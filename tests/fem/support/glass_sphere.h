// A smooth sphere of glass on its like, as a case file: elastic but for what `particle` says.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/case_file.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/support/verification.h"

namespace asperity::test {

/// Its numbers, in SI units.
struct GlassSphere {
  static constexpr double radius = 8.5e-6, youngs = 71e9, poisson = 0.17;
  static constexpr double reduced_modulus = youngs / (2 * (1 - poisson * poisson));
  /// Sum of (2 - nu)/G of both bodies [1/Pa].
  static constexpr double lateral_compliance = 2 * (2 - poisson) * 2 * (1 + poisson) / youngs;
};

/// Of these entries, each text holding lines of `set`.
inline CaseInput glass_case(const std::filesystem::path& folder, const std::string& interface,
                            const std::string& experiment, const std::string& mesh,
                            const std::string& particle = "") {
  const std::string glass = "set Young modulus = 71 GPa\n set Poisson ratio = 0.17\nend\n";
  const std::filesystem::path file = folder / "case.prm";
  std::ofstream(file) << "subsection Particle\n set Radius = 8.5 um\n"
                      << particle << glass << "subsection Substrate\n"
                      << glass << "subsection Interface\n"
                      << interface << "end\nsubsection Experiment\n"
                      << experiment << "end\nsubsection Mesh\n"
                      << mesh << "end\nsubsection Output\n set Fields = false\nend\n";
  return read_case(file);
}

/// Whether work done on the bodies is stored or dissipated, within `asked` of the largest work.
inline testing::AssertionResult leaves_no_energy_open(const std::string& topic, const std::string& what,
                                                      const SolvedExperiment& s, double asked = 0.01) {
  return Verified{topic, what + ": energy left open", "balance"}.below(
      100 * s.result["balance"]["energy"].get<double>(), 100 * asked, "%");
}

}  // namespace asperity::test
