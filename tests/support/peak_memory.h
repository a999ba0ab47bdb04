// How much memory some work takes at its largest, measured from outside.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <exception>

#include <gtest/gtest.h>

#include "core/error.h"

namespace asperity::test {

/// The address sanitizer keeps freed memory and shadows all of it: its process says nothing about the
/// program's.
#ifdef __SANITIZE_ADDRESS__
constexpr bool under_sanitizer = true;
#else
constexpr bool under_sanitizer = false;
#endif

/// How a child process that did the work ended, and what it had resident at its largest.
struct ChildOutcome {
  enum class End { done, refused, failed, crashed } end = End::crashed;
  std::uint64_t peak_bytes = 0;
};

template <class Work>
ChildOutcome in_child(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (!under_sanitizer) {
      const rlim_t most = rlim_t{6} << 30;  // a test that fails is not to take the machine with it
      const rlimit limit{most, most};
      ::setrlimit(RLIMIT_AS, &limit);
    }
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    try {
      work();
    } catch (const InputError&) {
      ::_exit(2);
    } catch (const std::exception&) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 0;
  rusage usage{};
  ChildOutcome outcome;
  EXPECT_EQ(::wait4(child, &status, 0, &usage), child);
  outcome.peak_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  if (WIFEXITED(status) && WEXITSTATUS(status) <= 2) {
    const ChildOutcome::End ends[] = {ChildOutcome::End::done, ChildOutcome::End::failed,
                                      ChildOutcome::End::refused};
    outcome.end = ends[WEXITSTATUS(status)];
  }
  return outcome;
}

/// The same with the memory that the process has anyway taken off; none under a sanitizer.
template <class Work>
ChildOutcome measured_in_child(const Work& work) {
  const std::uint64_t before = in_child([] {}).peak_bytes;
  ChildOutcome outcome = in_child(work);
  outcome.peak_bytes -= under_sanitizer ? outcome.peak_bytes : std::min(before, outcome.peak_bytes);
  return outcome;
}

inline void expect_refused_within(const ChildOutcome& outcome, std::uint64_t most_bytes) {
  EXPECT_EQ(outcome.end, ChildOutcome::End::refused);
  EXPECT_LT(outcome.peak_bytes, most_bytes);
}

}  // namespace asperity::test
