#include "app/mpi_session.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>
#include <omp.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>

#include "core/alone_in_mpi.h"
#include "core/error.h"
#include "core/printable.h"
#include "core/thread_limit.h"

namespace asperity {

bool is_speaking_rank() {
  // Set by Open MPI's mpirun; not set in a process started alone.
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  return !rank || std::string(rank) == "0";
}

void say(const std::string& line) {
  if (is_speaking_rank()) std::cout << line << std::endl;
}

void with_mpi(int threads, const std::function<void()>& work) {
  std::exception_ptr failure;
  {
    int argc = 0;
    char** argv = nullptr;
    // hwloc, which MPI asks for the cores, would ask every X server for its graphics card too, and dies with
    // a server that ends meanwhile.
    constexpr int unless_set = 0;
    ::setenv("HWLOC_COMPONENTS", "-gl", unless_set);
    // What solves, and deal.II, share loops by TBB, surfaces by OpenMP: as many threads of both. deal.II
    // knows how many cores each rank of this machine may have.
    if (threads == 0 && std::getenv("OMP_NUM_THREADS")) threads = omp_get_max_threads();
    if (threads > 0) limit_threads(threads);
    std::optional<AloneInMpi> alone(std::in_place);
    const dealii::Utilities::MPI::MPI_InitFinalize session(
        argc, argv, threads > 0 ? static_cast<unsigned int>(threads) : dealii::numbers::invalid_unsigned_int);
    alone.reset();
    omp_set_num_threads(threads > 0 ? threads : static_cast<int>(dealii::MultithreadInfo::n_threads()));
    try {
      work();
    } catch (const InputError&) {
      failure = std::current_exception();  // every rank reads the same input and refuses it
    } catch (const std::exception& error) {
      failure = std::current_exception();
      if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1) {
        std::fprintf(stderr, "asperity: %s\n", printable_lines(error.what()).c_str());
        constexpr int failed = 1;
        MPI_Abort(MPI_COMM_WORLD, failed);
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace asperity
