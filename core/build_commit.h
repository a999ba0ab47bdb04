// The commit this program was built from; written by CMake at each build (cmake/commit.cmake).
#pragma once

namespace asperity {

/// 40 hexadecimal digits, with "-dirty" where the tree had changes of its own; "unknown" without git.
const char* build_commit();

}  // namespace asperity
