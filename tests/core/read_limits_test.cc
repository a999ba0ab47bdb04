// What text files may not do: nest without end, include each other without end, or cost many times their
// size.
#include "core/read_limits.h"

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/json_text.h"
#include "core/motion_program.h"
#include "core/parameter_file.h"
#include "tests/support/peak_memory.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::ChildOutcome;
using test::measured_in_child;
using test::message_of;
using test::TemporaryFolder;

constexpr std::uint64_t MiB = 1u << 20, stated_multiple = 64;

std::string repeated(const std::string& piece, std::size_t times) {
  std::string text;
  while (times-- > 0) text += piece;
  return text;
}

std::string settings_refusal(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", text);
  EXPECT_EQ(test::in_child([&] { read_settings(file); }).end, ChildOutcome::End::refused);
  return message_of<InputError>([&] { read_settings(file); });
}

#define EXPECT_TEXT_HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text).substr(0, 300)

TEST(LimitsOfJson_analytic, nesting_ends_at_64_levels_with_the_line_where_it_passes_them) {
  EXPECT_TRUE(parse_json(repeated("[", 64) + repeated("]", 64), "a.json").is_array());
  const std::string deeper = "\n" + repeated("[", 65) + repeated("]", 65);
  EXPECT_EQ(
      message_of<InputError>([&] { parse_json(deeper, "a.json"); }),
      "a.json:2: objects and lists are nested more than 64 deep; no file of asperity is: write it again");
  EXPECT_TRUE(json_if_valid(deeper).is_discarded());
  const std::string objects = repeated("{\"a\":", 300000) + "0" + repeated("}", 300000);
  EXPECT_THROW(parse_json(objects, "a.json"), InputError);
}

TEST(LimitsOfJson_analytic, brackets_in_texts_and_side_by_side_are_no_nesting) {
  EXPECT_EQ(
      parse_json("{\"a\": \"" + repeated("[{", 100) + "\\\"[\"}", "a.json")["a"].get<std::string>().size(),
      202u);
  EXPECT_EQ(parse_json("[" + repeated("[],", 1000) + "0]", "a.json").size(), 1001u);
}

TEST(LimitsOfJson_analytic, a_number_beyond_any_double_is_refused_as_input) {
  EXPECT_TEXT_HAS(message_of<InputError>([] { parse_json("{\"a\": 1e999}", "a.json"); }),
                  "a.json: it holds a number beyond");
}

TEST(LimitsOfJson_analytic, memory_stays_below_the_stated_multiple) {
  const std::string lists = "[" + repeated("[],", MiB / 3) + "0]";
  const ChildOutcome outcome = measured_in_child([&] { parse_json(lists, "a.json"); });
  EXPECT_EQ(outcome.end, ChildOutcome::End::done);
  EXPECT_LT(outcome.peak_bytes, stated_multiple * lists.size());
}

TEST(LimitsOfParameterFiles_analytic, nesting_is_refused_in_both_forms) {
  EXPECT_TEXT_HAS(settings_refusal(repeated("{\"a\":", 100000) + "0" + repeated("}", 100000)),
                  "case.prm:1: objects and lists are nested more than 64 deep");
  EXPECT_TEXT_HAS(settings_refusal(repeated("subsection a\n", 60000)),
                  "case.prm:65: subsections stand in each other more than 64");
}

TEST(LimitsOfParameterFiles_analytic, files_that_include_each_other_twice_end) {
  const TemporaryFolder folder;
  for (int i = 0; i < 14; ++i)
    folder.write("a" + std::to_string(i), repeated("include a" + std::to_string(i + 1) + "\n", 3));
  folder.write("a14", "set A = 1\n");
  EXPECT_TEXT_HAS(message_of<InputError>([&] { read_settings(folder.path / "a0"); }),
                  "more than 256 files are included");
}

TEST(LimitsOfParameterFiles_analytic, long_lines_and_files_are_refused) {
  EXPECT_TEXT_HAS(settings_refusal("set A = " + std::string(300000, 'x') + "\n"),
                  "case.prm:1: this line is longer than 262144");
  EXPECT_TEXT_HAS(settings_refusal("# a case\nset A = 1 \\\n" + repeated("aaaaaaaaaaaaaaaa \\\n", 20000)),
                  "case.prm:2: this line is longer");
  EXPECT_TEXT_HAS(settings_refusal(repeated("# a comment\n", 100000)), "more than a parameter file has");
}

TEST(LimitsOfTables_analytic, memory_stays_below_the_stated_multiple) {
  const TemporaryFolder folder;
  const std::string cells = "a,b\n" + repeated(",\n", MiB / 2);
  const auto file = folder.write("history.csv", cells);
  const ChildOutcome outcome = measured_in_child([&] { read_csv(file); });
  EXPECT_EQ(outcome.end, ChildOutcome::End::done);
  EXPECT_LT(outcome.peak_bytes, stated_multiple * cells.size());
  const auto wide = folder.write("wide.csv", "a\n" + std::string(MiB, ','));
  EXPECT_TEXT_HAS(message_of<InputError>([&] { read_csv(wide); }),
                  "wide.csv:2: this line is longer than 262144 characters");
}

TEST(LimitsOfPrograms_analytic, a_megabyte_of_motions_is_refused) {
  const std::string text(MiB, '1');
  EXPECT_EQ(test::in_child([&] { parse_motion_program("roll " + text + " mrad in 3 steps"); }).end,
            ChildOutcome::End::refused);
  EXPECT_TEXT_HAS(message_of<InputError>([&] { parse_motion_program("roll " + text); }),
                  "at most 10000 characters");
}

TEST(LimitsOfFiles_analytic, what_lies_beyond_4_GiB_or_is_a_device_is_not_read) {
  const TemporaryFolder folder;
  const auto sparse = folder.write("sparse.txt", "1");
  std::filesystem::resize_file(sparse, read_limits::largest_file + 1);
  EXPECT_TEXT_HAS(message_of<InputError>([&] { read_file(sparse); }),
                  "holds more than the 4 GiB that are read of one file");
  EXPECT_TEXT_HAS(message_of<InputError>([] { read_file("/dev/zero"); }), "is a device, not a file");
}

}  // namespace
}  // namespace asperity
