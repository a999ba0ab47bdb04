#include "app/case_folder.h"

#include "app/case_file.h"
#include "core/error.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

using test::smooth_case;

TEST(CaseFolder, remembers_the_input_and_refuses_to_resume_another_case) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const auto results = folder.path / "results";
  remember_case(read_settings(file, {"Experiment/Normal load=2 mN"}), file, results, false);
  EXPECT_DOUBLE_EQ(read_case(results / "case.prm").experiment.normal_load, 2e-3);

  remember_case(read_settings(file, {"Experiment/Normal load=2 mN", "Solver/Threads=1"}), file, results, true);
  const std::string message =
      test::message_of<InputError>([&] { remember_case(read_settings(file), file, results, true); });
  EXPECT_NE(message.find("was solved with Experiment/Normal load = 2 mN, and now it is 1 mN"), std::string::npos) << message;

  remember_case(read_settings(file), file, results, false);
  EXPECT_DOUBLE_EQ(read_case(results / "case.prm").experiment.normal_load, 1e-3);
}

TEST(CaseFolder, leaves_a_case_file_alone_that_lies_in_the_folder) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  remember_case(read_settings(file, {"Solver/Threads=1"}), file, folder.path, true);
  EXPECT_EQ(read_case(file).solver.threads, 0);
}

}  // namespace asperity
