#include "dem_compare/compare/side_by_side.h"

#include <algorithm>
#include <map>

#include "dem_compare/cases/common_label.h"
#include "dem_compare/compare/finite_element_column.h"

namespace asperity {
namespace {

bool is_load(double one, double other) {
  constexpr double tolerance = 1e-3;  // steps of a solver end on a load but for its tolerance
  return std::abs(one - other) <= tolerance * other;
}

/// Loads without those that are the same.
std::vector<double> distinct(std::vector<double> loads) {
  std::sort(loads.begin(), loads.end());
  loads.erase(std::unique(loads.begin(), loads.end(), is_load), loads.end());
  return loads;
}

/// Both ends of a range, and their geometric mean, so that a border between loads is not drawn over the whole
/// range.
std::vector<double> with_middle(const LoadRange& range) {
  return {range.low, std::sqrt(range.low * range.high), range.high};
}

/// A contact whose numbers were given.
struct Record {
  ComparedContact contact;
  bool roughness_is_open = false;

  /// Same bodies and roughness.
  bool is(const ComparedContact& other) const {
    return same_bodies(other, contact) && same_roughness(other, contact);
  }
};

class Assembly {
 public:
  Assembly(const SideBySideInput& input, const MeasuredColumn& published, EngineColumn& engine)
      : input_(input),
        published_(published),
        engine_(engine),
        points_(finite_element_points(input.collection, input.with_hertz)) {
    std::map<ContactInputs, std::vector<std::string>> labels;
    for (const auto& group : input.collection.groups) {
      contacts_.push_back(contact_of(group));
      keys_.push_back(contact_inputs(group.first()));
      labels[keys_.back()].push_back(group.label);
    }
    for (const auto& key : keys_) labels_.push_back(common_label(labels[key]));
    for (const auto& parameters : input.parameters) add(contact_of(parameters, input.indenter));
  }

  std::vector<ComparisonRow> rows() {
    for (const auto& record : records_) add_rows_of(record);
    add_rails();
    for (std::size_t g = 0; g < contacts_.size(); ++g)
      for (const auto& point : points_)
        if (point.group == g) add_solved(point);
    return std::move(rows_);
  }

  std::vector<std::string> remarks() const {
    std::vector<std::string> remarks;
    std::string unsolved;
    for (const Motion mode : {Motion::normal, Motion::sliding, Motion::rolling, Motion::torsion})
      if (!is_solved(mode)) unsolved += (unsolved.empty() ? "" : ", ") + std::string(name_of(mode));
    if (!unsolved.empty())
      remarks.push_back("Not among the finished cases, so without finite elements: " + unsolved + ".");
    if (records_.empty())
      remarks.push_back(
          "Rolling and rails need a contact's numbers: add --parameters FILE (as "
          "runs/paper/parameters_silicon.json).");
    if (is_solved(Motion::sliding))
      remarks.push_back(
          "Friction at the interface is an input of finite elements: their sliding force judges a law only "
          "as far as both start from the same coefficient.");
    for (const auto& record : records_) {
      if (record.roughness_is_open)
        remarks.push_back(
            record.contact.record->file +
            " does not say the roughness of its target ('rms'), and the solved cases have several: give it.");
      else if (std::none_of(contacts_.begin(), contacts_.end(), [&](const auto& c) { return record.is(c); }))
        remarks.push_back("None of the solved cases is the contact of " + record.contact.record->file +
                          " (its bodies, and the RMS of its target): its finite-element column is empty.");
    }
    return remarks;
  }

 private:
  void add_solved(const FiniteElementPoint& point) {
    const bool is_path = std::count_if(points_.begin(), points_.end(), [&](const auto& other) {
                           return other.group == point.group && other.quantity == point.quantity;
                         }) > 1;
    ComparedContact contact = contacts_[point.group];
    if (!is_path) {
      // A record's own table has it, or an experiment before this one: all press the contact down.
      for (const auto& record : records_)
        if (solved_point(record, point.quantity, point.load) == &point) return;
      for (const auto& other : points_)
        if (other.group < point.group && keys_[other.group] == keys_[point.group] &&
            other.quantity == point.quantity && is_load(other.load, point.load))
          return;
      // A loading path has its loads in itself; other numbers have theirs in several cases of one contact.
      contact.label = labels_[point.group];
    }
    add_rows(contact, point.quantity, point.load, point.value);
  }

  void add_rows(const ComparedContact& contact, Quantity quantity, double load,
                const FiniteElementValue& finite_elements, const RailCase* rail = nullptr) {
    for (const LawValue& law : law_values(quantity, contact, load, rail)) {
      ComparisonRow row;
      row.contact = contact.label;
      row.quantity = quantity;
      row.load = load;
      row.rms = rail ? published_.rail_rms(rail->angle) : contact.rms;
      if (rail) row.rail_angle = rail->angle;
      row.finite_elements = finite_elements;
      row.reduced_law = law;
      row.engine = engine_.value(law);
      row.published = rail ? published_.rail(quantity, contact, rail->angle, load)
                           : published_.value(quantity, contact, load);
      rows_.push_back(std::move(row));
    }
  }

