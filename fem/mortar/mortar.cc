#include "fem/mortar/mortar.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/error.h"
#include "core/threads.h"
#include "fem/mortar/overlap.h"

namespace asperity::fem {
namespace {

/// Finds the faces that a rectangle may overlap: a regular grid of bins over all faces.
class FaceBins {
 public:
  FaceBins(const std::vector<PlaneFace>& faces, double width) : width_(width) {
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      for_bins(faces[f], [&](long key) { bins_[key].push_back(f); });
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

/// Coefficients A of the dual functions psi = A N of a face, and the integrals D of N.
std::pair<Eigen::Matrix4d, Eigen::Vector4d> dual_basis(const std::vector<OverlapPoint>& points) {
  Eigen::Matrix4d mass = Eigen::Matrix4d::Zero();
  Eigen::Vector4d integral = Eigen::Vector4d::Zero();
  for (const auto& p : points) {
    const Eigen::Map<const Eigen::Vector4d> n(p.own.data());
    mass += p.weight * n * n.transpose();
    integral += p.weight * n;
  }
  return {integral.asDiagonal() * mass.inverse(), integral};
}

double area_of(const PlaneQuad& q) {
  return triangle_area(q.corner[0], q.corner[1], q.corner[3]) +
         triangle_area(q.corner[0], q.corner[3], q.corner[2]);
}

PlaneFace box_of(const PlaneQuad& quad) {
  PlaneFace box{1e300, -1e300, 1e300, -1e300, quad.node};
  for (const auto& p : quad.corner) {
    box.x0 = std::min(box.x0, p[0]), box.x1 = std::max(box.x1, p[0]);
    box.y0 = std::min(box.y0, p[1]), box.y1 = std::max(box.y1, p[1]);
  }
  return box;
}

/// Faces of the substrate that can lie opposite a face of the particle.
std::vector<PlaneFace> near_faces(const std::vector<PlaneQuad>& particle,
                                  const std::vector<PlaneFace>& substrate) {
  PlaneFace all = box_of(particle[0]);
  for (const auto& q : particle) {
    const PlaneFace box = box_of(q);
    all.x0 = std::min(all.x0, box.x0), all.x1 = std::max(all.x1, box.x1);
    all.y0 = std::min(all.y0, box.y0), all.y1 = std::max(all.y1, box.y1);
  }
  std::vector<PlaneFace> near;
  for (const auto& f : substrate)
    if (f.x1 > all.x0 && f.x0 < all.x1 && f.y1 > all.y0 && f.y0 < all.y1) near.push_back(f);
  return near;
}

double least_width(const std::vector<PlaneQuad>& faces) {
  double width = 1e300;
  for (const auto& q : faces) {
    const PlaneFace box = box_of(q);
    width = std::min(width, box.x1 - box.x0);
  }
  return width;
}

/// The points of a face's overlaps with the substrate's. Throws WorkError where these leave a part uncovered.
void find_overlaps(const PlaneQuad& quad, const std::vector<PlaneFace>& substrate, const FaceBins& bins,
                   std::vector<OverlapPoint>& points) {
  points.clear();
  const BilinearMap map(quad);
  bins.visit(box_of(quad), [&](int index) { add_overlap(quad, map, substrate[index], index, points); });
  double covered = 0;
  for (const auto& p : points) covered += p.weight;
  const double area = area_of(quad);
  if (std::abs(covered - area) > 1e-6 * area)
    throw WorkError(
        "the substrate's mesh does not cover the particle's contact region; enlarge Mesh/Contact region of "
        "the substrate");
}

/// Gathers the rows of all nodes of the particle's side, face by face.
class MortarRows {
 public:
  explicit MortarRows(const std::vector<PlaneFace>& substrate) : substrate_(substrate) {}

  /// Adds a face of the particle with the points of its overlaps, those of a face of the substrate together.
  void add_face(const PlaneQuad& quad, const std::vector<OverlapPoint>& points) {
    const auto [dual, integral] = dual_basis(points);
    std::array<int, 4> row;
    for (int a = 0; a < 4; ++a) {
      row[a] = row_of(quad.node[a]);
      rows_[row[a]].area += integral[a];
    }
    for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
      last = first;
      while (last < points.size() && points[last].face == points[first].face) ++last;
      add_overlap_with_face(row, dual, points, first, last);
    }
  }

  std::vector<GapRow> finish(bool with_slopes) {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      GapRow& row = rows_[r];
      row.entries.reserve(mortar_[r].size() + 1);
      row.entries.emplace_back(row.node, 1.0);
      if (with_slopes) row.slope_entries.reserve(mortar_[r].size());
      for (const auto& [node, sum] : mortar_[r]) {
        if (std::abs(sum[0]) > 1e-12 * row.area) row.entries.emplace_back(node, -sum[0] / row.area);
        if (with_slopes) row.slope_entries.push_back({node, {sum[1] / row.area, sum[2] / row.area}});
      }
      mortar_[r].clear();
    }
    return std::move(rows_);
  }

