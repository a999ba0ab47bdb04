#include "fem/contact/contact_system.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace asperity::fem {

ContactSystem::ContactSystem(MPI_Comm communicator, const ContactSystemOptions& options)
    : options_(options),
      geometry_(options.mesh),
      forest_(meshing::make_forest(communicator, options.mesh)),
      materials_(options.materials, options.films) {
  level_ = std::make_unique<MeshLevel>(*forest_, options.control);
  level_->take_films(geometry_, materials_);
  positions_ = level_->node_positions(geometry_);
  bodies_ = std::make_unique<PlasticBodies>(*level_, positions_, materials_);
  find_faces();
  couple();
  describe_rows();
  level_->release_dofs();
}

void ContactSystem::describe_rows() {
  std::vector<int> row_of_node(interface_points_.size(), -1);
  for (std::size_t r = 0; r < rows_.size(); ++r) row_of_node[rows_[r].node] = static_cast<int>(r);
  for (const auto& face : faces_[0]) {
    auto& quad = row_quads_.emplace_back();
    for (int v = 0; v < 4; ++v) quad[v] = row_of_node[face.node[v]];
  }
  interface_ = std::make_unique<InterfaceOperator>(*level_, rows_, InterfaceNodes(*level_));
  gaps_ = interface_->gaps(positions_.begin());
  std::array<double, 2> smallest, largest;
  for (int c = 0; c < 2; ++c) {
    const auto by_place = [&](const GapRow& a, const GapRow& b) {
      return interface_points_[a.node][c] < interface_points_[b.node][c];
    };
    const auto [low, high] = std::minmax_element(rows_.begin(), rows_.end(), by_place);
    smallest[c] = interface_points_[low->node][c], largest[c] = interface_points_[high->node][c];
  }
  for (const auto& row : rows_) {
    const auto& p = interface_points_[row.node];
    const double inside =
        std::min({p[0] - smallest[0], p[1] - smallest[1], largest[0] - p[0], largest[1] - p[1]});
    on_rim_.push_back(inside < 0.5 * options_.mesh.sizes.spacing_particle);
  }
  linear_ = linear_solver(materials_);
}

std::unique_ptr<LinearSolver> ContactSystem::linear_solver(const CellMaterials& materials) const {
  return make_linear_solver(options_.backend, {*level_, positions_, materials, *interface_, rows_,
                                               options_.mesh, geometry_, options_.control});
}

std::unique_ptr<LinearSolver> ContactSystem::linear_without_films(
    const std::array<J2Material, 2>* other) const {
  if (!other && !materials_.has_films()) return nullptr;
  const std::array<J2Material, 2>& bodies = other ? *other : options_.materials;
  std::array<Film, 2> as_bodies = options_.films;
  for (int b = 0; b < 2; ++b) as_bodies[b].material = bodies[b];
  return linear_solver({bodies, as_bodies});
}

void ContactSystem::find_faces() {
  const InterfaceNodes nodes(*level_);
  interface_points_.resize(nodes.count());
  for (int c = 0; c < 3; ++c) {
    const auto values = nodes.gather(positions_.begin(), c);
    for (int k = 0; k < nodes.count(); ++k) interface_points_[k][c] = values[k];
  }
  const auto& sizes = options_.mesh.sizes;
  const meshing::FinePart part = options_.mesh.fine_part(meshing::Body::particle);
  for (const auto& f : level_->interface_faces()) {
    PlaneFace face;
    for (int v = 0; v < 4; ++v) face.node[v] = nodes.index(f.node[v]);
    const auto& low = interface_points_[face.node[0]];
    const auto& high = interface_points_[face.node[3]];
    face.x0 = low[0], face.y0 = low[1], face.x1 = high[0], face.y1 = high[1];
    const double along = std::max(part.low - face.x0, face.x1 - part.high),
                 across = std::max(std::abs(face.y0), std::abs(face.y1));
    if (f.body == 0 && std::max(along, across) > sizes.region_particle * (1 + 1e-9)) continue;
    if (f.body == 0 && face.x1 - face.x0 > 1.5 * sizes.spacing_particle)
      throw WorkError(
          "the particle's contact region is not uniformly meshed; this is an error of the program");
    faces_[f.body].push_back(face);
  }
  for (auto& faces : faces_) faces.shrink_to_fit();
  if (faces_[0].empty())
    throw WorkError(
        "the contact region holds no face; enlarge Mesh/Contact region or reduce Mesh/Interface spacing");
}

