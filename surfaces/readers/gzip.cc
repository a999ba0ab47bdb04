#include "surfaces/readers/gzip.h"

#include "surfaces/readers/inflate.h"

namespace asperity {

bool is_gzip(const SourceFile& file) { return file.bytes.compare(0, 3, "\x1f\x8b\x08") == 0; }

SourceFile unpacked_gzip(const SourceFile& file) {
  return {file.path, inflated(file, {0, file.bytes.size()}, Packing::gzip)};
}

}  // namespace asperity
