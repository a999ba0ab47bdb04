#include "app/study.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>

#include "app/case_file.h"
#include "app/study_entries.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "core/topography_spec.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Seeds of successive realisations lie this far apart, so that the few seeds a case names do not meet.
constexpr std::uint64_t seeds_apart = 1000;
constexpr std::size_t longest_folder_part = 40;

int count_of(const Setting& setting, int least) {
  char* end = nullptr;
  const long value = std::strtol(setting.value.c_str(), &end, 10);
  if (setting.value.empty() || *end != '\0' || value < least || value > 1000000)
    throw InputError(setting.where + ": " + setting.path() + ": '" + setting.value +
                     "' is not a whole number, " + std::to_string(least) + " or more");
  return static_cast<int>(value);
}

/// A label as part of a folder's name.
std::string folder_part(const std::string& label, std::size_t index) {
  std::string name;
  for (const char c : label) {
    const bool is_kept = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '+' ||
                         (c == '.' && !name.empty());  // ".." is a folder already
    if (is_kept)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() || name.size() > longest_folder_part ? "value" + std::to_string(index + 1) : name;
}

/// Gives every generated topography the seed of a realisation; false if there is none.
bool apply_realisation(Settings& settings, int realisation) {
  bool any = false;
  for (auto& setting : settings) {
    if (setting.entry != "Topography") continue;
    const TopographySpec topography(setting.value);
    if (!topography.generator()) continue;
    any = true;
    if (realisation == 1) continue;
    GeneratorParameters generator = *topography.generator();
    generator.seed += seeds_apart * static_cast<std::uint64_t>(realisation - 1);
    setting.value = generator.text();
  }
  return any;
}

/// The settings of a study after those of --set; one of an entry that is varied replaces its values.
Settings overridden(Settings settings, const std::vector<std::string>& overrides) {
  for (const auto& text : overrides) {
    Setting setting = parse_override(text);
    const Setting varied{"Study/Vary", setting.path(), setting.value, setting.where};
    const bool is_varied = std::any_of(settings.begin(), settings.end(),
                                       [&](const Setting& s) { return s.path() == varied.path(); });
    override_setting(settings, is_varied ? varied : setting);
  }
  return settings;
}

class StudyReader {
 public:
  explicit StudyReader(const fs::path& file) { study_.file = file; }

  Study read(const std::vector<std::string>& overrides) {
    for (const auto& setting : overridden(read_settings(study_.file), overrides)) take(setting);
    if (!variants_.choices.empty()) axes_.push_back(variants_);
    merge_base();
    for (const auto& axis : axes_) name_axis(axis);
    check_realisations_of_variants();
    for (int realisation = 1; realisation <= most_realisations(); ++realisation) add_cases({}, realisation);
    return study_;
  }

 private:
  void take(const Setting& setting) {
    if (setting.section == "Study/Vary") {
      axes_.push_back(read_vary(setting, study_.file));
    } else if (setting.section == "Study/Variants") {
      variants_.where = setting.where;
      variants_.choices.push_back(read_variant(setting, study_.file));
    } else if (setting.section == "Study/Realisations of variants") {
      of_variants_.push_back({setting, count_of(setting, 1)});
    } else if (setting.section == "Study") {
      take_study_entry(setting);
    } else if (setting.section.rfind("Study/", 0) == 0) {
      throw InputError(setting.where +
                       ": subsection Study has Vary, Variants and Realisations of variants, not '" +
                       setting.section.substr(6) + "'");
    } else {
      check_entry_exists(setting);
      own_.push_back(setting);
      make_topography_absolute(own_.back(), study_.file);
    }
  }

  void take_study_entry(const Setting& setting) {
    if (setting.entry == "Base case") {
      base_ = study_.file.parent_path() / setting.value;
      if (!fs::exists(base_))
        throw InputError(setting.where + ": there is no base case '" + base_.string() + "'");
    } else if (setting.entry == "Realisations") {
      study_.realisations = count_of(setting, 1);
    } else if (setting.entry == "Parallel cases") {
      study_.parallel_cases = count_of(setting, 0);
    } else if (setting.entry == "Name of variants") {
      variants_.path = setting.value;
    } else {
      throw InputError(setting.where + ": there is no entry '" + setting.entry + "' in subsection Study; " +
                       did_you_mean(setting.entry,
                                    {"Base case", "Realisations", "Parallel cases", "Name of variants"},
                                    "it has Base case, Realisations, Parallel cases, Name of variants "
                                    "and the subsections Vary and Variants"));
    }
  }

  void check_realisations_of_variants() const {
    std::vector<std::string> labels;
    for (const auto& choice : variants_.choices) labels.push_back(choice.label);
    for (const auto& [setting, count] : of_variants_) {
      if (std::find(labels.begin(), labels.end(), setting.entry) != labels.end()) continue;
      throw InputError(setting.where + ": there is no variant '" + setting.entry + "'; " +
                       did_you_mean(setting.entry, labels, "name one of subsection Variants"));
    }
  }

  /// Of a variant by its label, the last axis where there are variants.
  int realisations_of(const std::vector<std::string>& labels) const {
    for (const auto& [setting, count] : of_variants_)
      if (!labels.empty() && setting.entry == labels.back()) return count;
    return study_.realisations;
  }
  int most_realisations() const {
    int most = study_.realisations;
    for (const auto& [setting, count] : of_variants_) most = std::max(most, count);
    return most;
  }

  void merge_base() {
    if (!base_.empty())
      for (auto setting : read_settings(base_)) {
        check_entry_exists(setting);
        make_topography_absolute(setting, base_);
        merged_.push_back(setting);
      }
    for (const auto& setting : own_) override_setting(merged_, setting);
    for (const auto& setting : merged_)
      if (setting.path() == "Title") study_.title = setting.value;
  }

  void name_axis(const WrittenAxis& axis) {
    const auto short_name = [](const std::string& path) { return path.substr(path.rfind('/') + 1); };
    const bool shared = std::count_if(axes_.begin(), axes_.end(), [&](const WrittenAxis& other) {
                          return short_name(other.path) == short_name(axis.path);
                        }) > 1;
    StudyAxis named{shared ? axis.path : short_name(axis.path), {}};
    std::set<std::string> folders;
    for (std::size_t i = 0; i < axis.choices.size(); ++i) {
      named.labels.push_back(axis.choices[i].label);
      if (!folders.insert(folder_part(axis.choices[i].label, i)).second)
        throw InputError(
            axis.where + ": two values of " + axis.path + " are called '" + axis.choices[i].label +
            "' or give the same folder name; write a label before each, as in 'smooth one: value'");
    }
    study_.axes.push_back(named);
  }

  /// All cells of the matrix whose first indices are `chosen`.
  void add_cases(std::vector<std::size_t> chosen, int realisation) {
    if (chosen.size() == axes_.size()) {
      add_case(chosen, realisation);
      return;
    }
    const std::size_t choices = axes_[chosen.size()].choices.size();
    chosen.push_back(0);
    for (; chosen.back() < choices; ++chosen.back()) add_cases(chosen, realisation);
  }

  void add_case(const std::vector<std::size_t>& chosen, int realisation) {
    StudyCase cell;
    cell.settings = merged_;
    cell.realisation = realisation;
    std::string title = study_.title;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const StudyChoice& choice = axes_[i].choices[chosen[i]];
      for (const auto& setting : choice.settings) override_setting(cell.settings, setting);
      cell.labels.push_back(choice.label);
      cell.name += (cell.name.empty() ? "" : "-") + folder_part(choice.label, chosen[i]);
      title += (title.empty() ? "" : ", ") + choice.label;
    }
    // Realisations differ by their generated surfaces alone; without any there is one.
    if (realisation > realisations_of(cell.labels)) return;
    if (!apply_realisation(cell.settings, realisation) && realisation > 1) return;
    if (most_realisations() > 1) {
      cell.name += (cell.name.empty() ? "r" : "-r") + std::to_string(realisation);
      title += (title.empty() ? "" : ", ") + std::string("realisation ") + std::to_string(realisation);
    }
    if (cell.name.empty()) cell.name = "case";
    override_setting(cell.settings, {"", "Title", title, study_.file.string()});
    cell.settings = complete_settings(cell.settings, study_.file);
    study_.cases.push_back(std::move(cell));
  }

  struct RealisationsOfVariant {
    Setting setting;
    int count = 0;
  };

  Study study_;
  std::vector<RealisationsOfVariant> of_variants_;
  fs::path base_;
  Settings own_, merged_;
  std::vector<WrittenAxis> axes_;
  WrittenAxis variants_{"Variant", "", {}};
};

}  // namespace

const char* const study_example =
    "subsection Study\n"
    "  set Base case        = base.prm     # optional; the study's own case sections override it\n"
    "  set Realisations     = 4            # seeds of each generated topography\n"
    "  set Parallel cases   = 2            # at the same time; 0 or nothing: one per core\n"
    "  subsection Vary                     # each value with each value of the others; \";\" adds entries to "
    "a value\n"
    "    set Experiment/Normal load = 300 uN, 1 mN\n"
    "    set Substrate/Topography   = flat: smooth, rough: generated(rms=1.5 nm)\n"
    "  end\n"
    "  set Name of variants = Material     # optional\n"
    "  subsection Variants                 # named groups of entries, varied together\n"
    "    set elastic  = Particle/Yield stress=inf; Substrate/Yield stress=inf\n"
    "    set yielding =\n"
    "  end\n"
    "  subsection Realisations of variants # of one variant more, or fewer, than of the others\n"
    "    set elastic = 8\n"
    "  end\n"
    "end\n";

Study read_study(const fs::path& file, const std::vector<std::string>& overrides) {
  return StudyReader(file).read(overrides);
}

}  // namespace asperity
