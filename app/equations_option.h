// --typeset of commands that print a manual page.
#pragma once

#include <CLI/CLI.hpp>

#include "core/typeset.h"

namespace asperity {

/// Adds it to a command.
inline void add_typeset(CLI::App& command, bool& is_typeset) {
  command.add_flag("--typeset", is_typeset, "Equations in TeX, for a page that typesets them");
}

/// What the page's function takes.
inline Equations equations_of(bool is_typeset) { return is_typeset ? Equations::typeset : Equations::plain; }

}  // namespace asperity
