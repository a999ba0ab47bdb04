#include "paper/published.h"

#include "core/csv.h"
#include "core/error.h"
#include "paper/unit_table.h"

namespace asperity {
namespace fs = std::filesystem;

const PublishedBody& Published::body(const std::string& name) const {
  for (const auto& candidate : bodies)
    if (candidate.name == name) return candidate;
  throw InputError(folder_ + "/bodies.csv: there is no body '" + name + "'");
}

Hertz Published::hertz(const std::string& plane) const {
  return {reduced_modulus(particle().elasticity, body(plane).elasticity), radius()};
}

Uncertain Published::quoted(const std::string& name, Dimension dimension) const {
  const auto found = quoted_.find(name);
  if (found == quoted_.end()) throw InputError(folder_ + "/quoted.csv: there is no quantity '" + name + "'");
  const double factor = found->second.unit.empty() ? 1 : unit_factor(found->second.unit, dimension);
  return {found->second.number.value * factor, found->second.number.sd * factor};
}

Published read_published(const fs::path& folder) {
  Published published;
  published.folder_ = folder.string();
  const UnitTable bodies(folder / "bodies.csv"), surfaces(folder / "surfaces.csv"),
      rails(folder / "rails.csv");
  for (std::size_t row = 0; row < bodies.rows(); ++row)
    published.bodies.push_back({bodies.text("body", row),
                                bodies.text("role", row),
                                {bodies.number("youngs_modulus", Dimension::pressure, row),
                                 bodies.number("poissons_ratio", Dimension::none, row)},
                                bodies.number("radius", Dimension::length, row),
                                bodies.uncertain("rms", Dimension::length, row)});
  for (std::size_t row = 0; row < surfaces.rows(); ++row) {
    const auto of = [&](const char* name, Dimension dimension) {
      return surfaces.uncertain(name, dimension, row);
    };
    published.surfaces.push_back({surfaces.text("surface", row), of("rms", Dimension::length),
                                  of("peak_to_valley", Dimension::length), of("pull_off", Dimension::force),
                                  of("sliding_friction", Dimension::none),
                                  of("sliding_offset", Dimension::force), of("rolling_r", Dimension::none),
                                  of("rolling_r_offset", Dimension::force), of("rolling_a", Dimension::none),
                                  of("rolling_a_offset", Dimension::force)});
  }
  for (std::size_t row = 0; row < rails.rows(); ++row)
    published.rails.push_back({rails.uncertain("rail_angle", Dimension::angle, row),
                               rails.number("printed_angle", Dimension::angle, row),
                               rails.uncertain("rms", Dimension::length, row),
                               rails.uncertain("rail_friction", Dimension::none, row),
                               {rails.number("rail_offset", Dimension::force, row)}});
  const CsvTable quoted = read_csv(folder / "quoted.csv");
  const auto value = quoted.numbers("value"), sd = quoted.numbers("sd");
  for (std::size_t row = 0; row < quoted.rows.size(); ++row)
    published.quoted_[quoted.rows[row][quoted.column("quantity")]] = {
        {value[row], sd[row]}, quoted.rows[row][quoted.column("unit")]};
  return published;
}

}  // namespace asperity
