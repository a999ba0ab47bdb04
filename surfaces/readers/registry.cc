#include <algorithm>

#include "surfaces/readers/format.h"

namespace asperity {
namespace formats {
std::vector<TopographyFormat> make_all();  // generated from the files of formats/
}

const std::vector<TopographyFormat>& topography_formats() {
  static const std::vector<TopographyFormat> formats = [] {
    auto all = formats::make_all();
    const auto& others = RegisteredFormat::all();
    all.insert(all.end(), others.begin(), others.end());
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.tried < b.tried; });
    return all;
  }();
  return formats;
}

}  // namespace asperity
