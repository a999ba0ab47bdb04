// A case driven as a recording was: which of its entries follow.
#include "app/driven_case.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/topography_spec.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

constexpr double nano = 1e-9, micro = 1e-6;

TEST(DrivenCase_behaviour, the_generated_substrate_is_scaled_and_keeps_spectrum_and_seed) {
  Settings settings{
      {"Substrate", "Topography", "generated(rms=1.5 nm, rolloff=200 nm, cutoff=72 nm, seed=7)", ""}};
  drive(settings, MotionProtocol{Motion::sliding, 100 * micro, 200 * nano, 2.7 * nano});
  const TopographySpec scaled(settings.front().value);
  ASSERT_NE(scaled.generator(), nullptr);
  EXPECT_DOUBLE_EQ(scaled.rms(), 2.7 * nano);
  EXPECT_EQ(scaled.generator()->seed, 7u);
  EXPECT_DOUBLE_EQ(scaled.generator()->spectrum.rolloff, 200 * nano);
  Settings scan{{"Substrate", "Topography", "scan.gwy", ""}};
  EXPECT_NE(test::message_of<InputError>([&] {
              drive(scan, MotionProtocol{Motion::sliding, 100 * micro, 200 * nano, 2.7 * nano});
            }).find("generated(rms=...)"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity
