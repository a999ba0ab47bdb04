// Files that are whole or absent: written under a temporary name beside the target, flushed, then renamed.
#pragma once

#include <filesystem>
#include <string>

namespace asperity {

/// Replaces `path` by `content` in one step (also across kill -9). Throws WorkError naming the path.
void write_file_atomically(const std::filesystem::path& path, const std::string& content);

/// Content of a file or pipe. Throws InputError naming the path, also for a folder, a device, or more than
/// read_limits::largest_file.
std::string read_file(const std::filesystem::path& path);

}  // namespace asperity
