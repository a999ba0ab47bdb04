#include "fem/output/checkpoint.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_text.h"

namespace asperity::fem {
namespace {

namespace fs = std::filesystem;

void put(std::string& bytes, const std::vector<double>& values) {
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(double));
}

std::vector<double> take(const std::string& bytes, std::size_t& at) {
  std::uint64_t count = 0;
  if (at + sizeof count > bytes.size()) throw WorkError("the checkpoint is cut off; solve again without --resume");
  std::memcpy(&count, bytes.data() + at, sizeof count);
  at += sizeof count;
  if (at + count * sizeof(double) > bytes.size()) throw WorkError("the checkpoint is cut off; solve again without --resume");
  std::vector<double> values(count);
  std::memcpy(values.data(), bytes.data() + at, count * sizeof(double));
  at += count * sizeof(double);
  return values;
}

/// To be raised with every change of what a checkpoint holds.
constexpr const char* format = "asperity-checkpoint/2";

fs::path part(const fs::path& folder, int step, int rank) {
  return folder / ("step_" + std::to_string(step) + "_rank_" + std::to_string(rank) + ".bin");
}

}  // namespace

void write_checkpoint(const fs::path& folder, const Checkpoint& c, MPI_Comm communicator) {
  const int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
  const int ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  if (rank == 0) fs::create_directories(folder);
  MPI_Barrier(communicator);
  std::string bytes;
  std::vector<double> rows;
  for (const auto& record : c.records)
    for (const auto& [name, member] : StepRecord::columns()) rows.push_back(record.*member);
  const RigidMotion& at = c.coupling.frames;
  put(bytes, {static_cast<double>(c.steps), c.load, c.far_field, c.lateral_far_field, c.stiffness_at_peak, c.lateral_stiffness,
              c.torsion_stiffness, c.wall_time, c.approach, c.motion.x, c.motion.y, c.motion.spin, c.motion.roll, at.x,
              at.y, at.spin, at.roll, c.coupling.elastic.x, c.coupling.elastic.y, c.coupling.elastic.turn});
  using Part = const std::vector<double>*;
  for (const Part values : {Part(&rows), Part(&c.displacement), Part(&c.multiplier), Part(&c.shear[0]), Part(&c.shear[1]), Part(&c.bonded), Part(&c.history)}) put(bytes, *values);
  write_file_atomically(part(folder, c.steps, rank), bytes);
  MPI_Barrier(communicator);
  if (rank != 0) return;
  const nlohmann::json manifest{{"format", format}, {"steps", c.steps}, {"ranks", ranks}, {"columns", StepRecord::columns().size()}};
  write_file_atomically(folder / "latest.json", manifest.dump(1));
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("step_", 0) == 0 && name.rfind("step_" + std::to_string(c.steps) + "_", 0) != 0) fs::remove(entry.path());
  }
}

bool is_of_this_version(const fs::path& folder) {
  if (!fs::exists(folder / "latest.json")) return true;
  const auto manifest = json_if_valid(read_file(folder / "latest.json"));
  return manifest.is_object() && manifest.value("format", "") == format &&
         manifest.value("columns", std::size_t{0}) == StepRecord::columns().size();
}

std::optional<Checkpoint> read_checkpoint(const fs::path& folder, MPI_Comm communicator) {
  if (!fs::exists(folder / "latest.json")) return std::nullopt;
  if (!is_of_this_version(folder))
    throw WorkError("the checkpoint in '" + folder.string() + "' was written by another version of asperity; solve again without --resume");
  const auto manifest = json_if_valid(read_file(folder / "latest.json"));
  const int ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  if (manifest.at("ranks") != ranks)
    throw WorkError("the checkpoint was written by " + std::to_string(manifest.at("ranks").get<int>()) +
                    " processes; resume with mpirun -np " + std::to_string(manifest.at("ranks").get<int>()));
  const std::string bytes = read_file(part(folder, manifest.at("steps"), dealii::Utilities::MPI::this_mpi_process(communicator)));
  std::size_t at = 0;
  Checkpoint c;
  const auto head = take(bytes, at);
  if (head.size() != 20) throw WorkError("the checkpoint in '" + folder.string() + "' is damaged; solve again without --resume");
  c.steps = static_cast<int>(head[0]);
  c.load = head[1], c.far_field = head[2], c.lateral_far_field = head[3];
  c.stiffness_at_peak = head[4], c.lateral_stiffness = head[5], c.torsion_stiffness = head[6];
  c.wall_time = head[7], c.approach = head[8], c.motion = {head[9], head[10], head[11], head[12]};
  c.coupling = {{head[13], head[14], head[15], head[16]}, {head[17], head[18], head[19]}};
  const auto rows = take(bytes, at);
  const auto& columns = StepRecord::columns();
  for (std::size_t k = 0; k + columns.size() <= rows.size(); k += columns.size()) {
    c.records.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i)
      c.records.back().*(columns[i].second) = rows[k + i];
  }
  c.displacement = take(bytes, at);
  c.multiplier = take(bytes, at);
  for (auto& component : c.shear) component = take(bytes, at);
  c.bonded = take(bytes, at);
  c.history = take(bytes, at);
  return c;
}

}  // namespace asperity::fem
