#include "core/topography_spec.h"

#include <limits>

#include "core/entry_call.h"

namespace asperity {

TopographySpec::TopographySpec(const std::string& text) : text_(text) {
  if (without_outer_blanks(text) == "smooth") return;
  if (is_entry_call(text, "generated"))
    surface_ = parse_generator(text);
  else
    surface_ = parse_scan(text);
}

std::string TopographySpec::canonical() const {
  if (is_smooth()) return "smooth";
  return scan() ? scan()->text() : generator()->text();
}

std::string TopographySpec::family() const {
  return generator() ? generator()->text_without_seed() : canonical();
}

double TopographySpec::rms() const {
  if (is_smooth()) return 0;
  return generator() ? generator()->spectrum.rms : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace asperity
