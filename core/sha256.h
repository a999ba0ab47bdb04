// SHA-256 (FIPS 180-4), by OpenSSL's libcrypto: whether two files or two inputs are the same, and whether one
// was damaged.
#pragma once

#include <string>

namespace asperity {

/// SHA-256 of the bytes as 64 hexadecimal digits, as sha256sum prints it.
/// Throws WorkError where OpenSSL fails.
std::string sha256(const std::string& bytes);

}  // namespace asperity
