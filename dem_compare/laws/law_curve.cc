#include "dem_compare/laws/law_curve.h"

#include "core/error.h"

namespace asperity {
namespace {

using Eigen::Vector3d;

/// Leads a law of each mode; rows of its curve.
class Leader {
 public:
  explicit Leader(const LawCurveOptions& options) : o_(options) {}

  LawCurve operator()(const NormalLaw& law) const {
    NormalState state;
    return rows({"approach [m]", "force [N]", "contact_radius [m]", "stiffness [N/m]"},
                [&](double approach, double) {
                  state = law->advance(state, approach);
                  return std::vector<double>{state.force, state.contact_radius, state.stiffness};
                });
  }
  LawCurve operator()(const SlidingLaw& law) const {
    SlidingHistory history = law->advance({}, o_.normal, Vector3d::Zero());
    return rows({"shift [m]", "lateral_force [N]"}, [&](double, double step) {
      history = law->advance(history, o_.normal, step * Vector3d::UnitX());
      return std::vector<double>{history.spring.resistance.x()};
    });
  }
  LawCurve operator()(const RollingLaw& law) const {
    RollingHistory history;
    return rows({"rotation [rad]", "rolling_moment [N m]"}, [&](double, double step) {
      history = law->advance(history, o_.normal, o_.lever, step * Vector3d::UnitX());
      return std::vector<double>{history.resistance.x()};
    });
  }
  LawCurve operator()(const TorsionLaw& law) const {
    TorsionHistory history;
    return rows({"rotation [rad]", "torsion_moment [N m]"}, [&](double, double step) {
      history = law->advance(history, o_.normal, o_.lever, step);
      return std::vector<double>{history.resistance};
    });
  }
  LawCurve operator()(const ViscousLaw& law) const {
    const double factor = law->factor(o_.mass, o_.normal.stiffness);
    return rows({"velocity [m/s]", "force [N]"},
                [&](double velocity, double) { return std::vector<double>{factor * velocity}; });
  }
  LawCurve operator()(const SteadySlipLaw& law) const {
    return rows({law->ratio(), "lateral_force [N]", "torsion_moment [N m]"}, [&](double ratio, double) {
      const SlipResistance resistance = law->at(o_.normal, ratio);
      return std::vector<double>{resistance.force, resistance.moment};
    });
  }

 private:
  /// `row(drive, step since the last row)` gives the columns behind the drive.
  template <class Row>
  LawCurve rows(std::vector<std::string> names, const Row& row) const {
    LawCurve curve{std::move(names), {}};
    curve.columns.resize(curve.names.size());
    double last = 0;
    for (int i = 0; i <= o_.points; ++i) {
      const double drive = o_.reach * i / o_.points;
      const std::vector<double> values = row(drive, drive - last);
      curve.columns[0].push_back(drive);
      for (std::size_t k = 0; k < values.size(); ++k) curve.columns[k + 1].push_back(values[k]);
      last = drive;
    }
    return curve;
  }

  const LawCurveOptions& o_;
};

}  // namespace

LawCurve curve_of(const ReducedLaw& law, const LawCurveOptions& options) {
  if (!(options.reach > 0))
    throw InputError("a curve that reaches no further than zero has no points; give it a reach such as 1e-6");
  if (options.points < 1)
    throw InputError("a curve has one point or more behind the first; give more points");
  return std::visit(Leader(options), law);
}

}  // namespace asperity
