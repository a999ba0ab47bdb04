// Elastic, frictionless contact of half-spaces by boundary elements: a formulation of its own, against which
// finite elements are held. Uniform pressure on square cells (Love 1929, Phil. Trans. R. Soc. A 228, 377),
// convolved by Fourier transforms on a grid of twice the size so that nothing repeats (Liu, Wang & Liu 2000,
// Wear 243, 101); conjugate gradients under the constraint of no tension and the given load (Polonsky & Keer
// 1999, Wear 231, 206).
#pragma once

#include <functional>
#include <vector>

namespace asperity::test {

struct HalfSpaceContact {
  double approach = 0;          ///< of the planes from which gaps are counted [m]
  double area = 0;              ///< [m^2], its edge corrected, see half_space_contact
  double largest_pressure = 0;  ///< [Pa], of a cell's mean
  double first_touch =
      0;  ///< approach at which the undeformed surfaces touch, negative where asperities meet first [m]
  double centre_x = 0, centre_y = 0;  ///< of the pressure [m]
  int iterations = 0;
};

/// gap: of the undeformed surfaces at (x, y) [m]; a square of half width `half_width` [m] about the origin in
/// n x n cells; modulus: E* [Pa]; force [N]. Counting cells puts the area too high by (pi - 1 + ln 2) / 24
/// times the length of the sides between closed and open cells times the spacing (Yastrebov, Anciaux &
/// Molinari 2017, Tribol. Int. 114, 161), which is taken off.
HalfSpaceContact half_space_contact(const std::function<double(double, double)>& gap, double half_width,
                                    int n, double modulus, double force);

/// Force over approach of the same contact at `force`, by central differences over 2 % of it [N/m].
double half_space_stiffness(const std::function<double(double, double)>& gap, double half_width, int n,
                            double modulus, double force);

}  // namespace asperity::test
