#include "surfaces/readers/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/error.h"
#include "core/read_limits.h"

namespace asperity {
namespace {

/// zlib's state, freed whatever happens.
class Inflater {
 public:
  explicit Inflater(Packing packing) {
    constexpr int gzip_alone = 16;
    if (inflateInit2(&stream, packing == Packing::gzip ? MAX_WBITS + gzip_alone : MAX_WBITS) != Z_OK)
      throw WorkError("zlib cannot be started; is there memory left?");
  }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream stream{};
};

[[noreturn]] void refuse_damaged(const SourceFile& file) {
  throw InputError(file.name() +
                   " has packed data that cannot be unpacked: it is cut off or damaged; copy or "
                   "export it again");
}

}  // namespace

std::string inflated(const SourceFile& file, ByteRange range, Packing packing, std::uint64_t before) {
  const std::uint64_t most = read_limits::most_unpacked(file.bytes.size());
  Inflater inflater(packing);
  z_stream& stream = inflater.stream;
  std::vector<char> piece(1 << 16);
  std::string unpacked;
  const std::size_t end = range.begin + range.length;
  std::size_t at = range.begin;
  for (bool more = true; more;) {
    const std::size_t given = std::min<std::size_t>(end - at, std::numeric_limits<uInt>::max());
    // zlib does not write to its input, for which it has no const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(file.bytes.data() + at));
    stream.avail_in = static_cast<uInt>(given);
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    const int state = inflate(&stream, Z_NO_FLUSH);
    at += given - stream.avail_in;
    unpacked.append(piece.data(), piece.size() - stream.avail_out);
    if (before + unpacked.size() > most)
      throw InputError(file.name() + " unpacks to more than " + std::to_string(most >> 20) +
                       " MiB, too much for a file of " + std::to_string(file.bytes.size()) +
                       " bytes; unpack it yourself and pass the map");
    if (state == Z_STREAM_END) {
      const bool another = packing == Packing::gzip && at < end && file.bytes[at] == '\x1f';
      more = another && inflateReset(&stream) == Z_OK;
    } else if (state != Z_OK) {
      refuse_damaged(file);
    }
  }
  return unpacked;
}

}  // namespace asperity
