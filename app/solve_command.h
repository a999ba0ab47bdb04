// asperity solve CASE.prm --output DIR [--set "Section/Entry=value"]... [--resume]: solves one case.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_solve_command(CLI::App& app);

}  // namespace asperity
