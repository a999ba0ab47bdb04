// The commands that mesh, solve or draw. They need deal.II, CGAL and VTK, some 240 shared libraries, and
// stand in a program of their own, asperity-solver, which asperity starts for them: other commands start at
// once.
#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace asperity {

/// Name of a command, and its line of help.
struct SolverCommand {
  const char *name, *says;
};

namespace solver_commands {
inline constexpr SolverCommand preview{"preview",
                                       "Say in seconds what a case will show, and the mesh that it needs"};
inline constexpr SolverCommand mesh{
    "mesh", "Write the meshes of a case; print quality, counts and memory to solve it"};
inline constexpr SolverCommand solve{"solve", "Solve one case: result.json, history.csv and fields"};
inline constexpr SolverCommand study{"study", "Solve a matrix of cases, several at a time"};
inline constexpr SolverCommand characterise{
    "characterise",
    "From a surface scan to the numbers and input of a discrete element model, in one command"};
inline constexpr SolverCommand report{"report", "Write report.html for a solved case or a study"};
}  // namespace solver_commands

/// For programs that are started from now on: OpenMP threads that wait for the others sleep, unless the
/// environment says otherwise. Spinning threads of several programs on the same cores keep each other from
/// working (two solvers on two cores took up to nine times as long). Waking costs some 50 us, which the few
/// long loops that OpenMP still shares (surfaces, searches) do not feel.
void let_threads_sleep();

/// asperity-solver beside this program, or in ../libexec/asperity. Throws WorkError where it is in neither.
std::filesystem::path solver_program();

/// A command of that name that goes on as asperity-solver with the arguments of this process. When it is
/// called, it throws WorkError where that program is neither beside this one nor in ../libexec/asperity.
void add_solver_command(CLI::App& app, const SolverCommand& command, char** argv);

}  // namespace asperity
