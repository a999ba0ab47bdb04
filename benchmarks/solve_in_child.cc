#include "benchmarks/solve_in_child.h"

#include <deal.II/base/mpi.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "core/error.h"
#include "fem/solve_case.h"

namespace asperity {

double solve_in_child(const CaseInput& input, const std::filesystem::path& folder, int threads) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw WorkError("cannot start a process for the next size");
  if (child == 0) {
    int status = 1;
    try {
      int argc = 0;
      char** argv = nullptr;
      const dealii::Utilities::MPI::MPI_InitFinalize session(argc, argv, static_cast<unsigned>(threads));
      SolveOptions options;
      options.output = folder;
      options.progress = [](const std::string& line) {
        std::printf("  %s\n", line.c_str()), std::fflush(stdout);
      };
      solve_case(input, options);
      status = 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    std::fflush(nullptr);
    _exit(status);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw WorkError("the case at '" + folder.string() + "' was not solved");
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace asperity
