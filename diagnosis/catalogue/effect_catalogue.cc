#include <algorithm>

#include "core/error.h"
#include "core/nearest_name.h"
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace effects {
std::vector<std::unique_ptr<Effect>> make_all();  // generated from the files of effects/
}

const std::vector<std::unique_ptr<Effect>>& effect_catalogue() {
  static const std::vector<std::unique_ptr<Effect>> list = [] {
    auto all = effects::make_all();
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a->id() < b->id(); });
    return all;
  }();
  return list;
}

const Effect& effect_of(const std::string& id) {
  std::vector<std::string> names;
  for (const auto& effect : effect_catalogue()) {
    if (effect->id() == id) return *effect;
    names.push_back(effect->id());
  }
  const std::string meant = nearest_name(id, names);
  throw InputError("there is no effect '" + id + "'" +
                   (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
}

}  // namespace asperity
