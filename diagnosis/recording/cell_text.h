// A cell of a table.
#pragma once

#include "core/text_pieces.h"

namespace asperity {

/// Without the blanks and quotation marks around it.
inline std::string cell_text(std::string_view text) { return trimmed(text, " \t\r\""); }

}  // namespace asperity
