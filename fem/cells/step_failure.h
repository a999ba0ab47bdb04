// Failure of a step that a smaller one may avoid: it is halved.
#pragma once

#include <mpi.h>

#include <mutex>
#include <string>

#include "core/error.h"

namespace asperity::fem {

class StepFailure : public WorkError {
 public:
  using WorkError::WorkError;
};

/// Carries a failure out of a parallel loop, which no exception may leave, and to all ranks, which would wait
/// for the one that failed.
class StepFailures {
 public:
  /// Runs `work` and keeps its failure, if it has one.
  template <typename Work>
  void guard(const Work& work) {
    try {
      work();
    } catch (const StepFailure& failure) {
      const std::lock_guard<std::mutex> lock(mutex_);
      first_ = failure.what();
    }
  }
  /// Collective. Throws StepFailure on all ranks if there was one on any.
  void throw_on_all(MPI_Comm communicator) const {
    int here = first_.empty() ? 0 : 1, anywhere = 0;
    MPI_Allreduce(&here, &anywhere, 1, MPI_INT, MPI_MAX, communicator);
    if (anywhere) throw StepFailure(here ? first_ : "a step failed on another process");
  }

 private:
  std::mutex mutex_;
  std::string first_;
};

}  // namespace asperity::fem
