#include "core/base64.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(Base64_other_code, agrees_with_the_examples_of_RFC_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace asperity
