// Numbers in texts.
#pragma once

#include <string>

namespace asperity {

/// As std::printf writes it.
[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...);

}  // namespace asperity
