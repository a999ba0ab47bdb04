#include "core/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "core/error.h"
#include "core/read_limits.h"

namespace asperity {

void write_file_atomically(const std::filesystem::path& path, const std::string& content) {
  const std::filesystem::path temporary = path.string() + ".tmp" + std::to_string(::getpid());
  const auto fail = [&](const std::string& what) {
    throw WorkError(what + " '" + temporary.string() + "': " + std::strerror(errno) + "; check space and permissions");
  };
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0) fail("cannot create");
  std::size_t written = 0;
  while (written < content.size()) {
    const ssize_t count = ::write(file, content.data() + written, content.size() - written);
    if (count < 0) {
      ::close(file);
      fail("cannot write");
    }
    written += static_cast<std::size_t>(count);
  }
  ::fsync(file);
  ::close(file);
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error) throw WorkError("cannot rename '" + temporary.string() + "' to '" + path.string() + "': " + error.message());
}

std::string read_file(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) throw InputError("'" + path.string() + "' is a folder, not a file");
  std::error_code none;
  const auto status = std::filesystem::status(path, none);
  if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status))
    throw InputError("'" + path.string() + "' is a device, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError("cannot read '" + path.string() + "': " + std::strerror(errno));
  const auto check_size = [&](std::uint64_t bytes) {
    if (bytes > read_limits::largest_file)
      throw InputError("'" + path.string() + "' holds more than the " + std::to_string(read_limits::largest_file >> 30) +
                       " GiB that are read of one file; pass a part of it");
  };
  std::string content;
  if (std::filesystem::is_regular_file(status)) {
    const auto size = std::filesystem::file_size(path, none);
    check_size(none ? 0 : size);
    if (!none) content.reserve(size);
  }
  std::vector<char> piece(1 << 16);
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())), stream.gcount() > 0) {
    content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    check_size(content.size());
  }
  return content;
}

}  // namespace asperity
