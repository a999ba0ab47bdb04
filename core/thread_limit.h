// How many threads share loops (core/threads.h).
#pragma once

namespace asperity {

/// At most `count` threads share loops from now on; 0: as many as the machine has cores.
void limit_threads(int count);

}  // namespace asperity
