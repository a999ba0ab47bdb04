// Real contact area with an edge that runs between the nodes.
//
// Counting the patches of all nodes that carry pressure is biased by about a third of a spacing outwards. Near the edge of
// an elastic contact the pressure falls as p = A sqrt(d) inside and the gap grows as g = 4 A / (3 E*) d^(3/2) outside (the
// edge of Hertz' contact, Johnson 1985 eqs. 4.44 and 4.6; d: distance to the edge), so a closed and an open neighbour
// tell where between them the edge runs.
#pragma once

#include <array>
#include <vector>

namespace asperity::fem {

/// Where the edge runs between a closed node of pressure p [Pa] and an open one of gap g [m] at a distance h [m]: its
/// distance from the closed node over h, 0 to 1. modulus: E* of the pair [Pa].
double edge_fraction(double pressure, double gap, double distance, double modulus);

/// Area [m^2] inside of the edge. quads: rows at the corners of each interface face, lexicographic; points: (x, y) of each
/// row [m]; a row is closed where its pressure is positive.
double contact_area(const std::vector<std::array<int, 4>>& quads, const std::vector<std::array<double, 2>>& points,
                    const std::vector<double>& pressure, const std::vector<double>& gap, double modulus);

}  // namespace asperity::fem
