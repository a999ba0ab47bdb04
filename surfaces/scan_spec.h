// A measured scan as a case file names it: FILE, or scan(FILE, size=2.5 um, channel=Height, unit=nm,
// level=plane, cutoff=20 nm, outside=mirror) where the file alone does not say enough.
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"
#include "surfaces/levelling.h"
#include "surfaces/read_topography.h"
#include "surfaces/sampler.h"

namespace asperity {

/// A scan that cannot be used; the case file's reader adds the line that names it.
class ScanError : public InputError {
 public:
  ScanError(std::string entry, const std::string& message) : InputError(message), spec(std::move(entry)) {}
  std::string spec;  ///< the entry Topography, in its canonical writing
};

/// The scan as read, levelled and, with a cut-off, without shorter waves. Throws ScanError.
Topography prepared_scan(const ScanParameters& scan);

/// Throws ScanError, with the remedy, where a scan does not cover a square of side `size` [m] around its
/// centre and its entry does not ask for mirror images.
void require_cover(const ScanParameters& scan, const Topography& map, double size);

}  // namespace asperity
