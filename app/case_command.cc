#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include "app/case_declaration.h"
#include "app/equations_option.h"

namespace asperity {

void add_case_commands(CLI::App& app) {
  app.add_subcommand("case-template", "Print a case file with every entry, documented in place")
      ->callback([] { std::cout << case_template(); });
  const auto is_typeset = std::make_shared<bool>(false);
  CLI::App* reference =
      app.add_subcommand("case-reference", "Print the reference manual of case files (Markdown)");
  add_typeset(*reference, *is_typeset);
  reference->callback([is_typeset] { std::cout << case_reference(equations_of(*is_typeset)); });
}

}  // namespace asperity
