#include "diagnosis/locate/views.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace asperity {
namespace {

constexpr std::size_t most_bins = 48, samples_in_a_bin = 8;
/// A variable orders the data where its range is more than this part of its size.
constexpr double varies = 0.02;

using Variable = std::function<double(const Sample&)>;

struct NamedVariable {
  std::string name;
  Variable value;
};

std::vector<NamedVariable> variables_for(Motion mode, bool trace, bool hold, bool force_drives) {
  const NamedVariable displacement{"normal_displacement",
                                   [](const Sample&s) { return s.normal_displacement; }},
      load{"normal_force", [](const Sample&s) { return s.normal_force; }},
      path{"lateral_displacement", [](const Sample&s) { return s.lateral_displacement; }},
      time{"time", [](const Sample&s) { return s.hold_time; }},
      cycle{"cycle", [](const Sample&s) { return s.cycle; }},
      speed{"speed", [](const Sample&s) { return s.speed; }},
      radius{"radius", [](const Sample&s) { return s.radius; }},
      roughness{"rms_roughness", [](const Sample&s) { return s.rms_roughness; }},
      angle{"rail_angle", [](const Sample&s) { return s.rail_angle; }};
  std::vector<NamedVariable> list;
  if (hold) return {time, cycle};
  if (mode == Motion::normal)
    list.push_back(force_drives ? load : displacement);
  else if (trace)
    list = {path, load};
  else
    list = {load};
  if (trace) list.push_back(cycle);
  if (mode != Motion::normal) list.push_back(speed);
  if (mode != Motion::normal) list.insert(list.end(), {radius, roughness, angle});
  return list;
}

/// Bins of about equal count; values that are few have a bin each.
std::vector<Bin> binned(const Samples& samples, std::vector<std::size_t> members, const Variable& value,
                        bool trace) {
  std::set<double> distinct;
  for (const std::size_t i : members) {
    distinct.insert(value(samples.list[i]));
    if (distinct.size() > most_bins) break;
  }
  const double low = *distinct.begin(), high = *distinct.rbegin();
  if (distinct.size() < 2 || high - low <= varies * std::max(-low, high)) return {};
  std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
    return value(samples.list[a]) < value(samples.list[b]);
  });
  std::vector<Bin> bins;
  const std::size_t fewest = trace ? samples_in_a_bin : 1;
  if (distinct.size() <= most_bins && members.size() >= fewest * distinct.size()) {
    for (const std::size_t i : members) {
      const double v = value(samples.list[i]);
      if (bins.empty() || v != bins.back().to) bins.push_back({v, v, {}});
      bins.back().samples.push_back(i);
    }
    return bins;
  }
  const std::size_t count = std::clamp<std::size_t>(members.size() / fewest, 1, most_bins);
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t from = b * members.size() / count, to = (b + 1) * members.size() / count;
    Bin bin{value(samples.list[members[from]]), value(samples.list[members[to - 1]]), {}};
    bin.samples.assign(members.begin() + static_cast<long>(from), members.begin() + static_cast<long>(to));
    bins.push_back(std::move(bin));
  }
  return bins;
}

}  // namespace

std::vector<View> views_of(const Samples& samples, const Experiment& experiment) {
  std::vector<View> views;
  for (std::size_t t = 0; t < samples.table_names.size(); ++t) {
    std::map<int, std::vector<std::size_t>> by_segment;
    std::vector<std::size_t> all;
    bool trace = false, force_drives = false;
    for (const auto& run : samples.runs) {
      if (run.table != t) continue;
      trace = trace || !run.independent_rows;
      force_drives = force_drives || run.response_is_displacement;
      for (std::size_t i = run.begin; i < run.end; ++i)
        if (samples.list[i].counts) {
          by_segment[samples.list[i].segment].push_back(i);
          all.push_back(i);
        }
    }
    if (all.empty()) continue;
    views.push_back({t, "", "", {{0, 0, all}}});
    for (const auto& [segment, members] : by_segment) {
      const std::string& name = samples.segment_names[static_cast<std::size_t>(segment)];
      for (const auto& variable : variables_for(experiment.mode, trace, name == "hold", force_drives)) {
        View view{t, name, variable.name, binned(samples, members, variable.value, trace)};
        if (!view.bins.empty()) views.push_back(std::move(view));
      }
    }
  }
  return views;
}

}  // namespace asperity
