// What a contact did, one row for each accepted step: what the solver writes as history.csv, and what derive,
// compare, diagnosis and report read. SI units. A column that other parts compute with is one line here, one
// in history.cc and one where it is filled; any other is a file of its own (fem/output/added_column.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Value: double for a row, a vector of all rows' values for a history.
template <class Value>
struct HistoryColumns {
  Value step{};                  ///< its number
  Value time{};                  ///< as the case says [s]; a second for each step where it says none
  Value normal_displacement{};   ///< approach of points far from the contact [m]
  Value normal_force{};          ///< [N], compression is positive
  Value lateral_displacement{};  ///< of points far from the contact along x [m]
  Value lateral_force{};         ///< [N]
  Value rolling_angle{};         ///< [rad]
  Value rolling_moment{};        ///< about the contact [N m]
  Value torsion_angle{};         ///< [rad]
  Value torsion_moment{};        ///< [N m]
  Value contact_radius{};        ///< of the circle with the contact area [m]
  Value contact_area{};          ///< real area [m^2]
  Value max_pressure{};          ///< [Pa]
  Value plastic_volume{};        ///< [m^3]
  Value dissipated_energy{};     ///< [J]
  // Beyond the columns that every history has:
  Value driven_displacement{};  ///< of the driven plane, finite bodies included [m]
  Value shift{};                ///< of the particle's frame along x, finite bodies included [m]
  Value elastic_energy{};       ///< [J]
  Value hardening_energy{};     ///< stored by hardening and by delayed elasticity [J]
  Value plastic_work{};         ///< on plastic and viscous strain [J]
  Value friction_work{};        ///< dissipated by slip [J]
  Value adhesion_energy{};      ///< potential of attraction [J]
  Value adhesion_loss{};        ///< dissipated by bonds that form and break [J]
  Value attraction{};           ///< part of the normal force that attracts [N]
  Value work{};                 ///< of the external forces and moments [J]
  Value mean_pressure{};        ///< [Pa]
  Value largest_plastic_strain{};
  Value largest_von_mises{};  ///< [Pa]
  Value force_error{}, moment_error{},
      energy_error{};  ///< relative: tractions against reactions; energy left open
  Value newton_iterations{}, linear_iterations{};
  Value penetration{};           ///< relative change of pressures and shear by the last multiplier update
  Value wall_time{};             ///< [s]
  Value reaches_rim{};           ///< 1 where contact has come to the edge of the potential contact zone
  Value sticking_share{};        ///< of the active contact nodes
  Value shift_across{};          ///< of the particle's frame along y [m]
  Value lateral_force_across{};  ///< [N]
  Value mean_plane_approach{};   ///< counted from where the mean surfaces, without roughness, would touch [m]
  Value pressure_radius{};       ///< of the Hertzian pressure with the same second moment [m]
  Value load_centre_x{}, load_centre_y{};  ///< of the contact pressure, in the substrate's frame [m]
  Value spots{};                           ///< contacts apart from each other
  Value contact_perimeter{};               ///< length of their edges [m]
  Value particle_von_mises{}, substrate_von_mises{};            ///< largest of each body [Pa]
  Value particle_plastic_strain{}, substrate_plastic_strain{};  ///< largest of each body
  Value load_step_error{};  ///< of the approach, from finite load steps of bodies that yield; positive: too
                            ///< large [m]
};

/// An accepted step.
struct HistoryRow : HistoryColumns<double> {
  std::vector<double> added;  ///< of the columns that files of their own add, in their units
};

/// A column that a file of its own adds.
struct AddedValues {
  std::string name;            ///< with its unit
  std::vector<double> values;  ///< in that unit
};

/// Columns of equal length; those that a file does not have are empty.
struct History : HistoryColumns<std::vector<double>> {
  std::vector<AddedValues> added;

  /// Radius [m] of the contact as a whole, which spots of a rough one spread over: that of the pressure.
  /// Where a history lacks it, the contact radius: earlier versions had one column for both.
  const std::vector<double>& radius_of_whole() const {
    return pressure_radius.empty() ? contact_radius : pressure_radius;
  }
  std::size_t size() const { return normal_force.size(); }
};

/// A column of history.csv and the members that hold it.
struct HistoryColumn {
  const char* name;  ///< with its unit, "normal_force [N]"
  double HistoryRow::*of_row;
  std::vector<double> HistoryColumns<std::vector<double>>::*values;
  bool always;  ///< every history has it
};
const std::vector<HistoryColumn>& history_columns();

/// The columns of these rows; `added`: names of what each row has added.
History history_of(const std::vector<HistoryRow>& rows, const std::vector<std::string>& added = {});

/// Throws InputError naming file and column; cells that are not known are NaN. Columns that are neither known
/// here nor named in `added`, which the file must have, are passed over.
History read_history(const std::filesystem::path& file, const std::vector<std::string>& added = {});
/// history.csv. Of the columns that every history has, those that are empty are written as zeros; of the
/// others only those that are not.
std::string format_history(const History& history);

/// Row at which the largest load is reached. Those that follow under the same load, held or moved, differ
/// from it by what the solver leaves of a force (about 1e-6): the first within 1e-5 of the largest counts,
/// the contact that is loaded and has not yet moved. 0 for no rows.
std::size_t row_of_largest_load(const std::vector<double>& normal_force);
const HistoryRow& at_largest_load(const std::vector<HistoryRow>& rows);

/// Successive steps in which the load grows, falls or stays; the turning points belong to both neighbours.
struct HistoryBranch {
  enum class Kind { loading, unloading, hold } kind = Kind::loading;
  std::size_t first = 0, last = 0;  ///< rows, inclusive
  std::size_t size() const { return last - first + 1; }
};
std::vector<HistoryBranch> history_branches(const History& history);

}  // namespace asperity
