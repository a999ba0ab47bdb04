// asperity report DIR: report.html of a solved case or a study.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_report_command(CLI::App& app);

}  // namespace asperity
