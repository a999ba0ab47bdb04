// What the pictures of one solved case have in common: its field files, and Hertz' contact at its largest
// load.
#pragma once

#include <string>
#include <vector>

#include "report/fields/field_files.h"
#include "report/fields/map_figure.h"
#include "results/solved_case.h"

namespace asperity::report {

/// Share of values beyond the ends of a colour bar, so that single points do not decide it.
constexpr double outliers = 0.002;

/// Of all steps [N].
double largest_force(const SolvedCase& solved);
/// Of smooth, elastic bodies at the largest load [m].
double hertz_radius(const SolvedCase& solved);

/// The field files at the largest load of the history (else the last); empty if none were written.
StepFiles files_at_largest_load(const SolvedCase& solved, const std::string& pvd);

/// Fields with one component that files of their own have added at a place, "contact" or "bodies".
std::vector<Addition> added_scalars(const SolvedCase& solved, const std::string& place);

/// A note in place of a picture.
std::string no_fields(const SolvedCase& solved);

/// A figure over two lengths in nm; the window is given in m.
/// Ends of the window [m].
MapFigure figure_in_nm(double x_low, double x_high, double y_low, double y_high,
                       const std::string& upright_name);

}  // namespace asperity::report
