#include "meshing/triangles/cgal_failure.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity::meshing {
namespace {

TEST(CgalFailure_behaviour, is_an_error_of_the_work_that_says_where_and_what_to_do) {
  try {
    without_raw_failures("fill a body", "use another spacing", [] {
      throw CGAL::Assertion_exception("CGAL", "", "/usr/include/CGAL/Mesh_3/C3T3_helpers.h", 3819, "");
    });
    FAIL();
  } catch (const WorkError& error) {
    EXPECT_EQ(std::string(error.what()),
              "CGAL failed to fill a body (C3T3_helpers.h, line 3819); use another spacing");
  }
}

TEST(CgalFailure_behaviour, lets_results_and_refusals_through) {
  EXPECT_EQ(without_raw_failures("count", "", [] { return 3; }), 3);
  EXPECT_THROW(without_raw_failures("read", "", [] { throw InputError("not a surface"); }), InputError);
}

}  // namespace
}  // namespace asperity::meshing
