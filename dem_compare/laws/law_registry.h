// The reduced laws by name: equation, source, parameters with units and bounds, and where each law stops being valid.
// A law registers itself at the end of its own header, so that factory, limits and manual page cannot drift apart;
// every header of this folder is found by the build, and a new law touches no other file.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

struct LawParameter {
  std::string name, unit, meaning;
  double low = 0, high = std::numeric_limits<double>::infinity();  ///< admissible values, both ends included
};

struct LawDescription {
  std::string name;      ///< "jkr"
  std::string mode;      ///< "normal", "sliding", "rolling", "torsion" or "viscous"
  std::string equation, source, validity;
  std::vector<LawParameter> parameters;
};

/// All laws, by mode and name.
std::vector<LawDescription> reduced_laws();
/// Throws InputError with the nearest name.
LawDescription reduced_law(const std::string& name);
/// The manual page of all laws in Markdown.
std::string reduced_laws_manual();

namespace law_registry_detail {
void add(const LawDescription& description);
std::size_t index_of(const LawDescription& description, const std::string& parameter);
void check(const LawDescription& description, std::size_t parameter, double value);
}  // namespace law_registry_detail

/// A parameter and the member of the law that holds it.
template <class Law>
struct LawField {
  LawParameter parameter;
  double Law::* member;
};

/// The registration of one law; reads and sets its parameters by name.
template <class Law>
class LawEntry {
 public:
  LawEntry(LawDescription description, const std::vector<LawField<Law>>& fields) : description_(std::move(description)) {
    for (const auto& field : fields) {
      description_.parameters.push_back(field.parameter);
      members_.push_back(field.member);
    }
    law_registry_detail::add(description_);
  }
  const LawDescription& description() const { return description_; }
  /// Throws InputError for an unknown name.
  double get(const Law& law, const std::string& name) const {
    return law.*members_[law_registry_detail::index_of(description_, name)];
  }
  /// Throws InputError for an unknown name or a value out of bounds.
  void set(Law& law, const std::string& name, double value) const {
    const std::size_t index = law_registry_detail::index_of(description_, name);
    law_registry_detail::check(description_, index, value);
    law.*members_[index] = value;
  }
  /// Throws InputError for the first parameter out of bounds.
  void check(const Law& law) const {
    for (std::size_t i = 0; i < members_.size(); ++i) law_registry_detail::check(description_, i, law.*members_[i]);
  }

 private:
  LawDescription description_;
  std::vector<double Law::*> members_;
};

}  // namespace asperity
