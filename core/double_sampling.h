// The mean of a quantity that a dear method tells for a few samples and a cheap one for many: the cheap one's
// mean times the ratio of both on the samples that both have (ratio estimate by double sampling; Cochran
// 1977, Sampling Techniques, section 12.8).
#pragma once

#include <vector>

namespace asperity {

/// Dear over cheap; sd: standard deviation of the mean of what the ratio leaves, in the unit of the dear
/// method's numbers.
struct MethodRatio {
  double ratio = 0;  ///< [-]
  double sd = 0;     ///< in the numbers' unit
};

/// cheap, dear: of the same samples in the same order. Throws InputError for fewer than two, or where the
/// cheap ones' mean is 0.
MethodRatio method_ratio(const std::vector<double>& cheap, const std::vector<double>& dear);

/// A mean and its standard deviation.
struct SampledMean {
  double value = 0, sd = 0;  ///< in the numbers' unit
};

/// all: of every sample by the cheap method, those that both have included. Throws InputError as above.
SampledMean mean_by_double_sampling(const std::vector<double>& all, const std::vector<double>& cheap,
                                    const std::vector<double>& dear);

}  // namespace asperity
