// Recordings, and instruments' own text.
#include "core/error.h"
#include "diagnosis/import/import.h"
#include "diagnosis/recording/recording_table_file.h"
#include "tests/fuzz/targets.h"

namespace asperity::fuzz {
namespace {

void check_table(const RecordingTable& table) {
  for (const auto& [channel, values] : table.columns)
    expect(values.size() == table.rows(), "columns are equally long");
  expect(table.segment.empty() || table.segment.size() == table.rows(), "each row has its segment");
}

/// Twenty-one samples of a loading, for recordings whose recording.json is fuzzed.
std::string loading() {
  std::string text = "time [s],normal_displacement [nm],normal_force [uN]\n";
  for (int i = 0; i <= 20; ++i)
    text += std::to_string(i) + "," + std::to_string(i) + "," + std::to_string(i * i) + "\n";
  return text;
}

void read_description(const std::string& bytes) {
  const FileInMemory description("recording.json", bytes), table("loading.csv", loading());
  try {
    const Recording recording = read_recording(description.folder);
    expect_utf8(recording.title);
    for (const auto& one : recording.tables) check_table(one);
  } catch (const InputError&) {
  }
}

void read_table(const std::string& bytes) {
  const FileInMemory file("loading.csv", bytes);
  try {
    RecordingTable table;
    read_table_file(file.path, table);
    check_table(table);
  } catch (const InputError&) {
  }
}

void import(const std::string& format, const std::string& bytes) {
  const FileInMemory file("scan.txt", bytes);
  ImportOptions options;
  options.format = format;
  options.radius = 1e-6;
  options.substrate_modulus = 72e9;
  options.substrate_poisson = 0.17;
  if (format == "csv")
    options.columns = {"normal_displacement [nm] = h", "normal_force [uN] = F * 2", "time [s] = t"};
  try {
    const Recording recording = import_recording(file.path, options);
    expect_utf8(recording.title);
    for (const auto& table : recording.tables) check_table(table);
  } catch (const InputError&) {
  }
}

}  // namespace

std::vector<Target> recording_targets() {
  std::vector<Target> all{{"recording_json", read_description}, {"recording_table", read_table}};
  for (const auto& format : import_formats())
    all.push_back({"import_" + format, [format](const std::string& bytes) { import(format, bytes); }});
  return all;
}

}  // namespace asperity::fuzz
