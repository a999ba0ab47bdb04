#include "core/registry.h"
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace effects {
std::vector<std::unique_ptr<Effect>> make_all();  // generated from the files of effects/
}
namespace {
std::string id_of(const std::unique_ptr<Effect>& effect) { return effect->id(); }
}  // namespace

const std::vector<std::unique_ptr<Effect>>& effect_catalogue() {
  static const auto list = with_registered_makers(effects::make_all(), id_of);
  return list;
}

const Effect& effect_of(const std::string& id) {
  return *entry_named(effect_catalogue(), id, id_of, "there is no effect");
}

}  // namespace asperity
