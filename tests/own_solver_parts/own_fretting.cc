// An experiment of the solver of somebody's own, all of it: the particle is rubbed to and fro about where it
// was pressed.
#include "core/experiment_declaration.h"

namespace asperity {
namespace {

std::string fretting(const ExperimentInput&, const LawValues& values) {
  const double amplitude = values.at("Fretting amplitude");
  const auto slide = [&](double distance) {
    return "slide " + format_quantity(distance, Dimension::length, 12) + " in 4 steps";
  };
  std::string program = slide(amplitude);
  for (int cycle = 0; cycle < values.at("Fretting cycles"); ++cycle)
    program += "; " + slide(-2 * amplitude) + "; " + slide(2 * amplitude);
  return program;
}

ParameterEntry amplitude() {
  ParameterEntry entry{
      "Fretting amplitude", {"A"}, Dimension::length, "How far it goes to either side.", "0 m"};
  entry.if_missing = "give a length, e.g. 10 nm";
  return entry;
}

const RegisteredExperimentDeclaration entry{[] {
  ParameterEntry cycles{"Fretting cycles", {"N"}, Dimension::none, "Times that it comes back.", "1"};
  cycles.optional = true;
  return ExperimentDeclaration{{"fretting",
                                "slide A; N times: slide -2 A, slide 2 A",
                                "Mindlin & Deresiewicz (1953)",
                                "small amplitudes",
                                {amplitude(), cycles}},
                               fretting};
}};

}  // namespace
}  // namespace asperity
