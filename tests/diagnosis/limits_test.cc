// Recordings and instruments' text that cost more than their size.
#include "core/error.h"
#include "diagnosis/import/import.h"
#include "diagnosis/import/instrument_text.h"
#include "diagnosis/recording/recording_table_file.h"
#include "tests/support/peak_memory.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::ChildOutcome;
using test::message_of;
using test::TemporaryFolder;

constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;  // for a file of a megabyte: docs/surfaces.md

TEST(LimitsOfRecordings_analytic, json_nested_300000_deep_is_refused) {
  const TemporaryFolder folder;
  std::string nested;
  for (int i = 0; i < 300000; ++i) nested += "{\"a\":";
  nested += "0" + std::string(300000, '}');
  folder.write("recording.json", nested);
  EXPECT_EQ(test::in_child([&] { read_recording(folder.path); }).end, ChildOutcome::End::refused);
  EXPECT_NE(message_of<InputError>([&] {
              read_recording(folder.path);
            }).find("recording.json:1: objects and lists are nested"),
            std::string::npos);
}

TEST(LimitsOfRecordings_analytic, a_line_of_a_million_commas_is_refused) {
  const TemporaryFolder folder;
  const auto file = folder.write("loading.csv", std::string(1u << 20, ','));
  const auto read = [&] {
    RecordingTable table;
    read_table_file(file, table);
  };
  test::expect_refused_within(test::measured_in_child(read), most_bytes);
  EXPECT_NE(message_of<InputError>(read).find("loading.csv:1: this line is longer than 262144 characters"),
            std::string::npos);
}

TEST(LimitsOfImport_analytic, a_megabyte_of_empty_lines_or_of_commas_stays_within_the_stated_multiple) {
  const TemporaryFolder folder;
  const auto lines = folder.write("empty.txt", std::string(1u << 20, '\n'));
  const ChildOutcome outcome = test::measured_in_child([&] { read_instrument_text(lines); });
  EXPECT_EQ(outcome.end, ChildOutcome::End::done);
  EXPECT_LT(outcome.peak_bytes, most_bytes);
  const auto commas = folder.write("commas.txt", std::string(1u << 20, ','));
  test::expect_refused_within(test::measured_in_child([&] { import_recording(commas, {}); }), most_bytes);
}

TEST(LimitsOfImport_analytic, a_format_that_is_asked_for_and_not_there_is_refused) {
  const TemporaryFolder folder;
  const auto empty = folder.write("empty.txt", "");
  for (const std::string& format : import_formats()) {
    ImportOptions options;
    options.format = format;
    EXPECT_EQ(test::in_child([&] { import_recording(empty, options); }).end, ChildOutcome::End::refused)
        << format;
  }
}

}  // namespace
}  // namespace asperity
