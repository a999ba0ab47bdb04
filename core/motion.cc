#include "core/motion.h"

#include <utility>

namespace asperity {
namespace {

constexpr std::pair<Motion, const char*> names[] = {
    {Motion::normal, "normal"},   {Motion::sliding, "sliding"}, {Motion::rolling, "rolling"},
    {Motion::torsion, "torsion"}, {Motion::rail, "rail"},       {Motion::program, "program"}};

}  // namespace

std::string name_of(Motion motion) {
  for (const auto& [known, name] : names)
    if (known == motion) return name;
  return "";
}

std::optional<Motion> motion_named(const std::string& written) {
  for (const auto& [known, name] : names)
    if (written == name) return known;
  return std::nullopt;
}

}  // namespace asperity
