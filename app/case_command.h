// asperity case-template, case-reference: how to write a case file.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_case_commands(CLI::App& app);

}  // namespace asperity
