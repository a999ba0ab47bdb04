// Data packed by zlib, unpacked piece by piece up to the limit of core/read_limits.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "surfaces/readers/format.h"

namespace asperity {

/// The two wrappings of deflated data: files of gzip (of several members one after the other), or a part of a
/// file in zlib's own.
enum class Packing { gzip, zlib };

/// A range of a file's bytes; the caller has checked that it lies inside.
struct ByteRange {
  std::size_t begin = 0, length = 0;
};

/// What the range unpacks to. Throws InputError for what is damaged or cut off, and as soon as more comes out
/// than read_limits::most_unpacked() allows for the file, of which `before` bytes came out of other parts.
std::string inflated(const SourceFile& file, ByteRange range, Packing packing, std::uint64_t before = 0);

}  // namespace asperity
