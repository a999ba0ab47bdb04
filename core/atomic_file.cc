#include "core/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>
#include <vector>

#include "core/error.h"
#include "core/read_limits.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// How long a FIFO may have no reader before it is refused.
constexpr auto wait_for_reader = std::chrono::seconds(5);
constexpr auto poll_interval = std::chrono::milliseconds(20);

[[noreturn]] void fail(const std::string& what, const fs::path& path, int error) {
  throw WorkError(what + " '" + path.string() + "': " + std::strerror(error) +
                  "; check space and permissions");
}

/// A file descriptor that is closed on the way out of an error; after success, close() says whether that
/// worked, too.
class OpenFile {
 public:
  OpenFile(int descriptor, fs::path path) : descriptor_(descriptor), path_(std::move(path)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  void write(const std::string& content) const {
    std::size_t written = 0;
    while (written < content.size()) {
      const ssize_t count = ::write(descriptor_, content.data() + written, content.size() - written);
      if (count < 0 && errno != EINTR) fail("cannot write", path_, errno);
      if (count > 0) written += static_cast<std::size_t>(count);
    }
  }

  /// To the disk. Pipes, devices and the folders of some file systems have none to be flushed to.
  void flush() const {
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS)
      fail("cannot flush", path_, errno);
  }

  void close() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    // Also after EINTR the descriptor is closed on Linux.
    if (::close(descriptor) != 0 && errno != EINTR) fail("cannot close", path_, errno);
  }

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
  fs::path path_;
};

/// While it lives, a reader that goes away is an error of writing and not the end of this program.
class IgnoreBrokenPipe {
 public:
  IgnoreBrokenPipe() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &before_);
  }
  ~IgnoreBrokenPipe() { ::sigaction(SIGPIPE, &before_, nullptr); }
  IgnoreBrokenPipe(const IgnoreBrokenPipe&) = delete;
  IgnoreBrokenPipe& operator=(const IgnoreBrokenPipe&) = delete;

 private:
  struct sigaction before_ {};
};

/// A FIFO or device, opened as it is. A FIFO that nobody reads would otherwise block for ever.
int open_to_write_through(const fs::path& path, bool is_fifo) {
  const auto start = std::chrono::steady_clock::now();
  int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  while (file < 0 && errno == ENXIO && is_fifo &&
         std::chrono::steady_clock::now() - start < wait_for_reader) {
    std::this_thread::sleep_for(poll_interval);
    file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  }
  if (file < 0 && errno == ENXIO && is_fifo)
    throw WorkError("no program reads from the FIFO '" + path.string() + "'; start its reader first");
  if (file < 0) fail("cannot open", path, errno);
  ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
  return file;
}

void write_through(int descriptor, const fs::path& path, const std::string& content) {
  const IgnoreBrokenPipe ignore;
  OpenFile file(descriptor, path);
  file.write(content);
  file.flush();
  file.close();
}

/// This program's standard output or error (as /dev/stdout names it), whatever it is; -1: neither.
int own_stream(const struct stat& target) {
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat own {};
    if (::fstat(stream, &own) == 0 && own.st_dev == target.st_dev && own.st_ino == target.st_ino)
      return stream;
  }
  return -1;
}

/// Where a path leads through links, also if there is nothing yet.
fs::path behind_links(fs::path path) {
  constexpr int most_links = 40;  // as the kernel has it
  std::error_code none;
  for (int i = 0; i < most_links; ++i) {
    if (!fs::is_symlink(fs::symlink_status(path, none))) return path;
    const fs::path target = fs::read_symlink(path);
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  throw InputError("'" + path.string() + "' is a link that leads to itself; name a file");
}

void flush_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // a folder that may be written to and not read
  OpenFile opened(descriptor, folder);
  opened.flush();
  opened.close();
}

void replace(const fs::path& path, const std::string& content, mode_t mode) {
  const fs::path temporary = path.string() + ".tmp" + std::to_string(::getpid());
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) fail("cannot create", temporary, errno);
  try {
    OpenFile file(descriptor, temporary);
    if (mode != 0) ::fchmod(descriptor, mode);
    file.write(content);
    file.flush();
    file.close();
    if (::rename(temporary.c_str(), path.c_str()) != 0)
      fail("cannot rename '" + temporary.string() + "' to", path, errno);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  flush_folder(path.parent_path());
}

}  // namespace

void write_file_atomically(const fs::path& path, const std::string& content) {
  struct stat target {};
  if (::stat(path.c_str(), &target) != 0) return replace(behind_links(path), content, 0);
  if (S_ISDIR(target.st_mode)) throw InputError("'" + path.string() + "' is a folder; name a file to write");
  if (S_ISSOCK(target.st_mode)) throw InputError("'" + path.string() + "' is a socket; name a file to write");
  if (const int stream = own_stream(target); stream >= 0) {
    const int copy = ::dup(stream);
    if (copy < 0) fail("cannot open", path, errno);
    return write_through(copy, path, content);
  }
  if (!S_ISREG(target.st_mode))
    return write_through(open_to_write_through(path, S_ISFIFO(target.st_mode)), path, content);
  constexpr mode_t permissions = 07777;
  replace(behind_links(path), content, target.st_mode & permissions);
}

std::string read_file(const fs::path& path) {
  if (fs::is_directory(path)) throw InputError("'" + path.string() + "' is a folder, not a file");
  std::error_code none;
  const auto status = fs::status(path, none);
  if (fs::is_character_file(status) || fs::is_block_file(status))
    throw InputError("'" + path.string() + "' is a device, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError("cannot read '" + path.string() + "': " + std::strerror(errno));
  const auto check_size = [&](std::uint64_t bytes) {
    if (bytes > read_limits::largest_file)
      throw InputError("'" + path.string() + "' holds more than the " +
                       std::to_string(read_limits::largest_file >> 30) +
                       " GiB that are read of one file; pass a part of it");
  };
  std::string content;
  if (fs::is_regular_file(status)) {
    const auto size = fs::file_size(path, none);
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
