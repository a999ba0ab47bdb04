// Registries: what is registered is listed by name and found by name.
#include "core/registry.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace asperity {
using test::message_of;
namespace {

struct Tool {
  std::string name;
  int teeth = 0;
};
using MakeTool = Tool (*)();
std::string name_of(const Tool& tool) { return tool.name; }

const Registered<MakeTool> saw{[] { return Tool{"saw", 40}; }};
const Registered<MakeTool> file{[] { return Tool{"file", 900}; }};

TEST(Registry_behaviour, what_the_build_found_and_what_was_registered_are_one_list_by_name) {
  const auto tools = with_registered_makers(std::vector<Tool>{{"rasp", 60}}, name_of);
  ASSERT_EQ(tools.size(), 3u);
  EXPECT_EQ(tools[0].name, "file");
  EXPECT_EQ(tools[1].name, "rasp");
  EXPECT_EQ(tools[2].teeth, 40);
}

TEST(Registry_behaviour, two_of_one_name_are_refused) {
  EXPECT_THROW(with_registered_makers(std::vector<Tool>{{"saw", 1}}, name_of), std::logic_error);
}

TEST(Registry_behaviour, an_unknown_name_is_told_what_was_meant_or_what_there_is) {
  const std::vector<Tool> tools{{"rasp", 60}, {"hammer", 0}};
  EXPECT_EQ(entry_named(tools, "rasp", name_of, "there is no tool").teeth, 60);
  EXPECT_EQ(message_of<InputError>([&] { entry_named(tools, "hamer", name_of, "there is no tool"); }),
            "there is no tool 'hamer'; did you mean 'hammer'?");
  EXPECT_EQ(message_of<InputError>([&] { entry_named(tools, "xyz", name_of, "there is no tool"); }),
            "there is no tool 'xyz'; there are rasp, hammer");
}

}  // namespace
}  // namespace asperity
