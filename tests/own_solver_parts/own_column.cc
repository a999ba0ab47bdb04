// A column of the history of somebody's own, all of it: how far the particle's frame has moved along x.
#include <cmath>

#include "fem/output/added_column.h"

namespace asperity::fem {
namespace {

const RegisteredColumn entry{[] {
  return AddedColumn{"path_length [m]", "path of the particle along x since it began to move",
                     [](const AcceptedStep& step, double before) {
                       return before + (step.before ? std::abs(step.row.shift - step.before->shift) : 0.0);
                     }};
}};

}  // namespace
}  // namespace asperity::fem
