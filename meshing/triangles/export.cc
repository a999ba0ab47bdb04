#include "meshing/triangles/export.h"

#include <cmath>

#include "core/error.h"
#include "core/printed.h"
#include "meshing/triangles/surface_files.h"
#include "meshing/triangles/tetrahedra_files.h"

namespace asperity::meshing {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& known) {
  throw InputError("cannot recognise the format of '" + path.string() +
                   "' from its extension; end the name with " + known);
}

std::string count_of(std::size_t count, const std::string& singular, const std::string& plural) {
  return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

}  // namespace

void write_surface(const TriangleSurface& surface, const std::filesystem::path& path, LengthUnit unit) {
  const auto extension = path.extension();
  if (extension == ".stl")
    write_stl(surface, path, unit);
  else if (extension == ".ply")
    write_ply(surface, path, unit);
  else if (extension == ".off")
    write_off(surface, path, unit);
  else
    refuse(path, ".stl, .ply or .off");
}

void write_tetrahedra(const TetrahedralMesh& mesh, const std::filesystem::path& path, LengthUnit unit) {
  const auto extension = path.extension();
  if (extension == ".vtu")
    write_vtu(mesh, path, unit);
  else if (extension == ".msh")
    write_msh(mesh, path, unit);
  else
    refuse(path, ".vtu or .msh");
}

std::string summary(const std::string& name, const TriangleSurface& surface, const SurfaceCheck& check) {
  constexpr double um2 = 1e-12, um3 = 1e-18;
  std::string text = name + " surface: " + count_of(surface.triangles.size(), "triangle", "triangles") +
                     ", " + count_of(surface.points.size(), "point", "points") + ", " +
                     count_of(check.components, "piece", "pieces") + ", area " +
                     printed("%.5g um^2", check.area / um2);
  if (check.closed()) text += ", volume " + printed("%.5g um^3", check.volume / um3);
  text += "\n" + name + " surface: ";
  if (check.bounds_a_body()) return text + "closed, manifold, outward, free of self-intersections\n";
  return text + "not a body: " + check.defects() + "\n";
}

std::string summary(const std::string& name, const TetrahedralMesh& mesh, const TetrahedraQuality& quality,
                    double surface_volume) {
  return name + " tetrahedra: " + std::to_string(mesh.tetrahedra.size()) + " with " +
         std::to_string(mesh.points.size()) + " points, their volume " +
         printed("%+.2f %%", 100 * (quality.volume / surface_volume - 1)) + " from the surface's\n" + name +
         " tetrahedra: smallest dihedral angle " +
         printed("%.1f deg", quality.smallest_dihedral_angle * 180 / M_PI) + ", radius ratio " +
         printed("%.2f", quality.smallest_radius_ratio) + " (mean " +
         printed("%.2f", quality.mean_radius_ratio) + "), scaled Jacobian " +
         printed("%.2f", quality.smallest_scaled_jacobian) + "\n";
}

}  // namespace asperity::meshing
