#include "report/motion/motion_figures.h"

#include <algorithm>
#include <cmath>

#include "core/shear_moduli.h"
#include "dem_compare/laws/lubkin_torsion.h"
#include "report/page/axis.h"
#include "report/page/display_units.h"
#include "report/page/page.h"

namespace asperity::report {
namespace {

const std::string computed_colour = "#0072b2", other_colour = "#d55e00", load_colour = "#999999",
                  law_colour = "#555555";

/// Follows a law of first loading there and, by Masing's rule, back from the largest displacement: one series
/// of both paths.
template <class Law>
Series law_series(const std::string& label, const std::vector<double>& path, double unit_x, double unit_y,
                  const Law& first_loading) {
  Series series{label, law_colour, Series::Style::dashed, {}, {}, {}};
  const double farthest = *std::max_element(path.begin(), path.end());
  constexpr int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double x = farthest * i / points;
    series.x.push_back(x / unit_x), series.y.push_back(first_loading(x) / unit_y);
  }
  if (path.back() > 0.99 * farthest) return series;
  const double top = first_loading(farthest);
  for (int i = 0; i <= points; ++i) {
    const double x = farthest - (farthest - std::max(0.0, path.back())) * i / points;
    series.x.push_back(x / unit_x),
        series.y.push_back((top - 2 * first_loading((farthest - x) / 2)) / unit_y);
  }
  return series;
}

double friction_coefficient(const SolvedCase& solved) {
  return solved.entries.quantity("Interface/Friction coefficient", Dimension::none, 0);
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

Chart chart_of(const std::vector<double>& x, const std::vector<double>& y, double unit_x, double unit_y) {
  Chart chart;
  chart.y_from_zero = false;
  Series computed{"computed", computed_colour, Series::Style::line_with_points, {}, {}, {}};
  for (std::size_t i = 0; i < x.size(); ++i)
    computed.x.push_back(x[i] / unit_x), computed.y.push_back(y[i] / unit_y);
  chart.series.push_back(std::move(computed));
  return chart;
}

std::string paragraph_of_program(const SolvedCase& solved) {
  const std::string type = solved.entries.text("Experiment/Type", "program");
  return "<p>The program" + (type == "program" ? "" : " of " + escaped(type)) + ": " +
         escaped(solved.entries.text("Experiment/Program")) + "</p>\n";
}

void add_over_steps(const std::string& label, const std::string& colour, const std::vector<double>& y,
                    double unit, Chart& chart) {
  Series series{label, colour, Series::Style::line_with_points, {}, {}, {}};
  for (std::size_t i = 0; i < y.size(); ++i)
    series.x.push_back(static_cast<double>(i + 1)), series.y.push_back(y[i] / unit);
  chart.series.push_back(std::move(series));
}

Chart chart_over_steps(const std::string& y_label) {
  Chart chart;
  chart.y_from_zero = false;
  chart.x_label = "step";
  chart.y_label = y_label;
  return chart;
}

}  // namespace

Chart friction_loop_chart(const SolvedCase& solved) {
  const auto& h = solved.history;
  Chart chart = chart_of(h.lateral_displacement, h.lateral_force, nm, uN);
  chart.x_label = "lateral displacement of the bodies [nm]";
  chart.y_label = "lateral force [µN]";
  const double load = largest(h.normal_force), mu = friction_coefficient(solved);
  if (mu > 0) {
    const double limit = mu * load,
                 full_slip = 3 * limit /
                             (16 * reduced_shear_modulus(solved.particle(), solved.substrate()) *
                              solved.hertz().contact_radius(load));
    chart.series.push_back(
        law_series("Mindlin: smooth, elastic", h.lateral_displacement, nm, uN,
                   [&](double x) { return limit * (1 - std::pow(1 - std::min(1.0, x / full_slip), 1.5)); }));
  }
  return chart;
}

Chart torsion_chart(const SolvedCase& solved) {
  const auto& h = solved.history;
  Chart chart = chart_of(h.torsion_angle, h.torsion_moment, mrad, pN_m);
  chart.x_label = "angle [mrad]";
  chart.y_label = "torsion moment [pN m]";
  const double load = largest(h.normal_force), mu = friction_coefficient(solved);
  if (mu > 0) {
    const LubkinTorsion law{torsion_modulus(solved.particle(), solved.substrate()), mu, load,
                            solved.hertz().contact_radius(load)};
    chart.series.push_back(law_series("Lubkin: smooth, elastic", h.torsion_angle, mrad, pN_m,
                                      [&](double x) { return x > 0 ? law.moment(x) : 0.0; }));
  }
  return chart;
}

Chart rolling_chart(const SolvedCase& solved) {
  const auto& h = solved.history;
  Chart chart = chart_of(h.rolling_angle, h.rolling_moment, mrad, pN_m);
  chart.x_label = "angle [mrad]";
  chart.y_label = "rolling moment [pN m]";
  return chart;
}

Chart program_forces_chart(const SolvedCase& solved) {
  Chart chart = chart_over_steps("force [µN]");
  add_over_steps("normal", load_colour, solved.history.normal_force, uN, chart);
  add_over_steps("lateral, along", computed_colour, solved.history.lateral_force, uN, chart);
  if (!solved.history.lateral_force_across.empty())
    add_over_steps("lateral, across", other_colour, solved.history.lateral_force_across, uN, chart);
  return chart;
}

Chart program_moments_chart(const SolvedCase& solved) {
  Chart chart = chart_over_steps("moment [pN m]");
  add_over_steps("rolling", computed_colour, solved.history.rolling_moment, pN_m, chart);
  add_over_steps("torsion", other_colour, solved.history.torsion_moment, pN_m, chart);
  return chart;
}

std::string motion_figure(const SolvedCase& solved) {
  if (solved.motion() == Motion::program)
    return section_html("Program of motions",
                        paragraph_of_program(solved) +
                            figure_html("Forces", to_svg(program_forces_chart(solved)),
                                        "The forces that press and move the particle, step by step; how far "
                                        "it has moved stands in history.csv. Where the whole "
                                        "contact slips, the lateral force points along the path and is the "
                                        "friction that the load allows.") +
                            figure_html("Moments", to_svg(program_moments_chart(solved)),
                                        "Rolling: about the contact; torsion: about the normal. A moment "
                                        "stays when its motion has ended, until another "
                                        "motion makes the contact slip."));
  const std::string back =
      " After the reversal everything sticks first and slip begins anew over twice the path (Masing's rule).";
  if (largest(solved.history.lateral_displacement) > 0 && solved.entries.text("Experiment/Type") == "sliding")
    return section_html(
        "Sliding",
        figure_html(
            "Lateral force along the path", to_svg(friction_loop_chart(solved)),
            "The force that slides the particle at its largest load. It rises as steeply as sticking elastic "
            "bodies resist, "
            "bends where slip grows inwards from the rim, and stays level once the whole contact slips." +
                back +
                " The dashed curve is Mindlin's for the same bodies, smooth and elastic, with the local "
                "friction that went in."));
  if (largest(solved.history.rolling_angle) > 0)
    return section_html("Rolling",
                        figure_html("Moment about the contact along the path", to_svg(rolling_chart(solved)),
                                    "The moment that rolls the particle at its largest load, free of lateral "
                                    "force. The conservative topographic part of "
                                    "rough surfaces averages out along the path, and has the other sign on "
                                    "the return distance. What is dissipated is the area between both; "
                                    "effective.rolling_dissipation in result.json gives it per angle."));
  if (largest(solved.history.torsion_angle) > 0)
    return section_html("Torsion",
                        figure_html("Moment along the path", to_svg(torsion_chart(solved)),
                                    "The moment that spins the particle about the normal at its largest "
                                    "load; it levels off where the whole contact "
                                    "slips." +
                                        back +
                                        " The dashed curve is Lubkin's for the same bodies, smooth and "
                                        "elastic, with the local friction that went in."));
  return "";
}

}  // namespace asperity::report
