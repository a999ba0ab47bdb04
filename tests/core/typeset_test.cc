#include "core/typeset.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(Typeset_analytic, products_indices_and_exponents_are_those_of_the_plain_text) {
  EXPECT_EQ(typeset("f = 4/3 E* R^(1/2) d^(3/2)"), "f = 4/3\\, E^{*}\\, R^{1/2}\\, d^{3/2}");
  EXPECT_EQ(typeset("f_l = f_0 + mu0 f_contact"), "f_{l} = f_{0} + \\mu _{0}\\, f_{\\text{contact}}");
  EXPECT_EQ(typeset("(8 pi w a*^3)^(1/2)"), "(8\\, \\pi \\, w\\, a^{*3})^{1/2}");
  EXPECT_EQ(typeset("exp(-t/tau) sinh^2(k z)"), "\\exp(-t/\\tau)\\, \\sinh^{2}(k\\, z)");
}

TEST(Typeset_behaviour, signs_and_differentials_are_known) {
  EXPECT_EQ(typeset("|t| <= mu p"), "\\vert t\\vert{} \\le \\mu \\, p");
  EXPECT_EQ(typeset("tau dq/dt = d theta/dt"),
            "\\tau \\, \\mathrm{d}q/\\mathrm{d}t = \\mathrm{d}\\theta/\\mathrm{d}t");
  EXPECT_EQ(typeset("a = max(0, b), c << d"), "a = \\max(0, b),\\quad c \\ll d");
  EXPECT_EQ(typeset("2 % of #1 & $x"), "2 \\% \\text{of} \\#1 \\& \\$x");
}

TEST(Typeset_behaviour, prose_stays_prose_and_keeps_its_names) {
  EXPECT_EQ(typeset("d = 4 h on the way back"), "d = 4\\, h\\ \\text{on the way back}");
  EXPECT_EQ(typeset("a u in Maugis' units"), "a\\, u\\ \\text{in Maugis' units}");
  EXPECT_EQ(typeset("in the law of bulk_plasticity"), "\\text{in the law of}\\ \\text{bulk\\_plasticity}");
}

TEST(Typeset_behaviour, a_page_has_it_as_code_or_as_an_equation) {
  EXPECT_EQ(displayed("a = b", Equations::plain), "    a = b");
  EXPECT_EQ(displayed("a = b", Equations::typeset), "$$ a = b $$");
  // Long ones go on in another line, but not within brackets.
  EXPECT_EQ(
      displayed("a = b + c + d + e + f + g(h, i, j, k, l, m, n, o, p, q, r, s, t), b = 5 c; c = 3",
                Equations::typeset),
      "$$\n\\begin{gathered}\na = b + c + d + e + f + g(h, i, j, k, l, m, n, o, p, q, r, s, t), \\\\\nb = "
      "5\\, c;\\quad c = "
      "3\n\\end{gathered}\n$$");
  // What no rule meets ends, whatever it is.
  for (const char* odd : {"", "^", "^(", "_", "a_", "'", "a'", "(", "*", "a**", "\\", "d ", "|"})
    typeset(odd);
}

}  // namespace
}  // namespace asperity
