// A measured scan as a case file names it: FILE, or scan(FILE, size=2.5 um, channel=Height, unit=nm, level=plane,
// cutoff=20 nm, outside=mirror) where the file alone does not say enough.
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
  std::string spec;  ///< the entry Topography
};

struct ScanParameters {
  std::string file;
  ReadOptions options;                  ///< size, channel and height unit, where the file does not say them
  Level level = Level::plane;           ///< what is taken off before the scan is used
  double cutoff = 0;                    ///< waves shorter than this are taken out [m]; 0: none are
  Outside outside = Outside::refuse;    ///< beyond the scan's edge

  /// The entry of a case file: the file's name alone where nothing else is given.
  std::string text() const;
};

/// Reads either form. Throws InputError naming the argument that is unknown or wrong. The file need not exist.
ScanParameters parse_scan(const std::string& spec);

/// The scan as read, levelled and, with a cut-off, without shorter waves. Throws ScanError.
Topography prepared_scan(const std::string& spec);

/// That scan for a square region of side `size` [m]; its centre is the centre of contact. Smaller scans are
/// refused or, if asked for, continued by their mirror images (the map is then periodic with twice the scan's size; heights
/// are continuous across the edges, slopes are not). Throws ScanError.
Topography scan_over(const std::string& spec, double size);

}  // namespace asperity
