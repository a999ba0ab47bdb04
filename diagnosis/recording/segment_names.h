// What the names in the column `segment` mean, and what tells the direction where they do not.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace asperity {

struct Recording;
struct RecordingTable;

/// "load", "hold", "unload", "forward" or "backward", in whichever case it is written; none: the name means
/// nothing here, and what its samples are is read off the driven motion.
std::optional<std::string> segment_meant_by(const std::string& written);

/// Whether rows of a series went backward, one answer for each: as their names say. Where none is named
/// forward or backward, friction says it: rows whose lateral force is below zero by three tenths of what is
/// usual for their normal force (the median) went backward.
std::vector<bool> rows_backward(const RecordingTable& table);

/// Which names of segments mean nothing, and what was read off the motion or the signs of forces in their
/// place; empty: nothing was.
std::vector<std::string> remarks_on_segments(const Recording& recording);

}  // namespace asperity
