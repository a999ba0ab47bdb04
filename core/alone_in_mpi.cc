#include "core/alone_in_mpi.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace asperity {
namespace {

/// Set by mpirun of Open MPI, and by launchers that speak PMIx or PMI.
constexpr const char* of_launchers[] = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMIX_NAMESPACE", "PMI_RANK",
                                        "PMI_SIZE"};
constexpr std::pair<const char*, const char*> settings[] = {
    {"OMPI_MCA_ess_singleton_isolated", "1"}, {"OMPI_MCA_pml", "ob1"}, {"OMPI_MCA_btl", "self"}};

}  // namespace

AloneInMpi::AloneInMpi() {
  const auto is_set = [](const char* name) { return std::getenv(name) != nullptr; };
  if (std::any_of(std::begin(of_launchers), std::end(of_launchers), is_set)) return;
  for (const auto& [name, value] : settings)
    if (!is_set(name) && ::setenv(name, value, 1) == 0) set_.emplace_back(name);
}

AloneInMpi::~AloneInMpi() {
  for (const std::string& name : set_) ::unsetenv(name.c_str());
}

std::vector<std::string> environment_alone_in_mpi() {
  std::vector<std::string> entries;
  for (const auto& [name, value] : settings) entries.push_back(std::string(name) + "=" + value);
  return entries;
}

}  // namespace asperity
