#include "surfaces/readers/channels.h"

#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

std::string list_of(const std::vector<ChannelEntry>& channels) {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, channels.size()); ++i)
    list += (i ? ", " : "") + std::to_string(i) + ": '" + channels[i].name + "'" +
            (channels[i].unit.empty() ? "" : " in " + channels[i].unit);
  if (channels.size() > most) list += ", and " + std::to_string(channels.size() - most) + " more";
  return list;
}

bool sounds_like_height(const std::string& name) {
  const std::string lower = lower_case(name);
  for (const char* word : {"height", "topograph", "zsensor", "z sensor", "z height"})
    if (lower.find(word) != std::string::npos) return true;
  return false;
}

std::size_t wished_channel(const SourceFile& file, const std::vector<ChannelEntry>& channels,
                           const std::string& wish) {
  const std::string wanted = lower_case(trimmed_text(wish));
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (lower_case(channels[i].name) == wanted) return i;
  const bool is_number = !wanted.empty() && std::all_of(wanted.begin(), wanted.end(),
                                                        [](unsigned char c) { return std::isdigit(c); });
  if (is_number && wanted.size() < 6 && std::stoul(wanted) < channels.size()) return std::stoul(wanted);
  throw InputError(file.name() + " has no channel '" + wish + "'; pass the name or number of one of " +
                   list_of(channels));
}

}  // namespace

std::size_t choose_channel(const SourceFile& file, const std::vector<ChannelEntry>& channels,
                           const ReadOptions& options) {
  if (options.channel) {
    const std::size_t chosen = wished_channel(file, channels, *options.channel);
    if (!channels[chosen].is_height)
      throw InputError("channel '" + channels[chosen].name + "' of " + file.name() +
                       " holds no heights; choose one whose values are lengths among " + list_of(channels));
    return chosen;
  }
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (channels[i].is_height && sounds_like_height(channels[i].name)) return i;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (channels[i].is_height) return i;
  throw InputError(file.name() + " holds no heights, only " + list_of(channels) +
                   "; export the channel of the topography");
}

}  // namespace asperity
