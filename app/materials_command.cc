#include <CLI/CLI.hpp>

#include <iostream>

#include "app/commands.h"
#include "app/materials.h"

namespace asperity {

void add_materials_command(CLI::App& app) {
  app.add_subcommand("materials", "Print the materials that characterise knows by name (Markdown)")
      ->callback([] { std::cout << materials_page() << std::flush; });
}

}  // namespace asperity
