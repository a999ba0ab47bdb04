// The paper's own analysis from its published numbers: each number it prints beside what its inputs give,
// with the deviation in sigma, and a remark where the two differ. Fuchs, Weinhart et al. (2014),
// arXiv:1401.2600.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dem_compare/laws/rail_balance.h"
#include "dem_compare/numbers/uncertain.h"
#include "paper/exponential_law.h"
#include "paper/friction_series.h"
#include "paper/published.h"

namespace asperity {

/// How a number is shown; values are kept in SI.
struct DisplayUnit {
  const char* name = "";  ///< "GPa"
  const char* si = "";    ///< "Pa"
  double factor = 1;      ///< SI per display unit
};

/// One printed number beside what its inputs give.
struct PaperNumber {
  std::string what;
  DisplayUnit unit{};
  std::optional<Uncertain> published{}, computed{};
  std::string remark{};
};

/// A number that the paper gives no value of.
inline PaperNumber not_printed(std::string what, const DisplayUnit& unit, const Uncertain& computed,
                               std::string remark = "") {
  return {std::move(what), unit, {}, computed, std::move(remark)};
}
/// What is to be said of something that is no number.
inline PaperNumber remark_alone(std::string what, std::string remark) {
  return {std::move(what), {}, {}, {}, std::move(remark)};
}

/// The numbers of one section of the paper.
struct PaperSection {
  std::string title;  ///< with the place in the paper
  std::vector<PaperNumber> numbers;
};

/// One figure as columns of equal length [SI].
struct PaperCurve {
  std::string name;  ///< of its file: "fig_rolling_2_friction"
  std::string title;
  std::vector<std::string> columns;  ///< with units
  std::vector<std::vector<double>> values;
};

/// All sections, and the curves of the figures.
struct PaperAnalysis {
  std::vector<PaperSection> sections;
  std::vector<PaperCurve> curves;

  /// The number so named in a section whose title contains `section`; throws InputError.
  const PaperNumber& number(const std::string& section, const std::string& what) const;
};

/// Every section, from these inputs. Throws InputError where they lack a body or quantity.
PaperAnalysis analyse_paper(const Published& published);

/// A series of rolling measured as in the paper: mean coefficient and offset over the contacts with silicon
/// and diamond, for both length scales.
PaperSection series_section(const Published& published, const std::vector<FrictionPoint>& series);

/// The laws in roughness: as printed, and refitted to Table 2.
struct RoughnessLaws {
  ExponentialLaw printed_rolling, printed_offset;  ///< mu_ro lambda/r; h_ro [N] against RMS [m]
  ExponentialFit rolling, offset;
};
RoughnessLaws roughness_laws(const Published& published);

/// One file each.
PaperSection table_1(const Published& published);
PaperSection table_2(const Published& published);
PaperSection elasticity_section(const Published& published);
PaperSection sliding_section(const Published& published);
PaperSection rolling_section(const Published& published);
PaperSection rail_section(const Published& published);
PaperSection torsion_section(const Published& published);
PaperSection magnitudes_section(const Published& published);
/// Slips that change no number here.
PaperSection equations_section();
std::vector<PaperCurve> paper_curves(const Published& published);

namespace display {
inline constexpr DisplayUnit none{}, GPa{"GPa", "Pa", 1e9}, um{"um", "m", 1e-6}, nm{"nm", "m", 1e-9},
    uN{"uN", "N", 1e-6}, mN{"mN", "N", 1e-3}, N_per_m{"N/m", "N/m", 1}, kN_per_m{"kN/m", "N/m", 1e3},
    Nm_per_rad{"N m/rad", "N m/rad", 1}, percent{"%", "", 0.01}, degree{"deg", "rad", 0.017453292519943295};
}

/// "45 deg" of an angle in rad.
/// angle [rad].
std::string whole_degrees(double angle);

}  // namespace asperity
