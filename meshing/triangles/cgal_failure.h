// What CGAL finds wrong inside itself, as an error of this program (internal: include from .cc files only).
#pragma once

#include <CGAL/exceptions.h>

#include <filesystem>
#include <string>

#include "core/error.h"

namespace asperity::meshing {

/// What `work` returns. Throws WorkError, for a sentence "CGAL failed to <aim> (<where>); <remedy>", where an
/// assertion inside CGAL fails.
template <typename Work>
auto without_raw_failures(const std::string& aim, const std::string& remedy, const Work& work) {
  try {
    return work();
  } catch (const CGAL::Failure_exception& failure) {
    throw WorkError("CGAL failed to " + aim + " (" +
                    std::filesystem::path(failure.filename()).filename().string() + ", line " +
                    std::to_string(failure.line_number()) + "); " + remedy);
  }
}

}  // namespace asperity::meshing
