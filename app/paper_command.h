// asperity paper: the paper's own analysis from its published numbers.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_paper_command(CLI::App& app);

}  // namespace asperity