void ContactSystem::couple() {
  const RigidMotion surface = coupling_.surface();
  const Rotation turn = rotation(surface), frames = rotation(coupling_.frames);
  const double radius = options_.mesh.sizes.radius;
  std::vector<PlaneQuad> particle;
  for (const auto& face : faces_[0]) {
    auto& quad = particle.emplace_back();
    quad.node = face.node;
    for (int v = 0; v < 4; ++v) {
      const auto p = turned(turn, interface_points_[face.node[v]], radius);
      quad.corner[v] = {p[0] + surface.x, p[1] + surface.y};
    }
  }
  rows_ = couple_interfaces(particle, faces_[1], options_.tilted_normals);
  row_points_.clear();
  areas_.clear();
  elastic_.clear();
  for (const auto& row : rows_) {
    const auto& place = row_points_.emplace_back(turned(turn, interface_points_[row.node], radius));
    const auto strainless = turned(frames, interface_points_[row.node], radius);
    elastic_.push_back(
        {place[0] - strainless[0] + coupling_.elastic.x, place[1] - strainless[1] + coupling_.elastic.y});
    areas_.push_back(row.area);
  }
}

void ContactSystem::couple_at(Coupling coupling, const Vector<double>& accepted) {
  if (!options_.tilted_normals) coupling.frames.spin = 0;
  const double radius = options_.mesh.sizes.radius;
  // Far below any change of a gap that matters.
  const double unnoticed = 1e-6 * options_.mesh.sizes.spacing_particle;
  const RigidMotion here = coupling_.surface(), there = coupling.surface();
  const double path_length =
      std::hypot(there.x - here.x, there.y - here.y) + radius * std::abs(there.roll - here.roll);
  if (!options_.tilted_normals && path_length < unnoticed) return;
  if (there.roll != here.roll) level_->set_drive_tilt(-std::tan(there.roll));
  coupling_ = coupling;
  interface_before_ = std::make_unique<InterfaceOperator>(*interface_);
  couple();
  if (options_.tilted_normals) tilt(accepted);
  interface_->set_rotation(rotation(coupling_.frames));
  interface_->set_rows(rows_, InterfaceNodes(*level_));
  untilted_gaps_ = interface_->jumps(positions_.begin(), 2);
  // The turn is about the particle's centre, not about the origin.
  for (auto& gap : untilted_gaps_) gap += radius * (1 - interface_->rotation()[2][2]);
  find_initial_gaps();
  linear_->recouple(coupling_.frames);
}

void ContactSystem::find_initial_gaps() {
  // The coupling already has the mean elastic displacement, which the displacements bring along once more.
  gaps_ = untilted_gaps_;
  for (std::size_t r = 0; r < gaps_.size(); ++r)
    for (int c = 0; c < 2; ++c) gaps_[r] -= rows_[r].slope[c] * elastic_[r][c];
}

void ContactSystem::follow_slopes(const Vector<double>& displacement) {
  if (!options_.tilted_normals) return;
  tilt(displacement);
  interface_->set_slopes(rows_);
  find_initial_gaps();
  linear_->follow_slopes();
}

void ContactSystem::tilt(const Vector<double>& displacement) {
  std::vector<double> height = interface_->nodes().gather(displacement.begin(), 2);
  for (std::size_t k = 0; k < height.size(); ++k) height[k] += interface_points_[k][2];
  for (auto& row : rows_) {
    row.slope = {};
    for (const auto& [node, weights] : row.slope_entries)
      for (int c = 0; c < 2; ++c) row.slope[c] -= weights[c] * height[node];
  }
}

namespace {
double poisson_ratio(const J2Material& m) {
  return (3 * m.bulk_modulus - 2 * m.shear_modulus) / (2 * (3 * m.bulk_modulus + m.shear_modulus));
}
}  // namespace

double ContactSystem::reduced_modulus(const std::array<J2Material, 2>& bodies) {
  double compliance = 0;
  for (const auto& m : bodies)
    compliance += (1 - poisson_ratio(m)) / (2 * m.shear_modulus);  // (1 - nu^2) / E
  return 1 / compliance;
}

double ContactSystem::reduced_shear_modulus(const std::array<J2Material, 2>& bodies) {
  double compliance = 0;
  for (const auto& m : bodies) compliance += (2 - poisson_ratio(m)) / m.shear_modulus;
  return 1 / compliance;
}

double ContactSystem::torsion_modulus() const {
  return 1 / (1 / options_.materials[0].shear_modulus + 1 / options_.materials[1].shear_modulus);
}

}  // namespace asperity::fem
