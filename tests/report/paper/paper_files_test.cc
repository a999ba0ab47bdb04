#include "report/paper/paper_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/engines/canonical_contact.h"

namespace asperity::report {
namespace {

TEST(PaperFiles_behaviour, text_shows_remarks_beside_numbers_and_json_and_csv_hold_all_of_them) {
  const PaperAnalysis analysis = analyse_paper(read_published(test::paper_run("published")));
  const std::string text = paper_text(analysis);
  for (const char* part : {"Table 1",
                           "Table 2",
                           "Mindlin's G* has (2 - nu)",
                           "mu_s belongs inside of the fraction",
                           "+6.81",
                           "fig_rail_2.csv",
                           "1.36 GPa would need",
                           "a negative offset has no meaning",
                           "it uses eq:barmuro",
                           "it is mu_s^to",
                           "2 cos(theta) = 1",
                           "would drive the motion",
                           "it is -d delta/dt",
                           "it is -f_s^l",
                           "it is r_s",
                           "does not give the figures",
                           "'2-3 orders of magnitude'",
                           "h_l is not monotonic",
                           "no threshold of 100 uN",
                           "above the yield stress of 3 GPa",
                           "contacts stay elastic for this reason",
                           "the conclusion says 0.065",
                           "bought as 17.3",
                           "not the same effect",
                           "'cannot be defined'",
                           "not equivalent over the measured loads",
                           "2/3 is 13 % above it",
                           "the friction measured in the rail itself",
                           "finite elements are not to be compared with it",
                           "first yield needs 4.8 GPa",
                           "no contact of the paper gives 1.36 GPa"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  const auto json = nlohmann::json::parse(paper_json(analysis));
  EXPECT_EQ(json["sections"].size(), analysis.sections.size());
  EXPECT_EQ(json["curves"].size(), 11u);
  const std::string csv = paper_csv(analysis.sections[1]);
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            analysis.sections[1].numbers.size() + 1);
}

}  // namespace
}  // namespace asperity::report
