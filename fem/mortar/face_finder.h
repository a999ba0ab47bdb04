// Finds the interface face of a mesh level that holds a site of the lattice, and contact rows seen from the
// level.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/error.h"
#include "fem/levels/mesh_level.h"
#include "fem/mortar/interface_nodes.h"
#include "fem/mortar/mortar.h"

namespace asperity::fem {

class FaceFinder {
 public:
  /// A face in the lattice, with the nodes of its corners.
  struct Face {
    int i, j, size;           ///< as in InterfaceFace
    std::array<int, 4> node;  ///< indices in `nodes`
  };

  /// faces: of the level of `nodes`.
  FaceFinder(const std::vector<InterfaceFace>& faces, const InterfaceNodes& nodes) {
    std::set<int> sizes;
    for (const InterfaceFace& face : faces) {
      sizes.insert(face.size);
      by_corner_[key(face.body, face.i, face.j, face.size)] = static_cast<int>(faces_.size());
      Face& found = faces_.emplace_back(Face{face.i, face.j, face.size, {}});
      for (std::size_t v = 0; v < 4; ++v) found.node[v] = nodes.index(face.node[v]);
    }
    sizes_.assign(sizes.begin(), sizes.end());
  }

  /// Throws WorkError where there is none.
  const Face& at(const InterfaceNodes::Site& site) const {
    constexpr int end = 1 << lattice_bits;
    const int i = std::min(site.i, end - 1), j = std::min(site.j, end - 1);
    for (const int size : sizes_) {
      const auto face = by_corner_.find(key(site.body, i & ~(size - 1), j & ~(size - 1), size));
      if (face != by_corner_.end()) return faces_[static_cast<std::size_t>(face->second)];
    }
    throw WorkError("an interface node lies on no face of a coarser mesh; this is an error of the program");
  }

  /// Nodes of the level and weights of a row of the finest mesh, whose shape functions are evaluated there.
  using Entries = std::vector<std::pair<int, double>>;
  Entries entries(const GapRow& row, const InterfaceNodes& fine_nodes) const {
    Entries merged;
    for (const auto& [fine_node, weight] : row.entries) {
      const auto& site = fine_nodes.site(fine_node);
      const Face& face = at(site);
      const double s = static_cast<double>(site.i - face.i) / face.size,
                   t = static_cast<double>(site.j - face.j) / face.size;
      const double shape[4] = {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
      for (std::size_t v = 0; v < 4; ++v) {
        if (shape[v] == 0) continue;
        const int node = face.node[v];
        const auto known =
            std::find_if(merged.begin(), merged.end(), [&](const auto& e) { return e.first == node; });
        if (known == merged.end())
          merged.emplace_back(node, weight * shape[v]);
        else
          known->second += weight * shape[v];
      }
    }
    return merged;
  }

 private:
  static std::uint64_t key(int body, int i, int j, int size) {
    int log = 0;
    while ((1 << log) < size) ++log;
    return (((static_cast<std::uint64_t>(body) << 5 | log) << 24 | i) << 24) | j;
  }

  std::vector<Face> faces_;
  std::unordered_map<std::uint64_t, int> by_corner_;
  std::vector<int> sizes_;
};

}  // namespace asperity::fem
