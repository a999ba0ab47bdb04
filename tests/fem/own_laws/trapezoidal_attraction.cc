// A law of adhesion from outside of the program: constant over a share of its range, then falling evenly.
// Tvergaard & Hutchinson (1992).
#include "fem/interface/adhesion_law.h"

namespace asperity::fem {
namespace {

class TrapezoidalAttraction : public AdhesionLaw {
 public:
  TrapezoidalAttraction(double work, const LawValues& values)
      : work_(work), range_(values.at("Adhesion range")), plateau_(values.at("Adhesion plateau") * range_) {}

  Attraction at(double gap) const override {
    const double full = 2 * work_ / (range_ + plateau_);
    if (gap >= range_) return {0, 0, 0};
    if (gap <= plateau_) return {full, 0, work_ - full * gap};
    const double slope = -full / (range_ - plateau_), stress = -slope * (range_ - gap);
    return {stress, slope, 0.5 * stress * (range_ - gap)};
  }
  double range() const override { return range_; }

 private:
  double work_, range_, plateau_;
};

ParameterEntry plateau() {
  ParameterEntry parameter{"Adhesion plateau", {"c"}};
  parameter.documentation = "Share of the range over which trapezoidal attraction is constant.";
  parameter.default_text = "0.5", parameter.range = {0, 1, false, true}, parameter.optional = true;
  return parameter;
}

const Registered<AdhesionLawDeclaration> trapezoidal_law{
    {{"trapezoidal",
      "s(g) = s_0 min(1, (h - g)/(h - c h)), s_0 = 2 w/(h + c h)",
      "Tvergaard & Hutchinson (1992)",
      "surfaces of unlike roughness",
      {adhesion_range("h"), plateau()}},
     "constant to c h and evenly to 0 at h",
     [](double work, const LawValues& values) -> std::unique_ptr<AdhesionLaw> {
       return std::make_unique<TrapezoidalAttraction>(work, values);
     }}};

}  // namespace
}  // namespace asperity::fem
