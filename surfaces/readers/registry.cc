#include <algorithm>

#include "surfaces/readers/format.h"

namespace asperity {

namespace formats {
std::vector<TopographyFormat> make_all();  // generated from the files of formats/
}

namespace {

std::vector<TopographyFormat>& registered() {
  static std::vector<TopographyFormat> formats;
  return formats;
}

}  // namespace

RegisteredFormat::RegisteredFormat(TopographyFormat format) { registered().push_back(std::move(format)); }

const std::vector<TopographyFormat>& topography_formats() {
  static const std::vector<TopographyFormat> formats = [] {
    auto all = formats::make_all();
    all.insert(all.end(), registered().begin(), registered().end());
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.tried < b.tried; });
    return all;
  }();
  return formats;
}

}  // namespace asperity
