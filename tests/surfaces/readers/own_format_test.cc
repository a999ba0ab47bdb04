#include <gtest/gtest.h>

#include "core/error.h"
#include "surfaces/read_topography.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

TEST(OwnFormat_analytic, is_read_listed_and_refuses_what_is_damaged) {
  const test::TemporaryFolder folder;
  const Topography map = read_topography(folder.write("scan.own", "OWN 3 2 5e-9\n4 5 6\n1 2 3\n"));
  EXPECT_EQ(map.nx, 3);
  EXPECT_DOUBLE_EQ(map.lx, 15e-9);
  EXPECT_DOUBLE_EQ(map.at(0, 0), 1e-9);  // its first row is the image's top
  EXPECT_DOUBLE_EQ(map.at(2, 1), 6e-9);
  EXPECT_THROW(read_topography(folder.write("cut.own", "OWN 3 2 5e-9\n4 5\n")), InputError);
  try {
    read_topography(folder.write("scan.bin", std::string("\x01\x02\x03", 3)));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("own map (.own)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace asperity
