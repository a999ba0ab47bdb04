#include "dem_compare/resistance/moving_study.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/cases/common_label.h"
#include "dem_compare/cases/path_averages.h"

namespace asperity {
namespace {

class Sorter {
 public:
  Sorter(const CaseCollection& collection, MovingStudy& study) : collection_(collection), study_(study) {}

  void sort() {
    for (const auto& group : collection_.groups)
      for (const auto& solved : group.cases)
        if (const MotionMode* mode = mode_of(solved))
          add(group, solved, *mode);
        else if (const auto inclination = rail_inclination(solved)) {
          if (!add_rail(contact_of_group(group), solved, *inclination))
            leave_out(solved.folder.string(), "the path of Experiment/Program");
        }
    name_contacts();
    choose_meshes();
    for (auto& contact : study_.contacts) finish(contact);
    auto& contacts = study_.contacts;
    remark_on_realisations();
    for (auto& contact : contacts) finish_rails(contact);
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                  [](const auto& c) { return c.states.empty() && c.rails.empty(); }),
                   contacts.end());
  }

 private:
  void add(const CaseGroup& group, const SolvedCase& solved, const MotionMode& mode) {
    MovingCase moving = moving_case(solved, mode);
    if (!moving.first.reached()) return leave_out(moving.folder, mode.path_entry);
    MovingState& state = state_of(contact_of_group(group), mode, moving.load);
    state.cases.push_back(std::move(moving));
  }

  void leave_out(const std::string& folder, const std::string& entry) {
    study_.remarks.push_back(folder +
                             ": its path ends before the motion is steady for three steps; left out (" +
                             entry + " must be more)");
  }

  MovingContact& contact_of_group(const CaseGroup& group) {
    const ContactInputs inputs =
        contact_inputs(group.first());  // realisations of one cell of a study are one contact
    std::size_t at = 0;
    while (at < study_.contacts.size() && study_.contacts[at].inputs != inputs) ++at;
    if (at == study_.contacts.size()) {
      MovingContact contact;
      contact.inputs = inputs;
      contact.bodies = contact_of(group);
      contact.can_yield = yields(inputs, "Particle") || yields(inputs, "Substrate");
      contact.relaxes = relaxes(inputs, "Particle") || relaxes(inputs, "Substrate");
      contact.adheres = adheres(inputs);
      study_.contacts.push_back(std::move(contact));
      groups_.emplace_back();
    }
    if (groups_[at].empty() || groups_[at].back() != &group) groups_[at].push_back(&group);
    return study_.contacts[at];
  }

  static bool has(const MovingState& state, double spacing) {
    return std::any_of(state.cases.begin(), state.cases.end(),
                       [&](const auto& item) { return same_spacing(item.spacing, spacing); });
  }

  /// Contacts are compared on one mesh as far as the study has one.
  void choose_meshes() {
    std::vector<MovingState*> states;
    for (auto& contact : study_.contacts)
      for (auto& state : contact.states) states.push_back(&state);
    double common = INFINITY;
    if (!states.empty())
      for (const auto& item : states.front()->cases)
        if (std::all_of(states.begin(), states.end(),
                        [&](const auto* state) { return has(*state, item.spacing); }))
          common = std::min(common, item.spacing);
    for (auto* state : states) {
      double finest = INFINITY;
      for (const auto& item : state->cases) finest = std::min(finest, item.spacing);
      state->spacing = std::isfinite(common) ? common : finest;
      auto& cases = state->cases;
      const auto others = std::stable_partition(cases.begin(), cases.end(), [&](const auto& item) {
        return same_spacing(item.spacing, state->spacing);
      });
      state->on_other_meshes.assign(std::make_move_iterator(others), std::make_move_iterator(cases.end()));
      cases.erase(others, cases.end());
    }
  }

  static MovingState& state_of(MovingContact& contact, const MotionMode& mode, double load) {
    for (auto& state : contact.states)
      if (state.mode == &mode && same_load(state.load, load)) return state;
    contact.states.push_back({});
    contact.states.back().mode = &mode;
    contact.states.back().load = load;
    return contact.states.back();
  }

