// The same contact solved on several spacings: what its mesh leaves in doubt, apart from the scatter over
// realisations.
#pragma once

#include <functional>
#include <vector>

#include "dem_compare/cases/case_collection.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {

class MeshFamily {
 public:
  /// `own` and the groups of the collection that differ from it by their mesh alone.
  MeshFamily(const CaseCollection& collection, const CaseGroup& own);

  /// True if no other group of the family has a smaller spacing.
  bool own_is_finest() const;
  /// Of the other groups [m].
  std::vector<double> other_spacings() const;

  /// A number of each case: mean and scatter over the realisations of `own`, and the error of its mesh. The
  /// spacings are compared over the realisations that all of them have, so that scatter does not pass for
  /// mesh error.
  Estimate estimate(const std::function<double(const NormalNumbers&)>& number) const;

 private:
  const CaseGroup& own_;
  std::vector<const CaseGroup*> others_;
};

}  // namespace asperity
