// The time of lateral traces whose table gives speeds and no time.
#pragma once

#include <string>
#include <vector>

namespace asperity {

struct Recording;
struct RecordingTable;
struct SampleRun;
struct Samples;

/// Whether the times of a table's samples are known: it has them, or, of a lateral trace, a speed above zero
/// in every row.
bool time_is_known(const Recording& recording, const RecordingTable& table);

/// Where the table of a lateral run gives speeds alone: fills its times with the path over the mean of the
/// neighbours' speeds [s].
void take_time_from_path(Samples& samples, const SampleRun& run);

/// Which traces give no time, and what that means; empty: all do.
std::vector<std::string> remarks_on_time(const Recording& recording);

}  // namespace asperity
