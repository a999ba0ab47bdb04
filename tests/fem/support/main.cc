// p4est needs MPI to be up before any forest is made, so these tests bring their own main().
#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "core/alone_in_mpi.h"

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // so that long tests show how far they are
  testing::InitGoogleTest(&argc, argv);
  const int threads =
      std::getenv("OMP_NUM_THREADS") ? omp_get_max_threads() : std::min(2, omp_get_num_procs());
  omp_set_num_threads(threads);
  std::optional<asperity::AloneInMpi> alone(std::in_place);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, static_cast<unsigned>(threads));
  alone.reset();
  return RUN_ALL_TESTS();
}
