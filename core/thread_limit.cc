#include "core/thread_limit.h"

#include <tbb/global_control.h>

#include <optional>

namespace asperity {

void limit_threads(int count) {
  // Kept until the process has ended: TBB's own state may be gone before that of this file.
  static auto* const limit = new std::optional<tbb::global_control>;
  limit->reset();
  if (count > 0)
    limit->emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
}

}  // namespace asperity
