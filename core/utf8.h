// Text of files in UTF-8, as JSON and the report need it.
#pragma once

#include <string>

namespace asperity {

/// Is every character well-formed (Unicode 15, table 3-7: nothing overlong, no surrogate, at most U+10FFFF)?
bool is_utf8(const std::string& text);

/// The text itself where it is UTF-8, else read as Latin-1, as older instruments write it.
std::string as_utf8(std::string text);

}  // namespace asperity
