// Files that are whole or absent: written under a temporary name beside the target, flushed, then renamed.
#pragma once

#include <filesystem>
#include <string>

namespace asperity {

/// Replaces `path` by `content` in one step (also across kill -9); a link stays, what it names is replaced.
/// What is no file (a FIFO, a device, this program's own standard output) is written through instead. Throws
/// WorkError naming the path if writing, flushing or closing fails, InputError if the path is a folder or a
/// socket.
void write_file_atomically(const std::filesystem::path& path, const std::string& content);

/// Content of a file or pipe. Throws InputError naming the path, also for a folder, a device, or more than
/// read_limits::largest_file.
std::string read_file(const std::filesystem::path& path);

}  // namespace asperity
