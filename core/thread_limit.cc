#include "core/thread_limit.h"

#include <tbb/global_control.h>

#include <cstdlib>
#include <optional>

namespace asperity {

void limit_threads(int count) {
  // Kept until the process has ended: TBB's own state may be gone before that of this file.
  static auto* const limit = new std::optional<tbb::global_control>;
  limit->reset();
  if (count > 0)
    limit->emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
}

void limit_threads_by_environment() {
  const char* asked = std::getenv("OMP_NUM_THREADS");
  if (const int count = asked ? std::atoi(asked) : 0; count > 0) limit_threads(count);
}

}  // namespace asperity
