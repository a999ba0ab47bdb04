// The command lines of docs/commands.md, and how a test makes each of them cheap.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::test {

/// Command lines of the block under "## The program", without the comments behind them.
std::vector<std::string> lines_of_readme(const std::filesystem::path& readme);

struct ReadmeLine {
  std::string printed;  ///< as in docs/commands.md
  std::string added;    ///< arguments that make it cheap
  std::string how;      ///< what they do; empty: it runs as printed
  std::string says;     ///< in what it prints
  std::string leaves;   ///< a file, or empty
};

/// Lines that need what another of their group left stand behind it.
struct ReadmeGroup {
  std::string name;
  std::vector<ReadmeLine> lines;
};

const std::vector<ReadmeGroup>& groups_of_readme();

}  // namespace asperity::test
