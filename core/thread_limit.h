// How many threads share loops (core/threads.h).
#pragma once

namespace asperity {

/// At most `count` threads share loops from now on; 0: as many as the machine has cores.
void limit_threads(int count);

/// As many as OMP_NUM_THREADS says, where it is set to a number: OpenMP's threads heed it by themselves.
void limit_threads_by_environment();

}  // namespace asperity
