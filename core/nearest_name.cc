#include "core/nearest_name.h"

#include <algorithm>
#include <cctype>

#include "core/joined.h"

namespace asperity {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

int edit_distance(const std::string& first, const std::string& second) {
  const std::string a = lower(first), b = lower(second);
  std::vector<std::vector<int>> distance(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) distance[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) distance[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      distance[i][j] = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
    }
  return distance[a.size()][b.size()];
}

std::string nearest_name(const std::string& written, const std::vector<std::string>& names) {
  std::string nearest;
  int least = 0;
  for (const auto& name : names) {
    const int distance = edit_distance(written, name);
    if (nearest.empty() || distance < least) {
      nearest = name;
      least = distance;
    }
  }
  // More than half of the letters wrong: it is another word.
  const int longest = static_cast<int>(std::max(written.size(), nearest.size()));
  return 2 * least <= longest ? nearest : "";
}

std::string did_you_mean(const std::string& written, const std::vector<std::string>& names,
                         const std::string& otherwise) {
  const std::string meant = nearest_name(written, names);
  return meant.empty() ? otherwise : "did you mean '" + meant + "'?";
}

std::string did_you_mean(const std::string& written, const std::vector<std::string>& names) {
  return did_you_mean(written, names, "there are " + joined(names, ", "));
}

}  // namespace asperity