 private:
  int row_of(int node) {
    const auto [entry, added] = row_of_node_.try_emplace(node, static_cast<int>(rows_.size()));
    if (added) {
      rows_.emplace_back();
      rows_.back().node = node;
      mortar_.emplace_back();
    }
    return entry->second;
  }

  /// Points [first, last) lie on one face of the substrate; its sums are added to the rows as a whole.
  void add_overlap_with_face(const std::array<int, 4>& row, const Eigen::Matrix4d& dual,
                             const std::vector<OverlapPoint>& points, std::size_t first, std::size_t last) {
    double sums[4][4][3] = {};
    for (std::size_t k = first; k < last; ++k) {
      const auto& p = points[k];
      const Eigen::Vector4d psi = p.weight * (dual * Eigen::Map<const Eigen::Vector4d>(p.own.data()));
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
          sums[a][b][0] += psi[a] * p.other[b];
          sums[a][b][1] += psi[a] * p.slope[b][0];
          sums[a][b][2] += psi[a] * p.slope[b][1];
        }
    }
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        auto& sum = mortar_[row[a]][substrate_[points[first].face].node[b]];
        for (int k = 0; k < 3; ++k) sum[k] += sums[a][b][k];
      }
  }

  const std::vector<PlaneFace>& substrate_;
  std::unordered_map<int, int> row_of_node_;
  std::vector<GapRow> rows_;
  std::vector<std::map<int, std::array<double, 3>>> mortar_;  ///< integrals of psi N, psi dN/dx, psi dN/dy
};

}  // namespace

std::vector<PlaneQuad> quads(const std::vector<PlaneFace>& faces) {
  std::vector<PlaneQuad> result;
  for (const auto& f : faces)
    result.push_back({{{{f.x0, f.y0}, {f.x1, f.y0}, {f.x0, f.y1}, {f.x1, f.y1}}}, f.node});
  return result;
}

std::vector<GapRow> couple_interfaces(const std::vector<PlaneQuad>& particle,
                                      const std::vector<PlaneFace>& substrate, bool with_slopes) {
  if (particle.empty()) return {};
  const std::vector<PlaneFace> near = near_faces(particle, substrate);
  const FaceBins bins(near, 2 * least_width(particle));
  // Some hundred faces at a time: a face has a hundred points.
  constexpr std::size_t block = 512;
  constexpr int grain = 16;
  MortarRows rows(near);
  std::vector<std::vector<OverlapPoint>> points(block);
  for (std::size_t start = 0; start < particle.size(); start += block) {
    const std::size_t count = std::min(block, particle.size() - start);
    for_parts(static_cast<int>(count), grain, [&](int first, int last) {
      for (int q = first; q < last; ++q) find_overlaps(particle[start + q], near, bins, points[q]);
    });
    for (std::size_t q = 0; q < count; ++q) rows.add_face(particle[start + q], points[q]);
  }
  return rows.finish(with_slopes);
}

}  // namespace asperity::fem
