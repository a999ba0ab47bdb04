#include "fem/output/checkpoint.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_text.h"
#include "core/output_folder.h"
#include "core/sha256.h"
#include "fem/output/added_column.h"

namespace asperity::fem {
namespace {

namespace fs = std::filesystem;

template <typename Element>
void put(std::string& bytes, const std::vector<Element>& values) {
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(Element));
}

template <typename Element>
void take(const std::string& bytes, std::size_t& at, std::vector<Element>& values) {
  std::uint64_t count = 0;
  const auto require = [&](std::uint64_t length) {
    if (length > bytes.size() - at)
      throw WorkError("the checkpoint is cut off; solve again with --overwrite");
  };
  require(sizeof count);
  std::memcpy(&count, bytes.data() + at, sizeof count);
  at += sizeof count;
  if (count > bytes.size()) require(bytes.size() + 1);
  require(count * sizeof(Element));
  values.resize(count);
  std::memcpy(values.data(), bytes.data() + at, count * sizeof(Element));
  at += count * sizeof(Element);
}

/// Hands on every number of a checkpoint: written and read by this one list.
template <typename AnyCheckpoint, typename Do>
void each_number(AnyCheckpoint& c, Do&& on) {
  on(c.load), on(c.wall_time);
  auto& s = c.stiffness;
  for (auto* value : {&s.far_field, &s.lateral_far_field, &s.normal, &s.lateral, &s.torsion}) on(*value);
  auto& i = c.interface;
  on(i.time), on(i.approach);
  on(c.path.target), on(c.path.target_before);
  for (auto& part : c.parts) on(part.low), on(part.high);
  for (auto* motion : {&i.motion, &i.coupling.frames, &c.path.motion})
    on(motion->x), on(motion->y), on(motion->spin), on(motion->roll);
  on(i.coupling.elastic.x), on(i.coupling.elastic.y), on(i.coupling.elastic.turn);
}

/// The same of its lists.
template <typename AnyCheckpoint, typename Do>
void each_list(AnyCheckpoint& c, Do&& on) {
  on(c.displacement), on(c.history), on(c.kept);
  auto& i = c.interface;
  on(i.multiplier), on(i.shear[0]), on(i.shear[1]), on(i.friction_history), on(i.bonded);
  on(c.path.displacement), on(c.path.multiplier), on(c.path.shear[0]), on(c.path.shear[1]);
}

/// Of a row.
std::size_t column_count() { return history_columns().size() + added_columns().size(); }

std::string part_of(const Checkpoint& c) {
  std::string bytes;
  std::vector<double> numbers, rows;
  each_number(c, [&](double number) { numbers.push_back(number); });
  for (const auto& record : c.records) {
    for (const auto& column : history_columns()) rows.push_back(record.*column.of_row);
    rows.insert(rows.end(), record.added.begin(), record.added.end());
  }
  put(bytes, numbers);
  put(bytes, rows);
  each_list(c, [&](const auto& list) { put(bytes, list); });
  return bytes;
}

Checkpoint checkpoint_of(const std::string& bytes) {
  Checkpoint c;
  std::size_t at = 0, next = 0, expected = 0;
  std::vector<double> numbers, rows;
  take(bytes, at, numbers);
  each_number(c, [&](double) { ++expected; });
  if (numbers.size() != expected) throw WorkError("the checkpoint is damaged; solve again with --overwrite");
  each_number(c, [&](double& number) { number = numbers[next++]; });
  take(bytes, at, rows);
  const auto& columns = history_columns();
  for (auto row = rows.begin(); rows.end() - row >= static_cast<std::ptrdiff_t>(column_count());) {
    HistoryRow& record = c.records.emplace_back();
    for (const auto& column : columns) record.*column.of_row = *row++;
    for (std::size_t i = 0; i < added_columns().size(); ++i) record.added.push_back(*row++);
  }
  each_list(c, [&](auto& list) { take(bytes, at, list); });
  return c;
}

/// To be raised with every change of what a checkpoint holds.
constexpr const char* format = "asperity-checkpoint/10";

std::string part_name(int step, int rank) {
  return "step_" + std::to_string(step) + "_rank_" + std::to_string(rank) + ".bin";
}

/// What the manifest says of a part.
nlohmann::json description(const std::string& name, const std::string& bytes) {
  return {{"file", name}, {"bytes", bytes.size()}, {"sha256", sha256(bytes)}};
}

/// One text without blanks, so that no byte of it can change unseen: its own SHA-256 is of the rest.
std::string signed_text(nlohmann::json manifest) {
  manifest["sha256"] = sha256(manifest.dump());
  return manifest.dump();
}

/// An empty object if the manifest is damaged or of another version.
nlohmann::json read_manifest(const fs::path& folder) {
  const std::string text = read_file(folder / "latest.json");
  nlohmann::json manifest = json_if_valid(text);
  if (!manifest.is_object() || !manifest.contains("sha256")) return nlohmann::json::object();
  manifest.erase("sha256");
  const bool whole = signed_text(manifest) == text && manifest.value("format", "") == format &&
                     manifest.value("columns", std::size_t{0}) == column_count();
  return whole ? manifest : nlohmann::json::object();
}

std::string objection_to_origin(const nlohmann::json& manifest, const Provenance& now) {
  if (manifest.empty()) return "is damaged, or was written by another version of asperity";
  if (manifest.at("inputs_sha256") != now.inputs_sha256) return "is of other inputs";
  if (manifest.at("commit") != now.commit)
    return "was written by the build of commit " + manifest.at("commit").get<std::string>() +
           ", and this one is of " + now.commit;
  return "";
}

std::string objection_to_part(const fs::path& folder, const nlohmann::json& described,
                              const std::string& bytes) {
  const std::string name = (folder / described.at("file").get<std::string>()).string();
  if (bytes.size() != described.at("bytes").get<std::size_t>())
    return "is damaged: '" + name + "' has " + std::to_string(bytes.size()) + " bytes of " +
           std::to_string(described.at("bytes").get<std::size_t>());
  if (sha256(bytes) != described.at("sha256").get<std::string>())
    return "is damaged: '" + name + "' has another SHA-256 than when it was written";
  return "";
}

std::string read_part(const fs::path& folder, const nlohmann::json& described) {
  const fs::path path = folder / described.at("file").get<std::string>();
  return fs::exists(path) ? read_file(path) : std::string();
}

void accept(const fs::path& folder, const std::string& objection) {
  if (!objection.empty())
    throw WorkError("the checkpoint in '" + folder.string() + "' " + objection +
                    "; solve again with --overwrite");
}

}  // namespace