  /// From the values of the study's axes: those that no contact has several of, then whatever else it takes
  /// to tell contacts apart. Of an axis with several values, what they have in common names the contact, else
  /// the first one.
  void name_contacts() {
    const std::size_t count = collection_.axes.size();
    std::vector<bool> named(count, false);
    for (std::size_t axis = 0; axis < count; ++axis)
      named[axis] = collection_.axes[axis].labels.size() > 1 && !varies_within_a_contact(axis) &&
                    !is_of_experiment(axis);
    for (std::size_t axis = 0; axis < count; ++axis) {
      if (named[axis] || is_of_experiment(axis)) continue;
      std::vector<bool> more = named;
      more[axis] = true;
      if (different_labels(more) > different_labels(named)) named = more;
    }
    for (std::size_t at = 0; at < groups_.size(); ++at) {
      std::string& label = study_.contacts[at].label;
      label = label_of(at, named);
      if (label.empty()) label = count == 0 ? groups_[at].front()->label : "the contact";
      for (std::size_t other = 0; other < at; ++other)
        if (study_.contacts[other].label == label) label += " (" + std::to_string(at + 1) + ")";
    }
  }

  std::string label_of(std::size_t at, const std::vector<bool>& named) const {
    std::string label;
    for (std::size_t axis = 0; axis < named.size() && axis < groups_[at].front()->values.size(); ++axis) {
      if (!named[axis]) continue;
      std::vector<std::string> values;
      for (const CaseGroup* group : groups_[at]) values.push_back(group->values[axis]);
      label += (label.empty() ? "" : ", ") + common_label(values);
    }
    return label;
  }

  std::size_t different_labels(const std::vector<bool>& named) const {
    std::set<std::string> labels;
    for (std::size_t at = 0; at < groups_.size(); ++at) labels.insert(label_of(at, named));
    return labels.size();
  }

  bool varies_within_a_contact(std::size_t axis) const {
    for (const auto& groups : groups_)
      for (const CaseGroup* group : groups)
        if (axis < group->values.size() && group->values[axis] != groups.front()->values[axis]) return true;
    return false;
  }

  /// True for an axis that varies an entry of the experiment, as motion or load.
  bool is_of_experiment(std::size_t axis) const {
    for (const auto& groups : groups_)
      for (const CaseGroup* group : groups) {
        const auto& entries = group->first().entries.all();
        const bool found =
            axis < group->values.size() &&
            std::any_of(entries.begin(), entries.end(), [&](const auto& entry) {
              return entry.first.rfind("Experiment/", 0) == 0 && entry.second == group->values[axis];
            });
        if (!found) return false;
      }
    return true;
  }

  void finish(MovingContact& contact) {
    const Hertz hertz = contact.bodies.hertz();
    for (auto& state : contact.states) {
      state.hertz_radius = hertz.contact_radius(state.load);
      const double mu = contact.bodies.friction,
                   full_slip = state.mode == &torsion_mode() ? 3 * M_PI / 16 * state.hertz_radius : 1;
      state.coulomb = mu > 0 && state.mode != &rolling_mode() ? mu * state.load * full_slip : NAN;
      average(state);
      remark(contact, state);
    }
    std::stable_sort(
        contact.states.begin(), contact.states.end(), [](const MovingState& a, const MovingState& b) {
          const auto place = [](const MotionMode* mode) {
            return std::find(all_motions().begin(), all_motions().end(), mode);
          };
          return place(a.mode) != place(b.mode) ? place(a.mode) < place(b.mode) : a.load < b.load;
        });
  }

  void remark_on_realisations() {
    std::size_t most = 0;
    for (const auto& contact : study_.contacts)
      for (const auto& state : contact.states) most = std::max(most, state.cases.size());
    if (most == 1)
      study_.remarks.emplace_back(
          "one realisation of each surface: how blocks of its path differ stands in for how realisations "
          "would; features longer than the path are not in the uncertainty");
  }

