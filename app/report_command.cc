#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "app/solver_commands.h"
#include "report/report.h"

namespace asperity {

void add_report_command(CLI::App& app) {
  const auto directory = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(solver_commands::report.name, solver_commands::report.says);
  command->add_option("DIR", *directory, "Folder that solve or study wrote")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->callback([directory] {
    write_report(*directory);
    std::cout << (std::filesystem::path(*directory) / "report.html").string() << std::endl;
  });
}

}  // namespace asperity
