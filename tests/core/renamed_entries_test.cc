#include "core/renamed_entries.h"

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::TemporaryFolder;

const std::string old_text = "subsection Interface\n  set Opening work = 0.1 J/m^2\nend\n";

}  // namespace

TEST(RenamedEntries_behaviour, are_read_under_their_present_names_with_a_hint_that_names_line_and_both) {
  const TemporaryFolder folder;
  const auto settings = read_settings(folder.write("case.prm", old_text), {"Experiment/Way back=200 nm"});
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings[0].path(), "Interface/Work of adhesion on separation");
  EXPECT_EQ(settings[1].path(), "Experiment/Return distance");
  const auto hints = hints_of_former_names(settings);
  ASSERT_EQ(hints.size(), 2u);
  EXPECT_EQ(hints[0],
            (folder.path / "case.prm").string() +
                ":2: 'Opening work' is now called 'Work of adhesion on separation'; the former name "
                "is still read");
  EXPECT_NE(hints[1].find("'Way back' is now called 'Return distance'"), std::string::npos) << hints[1];
}

TEST(RenamedEntries_behaviour, given_under_both_names_are_refused) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("case.prm", old_text +
                                   "subsection Interface\n  set Work of adhesion on separation = 0.2 "
                                   "J/m^2\nend\n");
  const std::string text = message_of<InputError>([&] { read_settings(file); });
  EXPECT_NE(text.find("case.prm:2: 'Opening work' is the former name"), std::string::npos) << text;
  EXPECT_NE(text.find("case.prm:5"), std::string::npos) << text;
}

TEST(RenamedEntries_behaviour, in_a_file_give_way_to_the_present_name_on_the_command_line) {
  const TemporaryFolder folder;
  const auto settings = read_settings(folder.write("case.prm", old_text),
                                      {"Interface/Work of adhesion on separation=0.2 J/m^2"});
  ASSERT_EQ(settings.size(), 1u);
  EXPECT_EQ(settings[0].value, "0.2 J/m^2");
  EXPECT_TRUE(hints_of_former_names(settings).empty());
}

TEST(RenamedEntries_behaviour, lead_back_to_the_name_that_the_hash_of_inputs_keeps) {
  for (const auto& entry : renamed_entries()) {
    EXPECT_EQ(present_path(entry.former), entry.present);
    EXPECT_EQ(former_path(entry.present), entry.former);
  }
  EXPECT_EQ(present_path("Particle/Radius"), "Particle/Radius");
  EXPECT_EQ(former_path("Particle/Radius"), "Particle/Radius");
}

}  // namespace asperity
