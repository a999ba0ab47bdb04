#include "surfaces/readers/channels.h"

#include "tests/support/temporary_folder.h"
#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

const SourceFile file{"a.spm", ""};

ReadOptions wishing(const std::string& channel) {
  ReadOptions options;
  options.channel = channel;
  return options;
}

}  // namespace

TEST(Channels_behaviour, the_first_that_sounds_like_heights_is_taken_else_the_first_of_lengths) {
  EXPECT_EQ(choose_channel(
                file, {{"Phase", "deg", false}, {"Deflection", "nm", true}, {"My Height", "nm", true}}, {}),
            2u);
  EXPECT_EQ(
      choose_channel(file, {{"Height", "V", false}, {"Deflection", "nm", true}, {"Error", "nm", true}}, {}),
      1u);
  for (const std::string name : {"HEIGHT", "Topography", "ZSensor", "Z sensor"})
    EXPECT_EQ(choose_channel(file, {{"Error", "nm", true}, {name, "nm", true}}, {}), 1u) << name;
}

TEST(Channels_behaviour, a_wish_is_a_name_in_any_case_or_a_number) {
  const std::vector<ChannelEntry> channels{
      {"1", "m", true}, {"Height", "m", true}, {"height", "m", true}, {"Phase", "deg", false}};
  EXPECT_EQ(choose_channel(file, channels, wishing(" HEIGHT ")), 1u);
  EXPECT_EQ(choose_channel(file, channels, wishing("1")), 0u);  // a name wins
  EXPECT_EQ(choose_channel(file, channels, wishing("2")), 2u);
  for (const std::string wish : {"4", "-1", "999999", "", "2.0"})
    EXPECT_SAYS(message_of<InputError>([&] { choose_channel(file, channels, wishing(wish)); }),
                "has no channel '" + wish + "'");
  EXPECT_EQ(message_of<InputError>([&] { choose_channel(file, channels, wishing("3")); }),
            "channel 'Phase' of 'a.spm' holds no heights; choose one whose values are lengths among 0: '1' "
            "in m, 1: 'Height' in m, "
            "2: 'height' in m, 3: 'Phase' in deg");
}

TEST(Channels_behaviour, twenty_are_listed_and_the_rest_counted) {
  std::vector<ChannelEntry> channels(20, {"a", "", false});
  EXPECT_EQ(message_of<InputError>([&] { choose_channel(file, channels, {}); }).find("more"),
            std::string::npos);
  channels.resize(23, {"b", "V", false});
  const std::string message = message_of<InputError>([&] { choose_channel(file, channels, {}); });
  EXPECT_SAYS(message, "19: 'a', and 3 more; export the channel of the topography");
  EXPECT_EQ(message.find("'b'"), std::string::npos);
}
