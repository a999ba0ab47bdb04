// What is fuzzed: each reader as a function of bytes, for libFuzzer (fuzz_readers.cc) and for the test that
// runs the corpus.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace asperity::fuzz {

/// One reader. `run` returns where the bytes are read or refused by an InputError; all else is a fault.
struct Target {
  std::string name;  ///< of the folder of its corpus, too
  std::function<void(const std::string& bytes)> run;
};

std::vector<Target> topography_targets();
std::vector<Target> recording_targets();
std::vector<Target> parameter_targets();

/// All of them.
std::vector<Target> targets();

/// Aborts, as libFuzzer expects of a fault, saying `what`.
void expect(bool holds, const char* what);

/// Aborts if `text` is no UTF-8: it goes into JSON.
void expect_utf8(const std::string& text);

/// A file of these bytes in memory (/dev/shm) for readers that take a path; written anew for each input.
struct FileInMemory {
  FileInMemory(const std::string& name, const std::string& bytes);
  std::string folder, path;
};

}  // namespace asperity::fuzz
