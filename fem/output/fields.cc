#include <algorithm>
#include <stdexcept>

#include "fem/output/field.h"

namespace asperity::fields {
std::vector<fem::Field> make_all();  // generated from the files of fields/
}

namespace asperity::fem {
namespace {

/// A number for each row of the contact.
template <class Of>
auto each_row(Of of) {
  return [of](const ShownState& shown) {
    std::vector<double> values;
    for (std::size_t r = 0; r < shown.system.rows().size(); ++r) values.push_back(of(shown, r));
    return values;
  };
}

/// The same for each cell.
template <class Of>
auto each_cell(Of of) {
  return [of](const ShownState& shown) {
    std::vector<double> values;
    for (const auto& cell : shown.cells) values.push_back(of(cell));
    return values;
  };
}

double height_of_particle(const ShownState& shown, std::size_t row) {
  const auto& height = shown.system.options().mesh.particle_height;
  const auto& place = shown.system.interface_points()[shown.system.rows()[row].node];
  return height ? height(place[0], place[1]) : 0.0;
}

double height_of_substrate(const ShownState& shown, std::size_t row) {
  const auto& height = shown.system.options().mesh.substrate_height;
  const auto& place = shown.system.row_points()[row];
  const RigidMotion shift = shown.system.coupling().surface();
  return height ? height(place[0] + shift.x, place[1] + shift.y) : 0.0;
}

std::vector<double> shear_tractions(const ShownState& shown) {
  std::vector<double> values;
  for (std::size_t r = 0; r < shown.system.rows().size(); ++r) {
    for (const auto& component : shown.state.shear) values.push_back(component[r]);
    values.push_back(0);
  }
  return values;
}

std::vector<double> stresses(const ShownState& shown) {
  std::vector<double> values;
  for (const auto& cell : shown.cells)
    for (const double component : cell.stress) values.push_back(component);
  return values;
}

std::vector<double> bodies_of_cells(const ShownState& shown) {
  std::vector<double> values;
  for (const auto& batch : shown.system.level().batches())
    for (int l = 0; l < batch.count; ++l) values.push_back(batch.body[l]);
  return values;
}

}  // namespace

const std::vector<Field>& shipped_fields() {
  using Place = FieldPlace;
  static const std::vector<Field> fields{
      {"gap", "m", "distance between the surfaces, 0 where they touch", Place::contact, 1,
       each_row([](const auto& s, std::size_t r) { return s.is_closed(r) ? 0.0 : s.gaps[r]; })},
      {"pressure", "Pa", "contact pressure", Place::contact, 1,
       each_row([](const auto& s, std::size_t r) { return s.state.multiplier[r]; })},
      {"status", "", "1 where the surfaces touch, else 0", Place::contact, 1,
       each_row([](const auto& s, std::size_t r) { return s.is_closed(r) ? 1.0 : 0.0; })},
      {"height_particle", "m", "roughness of the particle", Place::contact, 1, each_row(height_of_particle)},
      {"height_substrate", "m", "roughness of the substrate opposite", Place::contact, 1,
       each_row(height_of_substrate)},
      {"shear_traction", "Pa", "on the particle", Place::contact, 3, shear_tractions},
      {"stress", "Pa", "Cauchy's, xx yy zz xy yz xz", Place::bodies, 6, stresses},
      {"von_mises", "Pa", "equivalent stress", Place::bodies, 1,
       each_cell([](const CellState& cell) { return cell.von_mises; })},
      {"equivalent_plastic_strain", "", "accumulated", Place::bodies, 1,
       each_cell([](const CellState& cell) { return cell.plastic_strain; })},
      {"body", "", "0: particle, 1: substrate", Place::bodies, 1, bodies_of_cells}};
  return fields;
}

const std::vector<Field>& added_fields() {
  static const auto list = [] {
    auto added = with_registered_makers(fields::make_all(), [](const Field& field) { return field.name; });
    for (const auto& field : added)
      for (const auto& known : shipped_fields())
        if (field.name == known.name) throw std::logic_error("there are two fields '" + field.name + "'");
    return added;
  }();
  return list;
}

}  // namespace asperity::fem
