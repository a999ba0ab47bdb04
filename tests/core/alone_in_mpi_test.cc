// Settings of Open MPI for a process that was started alone.
#include "core/alone_in_mpi.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace asperity {
namespace {

std::string in_environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "unset";
}

TEST(AloneInMpi_behaviour, sets_what_is_not_set_and_takes_it_back) {
  for (const char* name : {"OMPI_MCA_pml", "OMPI_MCA_ess_singleton_isolated"}) ::unsetenv(name);
  ::setenv("OMPI_MCA_btl", "self,tcp", 1);
  {
    const AloneInMpi alone;
    EXPECT_EQ(in_environment("OMPI_MCA_ess_singleton_isolated"), "1");
    EXPECT_EQ(in_environment("OMPI_MCA_pml"), "ob1");
    EXPECT_EQ(in_environment("OMPI_MCA_btl"), "self,tcp") << "what the user says stays";
  }
  EXPECT_EQ(in_environment("OMPI_MCA_pml"), "unset");
  EXPECT_EQ(in_environment("OMPI_MCA_btl"), "self,tcp");
  ::unsetenv("OMPI_MCA_btl");
}

TEST(AloneInMpi_behaviour, says_a_program_beside_this_one_the_same) {
  const AloneInMpi alone;
  const std::vector<std::string> entries = environment_alone_in_mpi();
  EXPECT_EQ(entries.size(), 3U);
  for (const std::string& entry : entries) {
    const std::size_t equals = entry.find('=');
    EXPECT_EQ(in_environment(entry.substr(0, equals).c_str()), entry.substr(equals + 1)) << entry;
  }
}

TEST(AloneInMpi_behaviour, leaves_ranks_of_a_launcher_as_they_are) {
  for (const char* launched : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"}) {
    ::setenv(launched, "2", 1);
    const AloneInMpi alone;
    EXPECT_EQ(in_environment("OMPI_MCA_ess_singleton_isolated"), "unset") << launched;
    ::unsetenv(launched);
  }
}

}  // namespace
}  // namespace asperity
