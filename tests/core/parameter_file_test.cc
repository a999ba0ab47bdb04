#include "core/parameter_file.h"

#include "core/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/utf16.h"

namespace asperity {
namespace {

using test::message_of;
using test::TemporaryFolder;

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", text);
  return message_of<InputError>([&] { read_settings(file); });
}

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

}  // namespace

TEST(ParameterFile_behaviour, reads_nested_subsections_comments_and_continued_lines) {
  const TemporaryFolder folder;
  const auto settings = read_settings(
      folder.write("case.prm",
                   "# a case\nset Title = two words # and a comment\n\nsubsection Study\r\n"
                   "  subsection Vary\n    set Experiment/Normal load = 1 mN, \\\n 2 mN\n  end\nend\n"));
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings[0].path(), "Title");
  EXPECT_EQ(settings[0].value, "two words");
  EXPECT_EQ(settings[1].section, "Study/Vary");
  EXPECT_EQ(settings[1].entry, "Experiment/Normal load");
  EXPECT_EQ(settings[1].value, "1 mN, 2 mN");
  EXPECT_EQ(settings[1].where, (folder.path / "case.prm").string() + ":6");
}

TEST(ParameterFile_behaviour, reads_the_same_from_JSON_with_the_line_of_each_entry) {
  const TemporaryFolder folder;
  const auto settings = read_settings(folder.write("case.json",
                                                   "{\n \"Particle\": {\"Radius\": \"8.5 um\",\n  \"Poisson "
                                                   "ratio\": 0.17},\n \"Output\": {\"Fields\": true}}\n"));
  ASSERT_EQ(settings.size(), 3u);
  EXPECT_EQ(settings[0].path(), "Particle/Radius");
  EXPECT_EQ(settings[1].value, "0.17");
  EXPECT_EQ(settings[1].where, (folder.path / "case.json").string() + ":3");
  EXPECT_EQ(settings[2].value, "true");
}

TEST(ParameterFile_behaviour, reads_the_JSON_that_deal_II_writes) {
  const TemporaryFolder folder;
  const auto settings = read_settings(
      folder.write("case.json",
                   R"({"Particle": {"Young_20modulus": {"value": "70 GPa", "default_value": "71 GPa",
          "pattern": "0"}}})"));
  ASSERT_EQ(settings.size(), 1u);
  EXPECT_EQ(settings[0].path(), "Particle/Young modulus");
  EXPECT_EQ(settings[0].value, "70 GPa");
}

TEST(ParameterFile_behaviour, reads_what_other_editors_save) {
  for (const std::string text : {std::string("\xEF\xBB\xBFset Title = \xC2\xB5\r\nset Seed = 3\r\n"),
                                 std::string("set Title = \xB5\rset Seed = 3\r"),
                                 test::utf16_bytes(u"set Title = µ\r\nset Seed = 3", test::Order::little)}) {
    const TemporaryFolder folder;
    const Settings settings = read_settings(folder.write("case.prm", text));
    ASSERT_EQ(settings.size(), 2u);
    EXPECT_EQ(settings[0].value, "µ");
    EXPECT_EQ(settings[1].value, "3");
  }
}

TEST(ParameterFile_behaviour, an_included_file_can_be_overridden_where_it_is_included) {
  const TemporaryFolder folder;
  folder.write("base.prm", "subsection Particle\n set Radius = 8.5 um\nend\n");
  const auto settings = read_settings(
      folder.write("case.prm", "include base.prm\nsubsection Particle\n set Radius = 9 um\nend\n"));
  ASSERT_EQ(settings.size(), 1u);
  EXPECT_EQ(settings[0].value, "9 um");
}

TEST(ParameterFile_behaviour, is_written_so_that_it_reads_back_the_same) {
  const TemporaryFolder folder;
  const Settings written{
      {"Particle", "Radius", "8.5 um", ""}, {"", "Title", "x", ""}, {"Study/Vary", "A/B", "1, 2", ""}};
  const auto read = read_settings(folder.write("case.prm", format_settings(written)));
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].path() + read[1].path() + read[2].path(), "TitleParticle/RadiusStudy/Vary/A/B");
  EXPECT_EQ(format_settings(written),
            "set Title = x\nsubsection Particle\n  set Radius = 8.5 um\nend\nsubsection Study\n  subsection "
            "Vary\n    set A/B = 1, 2\n  end\nend\n");
}

TEST(ParameterFile_behaviour, names_the_line_of_what_it_cannot_read) {
  EXPECT_CONTAINS(refusal("subsection Particle\n sett Radius = 1 um\nend\n"),
                  "case.prm:2: a line begins with");
  EXPECT_CONTAINS(refusal("subsection Particle\n sett Radius = 1 um\nend\n"), "did you mean 'set'?");
  EXPECT_CONTAINS(refusal("\nset Title\n"), "case.prm:2: 'set Title' lacks '='");
  EXPECT_CONTAINS(refusal("subsection Particle\nset Radius = 1 um\n"),
                  "inside subsection Particle, opened at");
  EXPECT_CONTAINS(refusal("end\n"), "case.prm:1: this 'end' closes no subsection");
  EXPECT_CONTAINS(refusal("set Title = a\nset Title = b\n"), "case.prm:2: Title is set in line 1 already");
  EXPECT_CONTAINS(refusal("include nothing.prm\n"), "case.prm:1: there is no file");
  EXPECT_CONTAINS(refusal("include case.prm\n"), "does one include itself?");
  EXPECT_CONTAINS(refusal(" \n"), "the file is empty");
  EXPECT_CONTAINS(refusal(std::string("\x89PNG\0\0", 6)), "binary file");
  EXPECT_CONTAINS(refusal("{\n\"Particle\": {\n"), "this is not JSON here: unexpected end of input");
  EXPECT_CONTAINS(refusal("{\"Particle\":\n {\"Radius\": [1]}}"), "case.prm:2: 'Radius' holds array");
}

TEST(ParameterFile_behaviour, takes_apart_an_override) {
  const auto setting = parse_override("Experiment/Normal load = 2 mN");
  EXPECT_EQ(setting.section, "Experiment");
  EXPECT_EQ(setting.entry, "Normal load");
  EXPECT_EQ(setting.value, "2 mN");
  EXPECT_CONTAINS(message_of<InputError>([] { parse_override("Normal load"); }), "Section/Entry=value");
}

}  // namespace asperity
