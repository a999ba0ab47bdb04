// Real contact area, its edge and its spots, from the active set of contact nodes.
//
// The pressure of a node is that of its hat function, which reaches a spacing beyond it: active nodes extend
// somewhat beyond the edge and carry a small pressure. Two estimates of the area both come out too large by a
// part of perimeter times spacing:
// - patches of the active contact nodes: by 0.32 +- 0.08 against Hertz (a/h 6 to 11), 0.33,
//   0.365 +- 0.026, 0.44 +- 0.05 in rough elastic contacts with eight, four and two spacings in the shortest
//   wave (3, 20 and 18 contacts, solved by boundary elements, too);
// - within an edge that runs between active and open nodes. Near it the pressure of an elastic contact
//   falls as p = A sqrt(d) inside and the gap grows as g = 4 A / (3 E*) d^(3/2) outside (Johnson 1985
//   eqs. 4.44 and 4.6; d: distance to the edge). This takes the pressures of nodes for those of points: by
//   0.11 +- 0.03 against Hertz, 0.14, 0.125
//   +- 0.045, 0.16 +- 0.08 in the rough contacts.
// Their mean less the outset times the perimeter scatters least: 0.05, 0.026 and 0.06 of perimeter times
// spacing.
#pragma once

#include <array>
#include <vector>

namespace asperity::fem {

/// Where the edge runs between an active node of pressure p [Pa] and an open one of gap g [m] at a distance h
/// [m]: its distance from the active node over h, 0 to 1. modulus: E* of the pair [Pa].
double edge_fraction(double pressure, double gap, double distance, double modulus);

/// By which the mean of both estimates reaches beyond the edge of the contact, in spacings.
constexpr double outset = 0.24;

/// What the edge encloses.
struct ContactShape {
  double area = 0;       ///< [m^2]
  double perimeter = 0;  ///< length of the edge [m]
  int spots = 0;  ///< contacts apart from each other: clusters of active nodes that no sides of faces join
};

/// quads: rows at the corners of each interface face, lexicographic; points: (x, y) of each row [m]; a row is
/// closed where its pressure is positive.
ContactShape contact_shape(const std::vector<std::array<int, 4>>& quads,
                           const std::vector<std::array<double, 2>>& points,
                           const std::vector<double>& pressure, const std::vector<double>& gap,
                           double modulus);

}  // namespace asperity::fem
