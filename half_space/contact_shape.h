// What a map of pressures says of a contact: area, edge, spots, centre.
#pragma once

#include "half_space/grid.h"

namespace asperity::half_space {

struct ContactShape {
  double area_of_cells = 0;  ///< of the cells that press [m^2]
  /// The same less (pi - 1 + ln 2) / 24 of the perimeter times the spacing, by which cells count too much on
  /// a straight edge of any direction, where the pressure falls to none (not at the hardness: there the
  /// centres of cells decide) (Yastrebov, Anciaux & Molinari 2017, Tribol. Int. 114, 161) [m^2]
  double area = 0;
  double perimeter = 0;               ///< sum of the sides between cells that press and cells that do not [m]
  double mean_pressure = 0;           ///< force over area [Pa]
  double largest_pressure = 0;        ///< of a cell's mean [Pa]
  double area_at_bound = 0;           ///< of the cells at the hardness [m^2]
  double force = 0;                   ///< [N]
  double centre_x = 0, centre_y = 0;  ///< of the pressure [m]
  int spots = 0;                      ///< cells that press and are joined by sides
  double reach = 0;           ///< half width of the square about the origin that holds all that presses [m]
  bool reaches_edge = false;  ///< the outermost cells press: the grid is too small
};

/// hardness: largest pressure [Pa], infinite without one.
ContactShape contact_shape(const Grid& grid, const Field& pressure, double hardness);

}  // namespace asperity::half_space
