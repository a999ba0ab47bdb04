// Where a result comes from: which inputs, which program. Case, checkpoint and result of a folder say the
// same.
#pragma once

#include <string>

namespace asperity {

struct Provenance {
  std::string inputs_sha256;  ///< of the case and every file it names (app/inputs_hash.h); empty: not known
  std::string commit;         ///< of the program's source (core/build_commit.h); empty: not known
};

}  // namespace asperity