  /// A record's contact at a load; of several groups the first.
  const FiniteElementPoint* solved_point(const Record& record, Quantity quantity, double load) const {
    for (const auto& point : points_)
      if (point.quantity == quantity && is_load(point.load, load) && record.is(contacts_[point.group]))
        return &point;
    return nullptr;
  }

  FiniteElementValue solved_value(const Record& record, Quantity quantity, double load) const {
    if (const auto* point = solved_point(record, quantity, load)) return point->value;
    FiniteElementValue none;
    const Motion mode = display_of(quantity).mode;
    const bool is_told = std::any_of(points_.begin(), points_.end(),
                                     [&](const auto& point) { return point.quantity == quantity; });
    none.reason = !is_solved(mode) ? std::string("not solved by finite elements: no case of ") +
                                         name_of(mode) + " is among the folders"
                  : is_told ? "no case of this contact at this load is among the folders"
                            : "the solved cases of " + std::string(name_of(mode)) + " tell no " +
                                  display_of(quantity).words;
    return none;
  }

  bool is_solved(Motion mode) const {
    return std::any_of(points_.begin(), points_.end(),
                       [&](const auto& point) { return display_of(point.quantity).mode == mode; });
  }

  /// Ends of the fitted loads with their geometric mean, and the loads that were solved.
  std::vector<double> loads_of(const Record& own, Motion mode) const {
    const ContactParameters& record = *own.contact.record;
    std::vector<double> loads;
    const auto add = [&](const std::optional<EffectiveQuantity>& quantity) {
      if (!quantity || !quantity->load_range) return;
      for (const double load : with_middle(*quantity->load_range)) loads.push_back(load);
    };
    if (mode == Motion::sliding) add(record.sliding_friction);
    if (mode == Motion::rolling || mode == Motion::normal) add(record.rolling_friction);
    if (mode == Motion::normal && loads.empty()) add(record.sliding_friction);
    if (mode == Motion::torsion) add(record.torsion_friction);
    for (const auto& point : points_)
      if (display_of(point.quantity).mode == mode && own.is(contacts_[point.group]) &&
          is_load(point.load, input_.with_hertz.groups[point.group].numbers.force))
        loads.push_back(point.load);
    constexpr double otherwise = 1e-4;  // the paper's loop
    if (loads.empty()) loads.push_back(otherwise);
    return distinct(loads);
  }

  void add(const ComparedContact& given) {
    Record record{given};
    // A record that does not say its roughness stands for all, if all are alike.
    if (std::isnan(record.contact.rms))
      for (const auto& contact : contacts_)
        if (same_bodies(contact, record.contact)) {
          record.roughness_is_open = record.roughness_is_open || (!std::isnan(record.contact.rms) &&
                                                                  !same_roughness(contact, record.contact));
          record.contact.rms = contact.rms;
        }
    if (record.roughness_is_open) record.contact.rms = NAN;
    // Numbers for an engine belong to the contact they were found on.
    for (auto& contact : contacts_)
      if (record.is(contact) && !contact.record) {
        contact.record = record.contact.record;
        contact.indenter = record.contact.indenter;
      }
    records_.push_back(std::move(record));
  }

  void add_rows_of(const Record& record) {
    for (const Quantity quantity :
         {Quantity::approach, Quantity::normal_stiffness, Quantity::lateral_stiffness,
          Quantity::lateral_stiffness_to_sliding, Quantity::sliding_friction, Quantity::rolling_stiffness,
          Quantity::rolling_friction, Quantity::torsion_stiffness, Quantity::torsion_friction})
      for (const double load : loads_of(record, display_of(quantity).mode))
        add_rows(record.contact, quantity, load, solved_value(record, quantity, load));
  }

  /// Rails have roughnesses of their own: once, with the torsion of the first record.
  void add_rails() {
    if (records_.empty()) return;
    FiniteElementValue none;
    none.reason = "a rail is an experiment with three contacts, which finite elements do not solve here";
    for (const RailCase& rail : published_.rails())
      for (const Quantity quantity : {Quantity::rail_friction, Quantity::rail_force})
        for (const double load : with_middle(rail.loads))
          add_rows(records_.front().contact, quantity, load, none, &rail);
  }

  const SideBySideInput& input_;
  const MeasuredColumn& published_;
  EngineColumn& engine_;
  std::vector<FiniteElementPoint> points_;
  std::vector<ComparedContact> contacts_;  ///< of each group
  std::vector<ContactInputs> keys_;  ///< of each group's contact: the same where only the experiment differs
  std::vector<std::string> labels_;  ///< of each group's contact, whatever the load
  std::vector<Record> records_;
  std::vector<ComparisonRow> rows_;
};

}  // namespace

SideBySide compare_side_by_side(const SideBySideInput& input, const MeasuredColumn& published,
                                EngineColumn& engine, double tolerance) {
  Assembly assembly(input, published, engine);
  SideBySide result;
  result.tolerance = tolerance;
  result.rows = assembly.rows();
  result.verdicts = verdicts(result.rows, tolerance);
  result.remarks = assembly.remarks();
  result.engine = engine.engine();
  result.engine_version = engine.version();
  result.engine_failure = engine.failure();
  return result;
}

}  // namespace asperity
