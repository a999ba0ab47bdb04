// A study: a base case and what is varied, as a matrix of complete cases.
//
//   subsection Study
//     set Base case    = base.prm            # optional; the study's own case sections override it
//     set Realisations = 4                   # of every generated topography
//     subsection Vary                        # each value with each value of the others; ";" adds entries to
//     a value
//       set Experiment/Normal load = 300 uN, 1 mN
//       set Substrate/Topography   = untreated: generated(rms=0.3 nm), etched: generated(rms=1.5 nm)
//     end
//     set Name of variants = Material        # optional; else they are called Variant
//     subsection Variants                    # named groups of entries, varied together
//       set elastic  = Particle/Yield stress=inf; Substrate/Yield stress=inf
//       set yielding =
//     end
//     subsection Realisations of variants    # of one variant more, or fewer, than of the others
//       set elastic = 8
//     end
//   end
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/parameter_file.h"

namespace asperity {

/// One direction of the matrix.
struct StudyAxis {
  std::string name;                 ///< "Normal load"; the whole path where two axes share it
  std::vector<std::string> labels;  ///< "300 uN", "1 mN"
};

/// One cell of the matrix and one realisation.
struct StudyCase {
  std::string name;                 ///< its folder: "1_mN-untreated-r2"
  std::vector<std::string> labels;  ///< one of each axis
  int realisation = 1;              ///< counted from 1
  Settings settings;                ///< every entry of the case
};

struct Study {
  std::string title;
  std::filesystem::path file;
  std::vector<StudyAxis> axes;
  int realisations = 1;          ///< but of variants with a number of their own
  int parallel_cases = 0;        ///< at the same time; 0: as many as the machine has cores
  std::vector<StudyCase> cases;  ///< the first realisation of all, then the second, ...
};

/// The subsection above, for the help and the manual.
extern const char* const study_example;

/// Reads a study and checks each of its cases, with `overrides` "Section/Entry=value" as if they stood in the
/// file (of an entry that is varied: in place of its values). Throws InputError naming file and line.
Study read_study(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

}  // namespace asperity
