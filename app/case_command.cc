#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <iostream>

#include "app/case_declaration.h"

namespace asperity {

void add_case_commands(CLI::App& app) {
  app.add_subcommand("case-template", "Print a case file with every entry, documented in place")
      ->callback([] { std::cout << case_template(); });
  app.add_subcommand("case-reference", "Print the reference manual of case files (Markdown)")->callback([] {
    std::cout << case_reference();
  });
}

}  // namespace asperity