  static void average(MovingState& state) {
    const auto mean = [&](const auto& of) {
      std::vector<Uncertain> values;
      for (const auto& item : state.cases) values.push_back(of(item));
      return mean_of_realisations(values);
    };
    state.parts.friction = mean([](const MovingCase& c) { return c.first.dissipated.friction; });
    state.parts.plastic = mean([](const MovingCase& c) { return c.first.dissipated.plastic; });
    state.parts.adhesion = mean([](const MovingCase& c) { return c.first.dissipated.adhesion; });
    state.parts.total = mean([](const MovingCase& c) { return c.first.dissipated.total; });
    state.resistance = mean([](const MovingCase& c) { return c.resistance(); });
    state.force = mean([](const MovingCase& c) { return c.first.force; });
    state.back_over_first = mean([](const MovingCase& c) {
      return c.back.reached() ? ratio(c.back.resistance(), c.first.resistance()) : Uncertain{NAN, NAN};
    });
    double squares = 0;
    for (const auto& item : state.cases) squares += item.first.fluctuation * item.first.fluctuation;
    state.fluctuation = std::sqrt(squares / static_cast<double>(state.cases.size()));
    for (const auto& item : state.cases) {
      state.contact_area += item.contact_area / static_cast<double>(state.cases.size());
      if (std::abs(item.first.unbalanced) > std::abs(state.unbalanced))
        state.unbalanced = item.first.unbalanced;
    }
  }

  void remark(const MovingContact& contact, const MovingState& state) {
    const std::string name = name_of(state.mode->motion) + " of " + contact.label + " at " +
                             format_quantity(state.load, Dimension::force);
    const double size = std::abs(state.resistance.value);
    constexpr double much = 0.1;
    if (std::abs(state.unbalanced) > much * size)
      study_.remarks.push_back(name + ": the energy balance leaves " +
                               format_quantity(100 * std::abs(state.unbalanced) / size, Dimension::none, 2) +
                               " % of the resistance open; it counts as a standard deviation");
    for (const auto& item : state.cases)
      if (item.first.still_changes()) {
        study_.remarks.push_back(name + ": the resistance still changes along the path (by " +
                                 format_quantity(100 * item.first.drift, Dimension::none, 2) +
                                 " % from its first half to its second)");
        break;
      }
  }

  const CaseCollection& collection_;
  MovingStudy& study_;
  std::vector<std::vector<const CaseGroup*>> groups_;  ///< of each contact
};

}  // namespace

double MovingState::scale() const { return mode == &sliding_mode() ? load : load * hertz_radius; }

const MovingState* MovingContact::find(const MotionMode& mode, double load) const {
  for (const auto& state : states)
    if (state.mode == &mode && same_load(state.load, load)) return &state;
  return nullptr;
}

std::vector<const MovingState*> MovingContact::of(const MotionMode& mode) const {
  std::vector<const MovingState*> found;
  for (const auto& state : states)
    if (state.mode == &mode) found.push_back(&state);
  return found;
}

MovingStudy collect_moving(const CaseCollection& collection) {
  MovingStudy study;
  Sorter(collection, study).sort();
  return study;
}

std::vector<std::string> differing_inputs(const MovingContact& one, const MovingContact& other) {
  return differing_entries(one.inputs, other.inputs);
}

bool same_realisation(const std::string& seeds, const std::string& others) {
  const auto split = [](const std::string& text) {
    return std::pair{text.substr(0, text.find(" on ")), text.substr(text.find(" on ") + 4)};
  };
  const auto alike = [](const std::string& a, const std::string& b) {
    return a == b || a == "-" || b == "-";
  };
  const auto [particle, plane] = split(seeds);
  const auto [other_particle, other_plane] = split(others);
  return alike(particle, other_particle) && alike(plane, other_plane);
}

const std::vector<const MotionMode*>& all_motions() {
  static const std::vector<const MotionMode*> motions{&sliding_mode(), &rolling_mode(), &torsion_mode()};
  return motions;
}

}  // namespace asperity
