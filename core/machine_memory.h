// How much memory a program may still take.
#pragma once

#include <istream>

namespace asperity {

/// Of this machine, or of the control group that limits its processes, whichever is less [byte]; infinite
/// where the system does not say.
double available_memory();

/// MemAvailable of /proc/meminfo [byte]; infinite where it is not there.
double memory_of_meminfo(std::istream& meminfo);

/// What a control group of Linux still allows: memory.max less what memory.stat counts as `anon` [byte], for
/// cached files give way; infinite without a limit.
double memory_of_group(std::istream& largest, std::istream& statistics);

}  // namespace asperity