void write_checkpoint(const fs::path& folder, const Checkpoint& c, MPI_Comm communicator) {
  const int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
  const int ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  if (rank == 0) make_folder(folder);
  MPI_Barrier(communicator);
  const std::string bytes = part_of(c);
  const std::string name = part_name(c.steps(), rank);
  write_file_atomically(folder / name, bytes);
  const auto parts = dealii::Utilities::MPI::gather(communicator, description(name, bytes).dump());
  if (rank != 0) return;
  nlohmann::json manifest{{"format", format},
                          {"steps", c.steps()},
                          {"ranks", ranks},
                          {"columns", column_count()},
                          {"inputs_sha256", c.provenance.inputs_sha256},
                          {"commit", c.provenance.commit}};
  for (const auto& part : parts) manifest["parts"].push_back(nlohmann::json::parse(part));
  write_file_atomically(folder / "latest.json", signed_text(manifest));
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("step_", 0) == 0 && name.rfind("step_" + std::to_string(c.steps()) + "_", 0) != 0)
      fs::remove(entry.path());
  }
}

std::string objection_to_resume(const fs::path& folder, const Provenance& now) {
  if (!fs::exists(folder / "latest.json")) return "";
  const auto manifest = read_manifest(folder);
  std::string objection = objection_to_origin(manifest, now);
  if (!objection.empty()) return objection;
  for (const auto& described : manifest.at("parts")) {
    objection = objection_to_part(folder, described, read_part(folder, described));
    if (!objection.empty()) return objection;
  }
  return "";
}

std::optional<Checkpoint> read_checkpoint(const fs::path& folder, const Provenance& now,
                                          MPI_Comm communicator) {
  if (!fs::exists(folder / "latest.json")) return std::nullopt;
  const auto manifest = read_manifest(folder);
  accept(folder, objection_to_origin(manifest, now));
  const int ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  if (manifest.at("ranks") != ranks)
    throw WorkError("the checkpoint was written by " + std::to_string(manifest.at("ranks").get<int>()) +
                    " processes; resume with mpirun -np " + std::to_string(manifest.at("ranks").get<int>()));
  const auto& described = manifest.at("parts").at(dealii::Utilities::MPI::this_mpi_process(communicator));
  const std::string bytes = read_part(folder, described);
  accept(folder, objection_to_part(folder, described, bytes));
  Checkpoint c = checkpoint_of(bytes);
  c.provenance = now;
  return c;
}

}  // namespace asperity::fem
