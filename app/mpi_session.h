// MPI for the commands that solve: started before the work, ended after it, also when it fails.
#pragma once

#include <functional>
#include <string>

namespace asperity {

/// Runs `work` between MPI's start and end and passes on what it throws. With several ranks, one whose work
/// fails alone ends all of them (the others would wait for it for ever). `threads`: per rank; 0: all cores of
/// the machine divided by the ranks on it.
void with_mpi(int threads, const std::function<void()>& work);

/// True on the one rank that talks to the user; known before and after MPI runs.
bool is_speaking_rank();

/// Prints a line at once, on that rank.
void say(const std::string& line);

}  // namespace asperity
