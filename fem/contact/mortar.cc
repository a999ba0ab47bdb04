#include "fem/contact/mortar.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/error.h"

namespace asperity::fem {
namespace {

/// Finds the faces that a rectangle may overlap: a regular grid of bins over all faces.
class FaceBins {
 public:
  FaceBins(const std::vector<PlaneFace>& faces, double width) : width_(width) {
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) for_bins(faces[f], [&](long key) { bins_[key].push_back(f); });
  }
  template <typename Visit>
  void visit(const PlaneFace& face, const Visit& visit) const {
    std::vector<int> seen;
    for_bins(face, [&](long key) {
      const auto bin = bins_.find(key);
      if (bin != bins_.end()) seen.insert(seen.end(), bin->second.begin(), bin->second.end());
    });
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    for (const int f : seen) visit(f);
  }

 private:
  template <typename Action>
  void for_bins(const PlaneFace& f, const Action& action) const {
    const auto bin = [&](double x) { return static_cast<long>(std::floor(x / width_)); };
    for (long j = bin(f.y0); j <= bin(f.y1); ++j)
      for (long i = bin(f.x0); i <= bin(f.x1); ++i) action(j * 4000037L + i);
  }
  double width_;
  std::unordered_map<long, std::vector<int>> bins_;
};

constexpr double gauss = 0.57735026918962576451;

struct Interval {
  double low, high;
  double length() const { return high - low; }
  double point(int q) const { return 0.5 * (low + high) + (q ? 0.5 : -0.5) * gauss * (high - low); }
};

}  // namespace

std::vector<GapRow> couple_interfaces(const std::vector<PlaneFace>& particle, const std::vector<PlaneFace>& substrate) {
  if (particle.empty()) return {};
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300, width = 1e300;
  for (const auto& f : particle) {
    x0 = std::min(x0, f.x0), x1 = std::max(x1, f.x1), y0 = std::min(y0, f.y0), y1 = std::max(y1, f.y1);
    width = std::min(width, f.x1 - f.x0);
  }
  std::vector<PlaneFace> near;
  for (const auto& f : substrate)
    if (f.x1 > x0 && f.x0 < x1 && f.y1 > y0 && f.y0 < y1) near.push_back(f);
  const FaceBins bins(near, 2 * width);

  std::unordered_map<int, int> row_of_node;
  std::vector<GapRow> rows;
  std::vector<std::map<int, std::array<double, 3>>> mortar;  // integrals of psi N, psi dN/dx, psi dN/dy
  for (const auto& s : particle) {
    const double wx = s.x1 - s.x0, wy = s.y1 - s.y0, area = wx * wy;
    int row[4];
    for (int a = 0; a < 4; ++a) {
      const auto [entry, added] = row_of_node.try_emplace(s.node[a], static_cast<int>(rows.size()));
      if (added) {
        rows.emplace_back();
        rows.back().node = s.node[a];
        mortar.emplace_back();
      }
      row[a] = entry->second;
      rows[row[a]].area += 0.25 * area;
    }
    double covered = 0;
    bins.visit(s, [&](int index) {
      const PlaneFace& m = near[index];
      const Interval ix{std::max(s.x0, m.x0), std::min(s.x1, m.x1)}, iy{std::max(s.y0, m.y0), std::min(s.y1, m.y1)};
      if (ix.length() <= 1e-9 * wx || iy.length() <= 1e-9 * wy) return;
      covered += ix.length() * iy.length();
      // Both bases are products of linear functions: two Gauss points per direction are exact.
      double dual_x[2][2], dual_y[2][2], shape_x[2][2], shape_y[2][2];
      for (int q = 0; q < 2; ++q) {
        const double xs = (ix.point(q) - s.x0) / wx, ys = (iy.point(q) - s.y0) / wy;
        dual_x[0][q] = 2 - 3 * xs, dual_x[1][q] = 3 * xs - 1, dual_y[0][q] = 2 - 3 * ys, dual_y[1][q] = 3 * ys - 1;
        const double xm = (ix.point(q) - m.x0) / (m.x1 - m.x0), ym = (iy.point(q) - m.y0) / (m.y1 - m.y0);
        shape_x[0][q] = 1 - xm, shape_x[1][q] = xm, shape_y[0][q] = 1 - ym, shape_y[1][q] = ym;
      }
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
          double in_x = 0, in_y = 0, of_x = 0, of_y = 0;
          for (int q = 0; q < 2; ++q) {
            in_x += 0.5 * ix.length() * dual_x[a & 1][q] * shape_x[b & 1][q];
            in_y += 0.5 * iy.length() * dual_y[a >> 1][q] * shape_y[b >> 1][q];
            of_x += 0.5 * ix.length() * dual_x[a & 1][q];
            of_y += 0.5 * iy.length() * dual_y[a >> 1][q];
          }
          auto& sum = mortar[row[a]][m.node[b]];
          sum[0] += in_x * in_y;
          sum[1] += (b & 1 ? 1 : -1) / (m.x1 - m.x0) * of_x * in_y;
          sum[2] += (b >> 1 ? 1 : -1) / (m.y1 - m.y0) * in_x * of_y;
        }
    });
    if (std::abs(covered - area) > 1e-6 * area)
      throw WorkError("the substrate's mesh does not cover the particle's contact region; enlarge Mesh/Contact region of the substrate");
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    rows[r].entries.emplace_back(rows[r].node, 1.0);
    for (const auto& [node, sum] : mortar[r]) {
      if (std::abs(sum[0]) > 1e-12 * rows[r].area) rows[r].entries.emplace_back(node, -sum[0] / rows[r].area);
      rows[r].slope_entries.push_back({node, {sum[1] / rows[r].area, sum[2] / rows[r].area}});
    }
  }
  return rows;
}

}  // namespace asperity::fem
