// Tags of TIFF files (Adobe, TIFF 6.0, 1992), in which some instruments keep heights.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "surfaces/readers/stored_numbers.h"

namespace asperity {

/// Where the value of one tag lies; it may point beyond the end of the file.
struct TiffTag {
  int type = 0;
  std::size_t offset = 0;  ///< where its bytes begin
  std::size_t length = 0;  ///< their number
};

/// The tags of one picture of the file, by their numbers.
using TiffDirectory = std::map<int, TiffTag>;

/// Whether the file begins like a TIFF file.
bool is_tiff(const SourceFile& file);
/// The byte order that it states in its first byte.
ByteOrder tiff_order(const SourceFile& file);

/// Throws the InputError of a TIFF file that is cut off.
[[noreturn]] void refuse_cut_off_tiff(const SourceFile& file);

/// The directories of all pictures, up to a thousand of them. Throws InputError where the file ends before
/// them.
std::vector<TiffDirectory> tiff_directories(const SourceFile& file);

/// The numbers of a tag, none if the directory lacks it. Throws InputError where it lies beyond the end.
std::vector<double> tiff_numbers(const SourceFile& file, const TiffDirectory& directory, int tag);

/// The first of them.
std::optional<double> tiff_number(const SourceFile& file, const TiffDirectory& directory, int tag);

/// A text, without blanks around it; empty if the directory lacks it.
std::string tiff_text(const SourceFile& file, const TiffDirectory& directory, int tag);

}  // namespace asperity
