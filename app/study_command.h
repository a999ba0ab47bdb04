// asperity study STUDY.prm --output DIR [--resume]: solves a matrix of cases.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_study_command(CLI::App& app);

}  // namespace asperity
