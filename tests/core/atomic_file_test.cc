// Files are whole or absent; what is no file is written through; a disk that is full is said.
#include "core/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <future>

#include "core/error.h"
#include "core/output_folder.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using test::TemporaryFolder;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// A device of our own, never one of the system's; false where this user may not make one.
bool make_full_device(const fs::path& path) {
  constexpr unsigned memory_devices = 1, full = 7;  // as Linux numbers /dev/full
  return ::mknod(path.c_str(), S_IFCHR | 0666, makedev(memory_devices, full)) == 0;
}

}  // namespace

TEST(AtomicFile_analytic, replaces_a_file_and_leaves_nothing_beside_it) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "before");
  ::chmod(file.c_str(), 0600);
  write_file_atomically(file, "after");
  EXPECT_EQ(read_file(file), "after");
  EXPECT_EQ(files_in(folder.path), 1u);
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(AtomicFile_analytic, a_link_stays_a_link_and_what_it_names_is_written) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("elsewhere/file", "before"), link = folder.path / "link",
                 dangling = folder.path / "dangling";
  fs::create_symlink("elsewhere/file", link);
  fs::create_symlink("elsewhere/new", dangling);
  write_file_atomically(link, "after");
  write_file_atomically(dangling, "made");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_symlink(dangling));
  EXPECT_EQ(read_file(file), "after");
  EXPECT_EQ(read_file(folder.path / "elsewhere" / "new"), "made");
  const fs::path loop = folder.path / "loop";
  fs::create_symlink("loop", loop);
  EXPECT_NE(message_of<InputError>([&] { write_file_atomically(loop, "x"); }).find("leads to itself"),
            std::string::npos);
}

TEST(AtomicFile_analytic, a_fifo_is_written_through) {
  const TemporaryFolder folder;
  const fs::path fifo = folder.path / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const std::string content(1 << 20, 'x');  // more than a pipe holds
  auto reader = std::async(std::launch::async, [&] { return read_file(fifo); });
  write_file_atomically(fifo, content);
  EXPECT_EQ(reader.get(), content);
  EXPECT_TRUE(fs::is_fifo(fifo));
  EXPECT_EQ(files_in(folder.path), 1u);
}

TEST(AtomicFile_analytic, a_fifo_whose_reader_goes_away_is_an_error_and_not_the_end) {
  const TemporaryFolder folder;
  const fs::path fifo = folder.path / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  auto reader = std::async(std::launch::async, [&] { ::close(::open(fifo.c_str(), O_RDONLY)); });
  EXPECT_NE(message_of<WorkError>([&] {
              write_file_atomically(fifo, std::string(1 << 20, 'x'));
            }).find("cannot write"),
            std::string::npos);
  reader.get();
  EXPECT_NE(
      message_of<WorkError>([&] { write_file_atomically(fifo, "x"); }).find("no program reads from the FIFO"),
      std::string::npos);
  EXPECT_TRUE(fs::is_fifo(fifo));
}

TEST(AtomicFile_analytic, a_device_is_written_through_and_stays_one) {
  const TemporaryFolder folder;
  const fs::path device = folder.path / "full", link = folder.path / "link";
  if (!make_full_device(device)) GTEST_SKIP() << "only root may make a device";
  if (::open(device.c_str(), O_WRONLY) < 0) GTEST_SKIP() << "this file system opens no devices";
  fs::create_symlink(device, link);
  for (const fs::path& target : {device, link}) {
    EXPECT_NE(
        message_of<WorkError>([&] { write_file_atomically(target, "x"); }).find("No space left on device"),
        std::string::npos);
    EXPECT_TRUE(fs::is_character_file(device));
  }
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(files_in(folder.path), 2u);
}

TEST(AtomicFile_analytic, a_file_that_cannot_be_completed_leaves_the_one_before_and_nothing_else) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "before");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};  // as a disk that fills up in the middle
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_file_atomically(file, std::string(100000, 'x'));
    } catch (const WorkError& error) {
      ::_exit(std::string(error.what()).find("cannot write") == std::string::npos ? 2 : 1);
    }
    ::_exit(0);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(read_file(file), "before");
  EXPECT_EQ(files_in(folder.path), 1u);
}

TEST(AtomicFile_analytic, a_folder_is_refused_as_a_file_and_a_file_as_a_folder) {
  const TemporaryFolder folder;
  EXPECT_NE(message_of<InputError>([&] { write_file_atomically(folder.path, "x"); }).find("is a folder"),
            std::string::npos);
  const fs::path file = folder.write("file", "");
  EXPECT_NE(message_of<InputError>([&] { make_folder(file); }).find("is no folder"), std::string::npos);
  const fs::path link = folder.path / "link";
  fs::create_symlink("nowhere", link);
  EXPECT_NE(message_of<InputError>([&] { make_folder(link); }).find("is no folder"), std::string::npos);
  EXPECT_TRUE(fs::is_symlink(link));
}

}  // namespace asperity
