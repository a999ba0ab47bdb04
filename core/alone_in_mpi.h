// What Open MPI need not do for a process that was started alone.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// While it lives, MPI that starts in this process makes no daemon for it and no network: 0.7 s less. Not in
/// a process that a launcher (mpirun, srun) started, and not what the environment says already. Programs
/// started after it has ended know nothing of it.
class AloneInMpi {
 public:
  AloneInMpi();
  ~AloneInMpi();
  AloneInMpi(const AloneInMpi&) = delete;
  AloneInMpi& operator=(const AloneInMpi&) = delete;

 private:
  std::vector<std::string> set_;  ///< names in the environment
};

/// The same for a program that is started alone beside this one: entries "NAME=value" of its environment. Not
/// for a script that starts ranks itself: they would find no network.
std::vector<std::string> environment_alone_in_mpi();

}  // namespace asperity
