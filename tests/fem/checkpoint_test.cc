// What a checkpoint says of itself: inputs, program, and that not one bit of it has changed.
#include "fem/output/checkpoint.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity::fem {
namespace {

namespace fs = std::filesystem;
using test::message_of;

const Provenance ours{"0123abcd", "c1"};

class CheckpointFile_analytic : public testing::Test {
 protected:
  CheckpointFile_analytic() {
    Checkpoint c;
    c.provenance = ours;
    c.load = 1e-4;
    c.records.resize(1);
    c.displacement = {1, 2, 3};
    c.history = {4};
    write_checkpoint(folder.path, c, MPI_COMM_WORLD);
  }
  std::string objection(const Provenance& now = ours) const { return objection_to_resume(folder.path, now); }
  std::string refusal(const Provenance& now = ours) const {
    return message_of<WorkError>([&] { read_checkpoint(folder.path, now, MPI_COMM_WORLD); });
  }

  const test::TemporaryFolder folder;
  const fs::path manifest = folder.path / "latest.json", part = folder.path / "step_1_rank_0.bin";
};

}  // namespace

TEST_F(CheckpointFile_analytic, is_read_as_it_was_written) {
  EXPECT_EQ(objection(), "");
  const auto read = read_checkpoint(folder.path, ours, MPI_COMM_WORLD);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->displacement, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(read->load, 1e-4);
  EXPECT_EQ(objection_to_resume(folder.path / "none", ours), "");
}

TEST_F(CheckpointFile_analytic, a_flipped_bit_of_it_is_found) {
  for (const fs::path& file : {manifest, part}) {
    const std::string whole = read_file(file);
    constexpr std::size_t stride = 3;  // reaches each bit of a byte, each byte
    for (std::size_t bit = 0; bit < 8 * whole.size(); bit += stride) {
      std::string damaged = whole;
      damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
      std::ofstream(file, std::ios::binary) << damaged;
      ASSERT_NE(objection(), "") << file << " bit " << bit;
      if (bit % 97 == 0) {
        EXPECT_NE(refusal().find("; solve again with --overwrite"), std::string::npos);
      }
    }
    std::ofstream(file, std::ios::binary) << whole;
    ASSERT_EQ(objection(), "");
  }
}

TEST_F(CheckpointFile_analytic, a_part_that_is_cut_off_or_missing_is_named) {
  const auto size = fs::file_size(part);
  fs::resize_file(part, size - 8);
  EXPECT_NE(refusal().find("step_1_rank_0.bin' has " + std::to_string(size - 8) + " bytes of " +
                           std::to_string(size)),
            std::string::npos)
      << refusal();
  fs::remove(part);
  EXPECT_NE(objection().find("has 0 bytes of"), std::string::npos) << objection();
}

TEST_F(CheckpointFile_analytic, of_other_inputs_or_another_program_is_refused) {
  EXPECT_EQ(objection({"other", "c1"}), "is of other inputs");
  EXPECT_NE(refusal({ours.inputs_sha256, "c2"})
                .find("was written by the build of commit c1, and this one is of c2"),
            std::string::npos);
  auto json = nlohmann::json::parse(read_file(manifest));
  json["format"] = "asperity-checkpoint/2";
  std::ofstream(manifest) << json.dump();
  EXPECT_NE(refusal().find("another version of asperity"), std::string::npos);
}

}  // namespace asperity::fem
