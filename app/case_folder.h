// The folder of a solved case: case.prm, checkpoint, history.csv and result.json are of one and the same
// inputs, and what is solved there is not lost unasked.
#pragma once

#include <filesystem>
#include <string>

#include "core/parameter_file.h"
#include "core/provenance.h"

namespace asperity {

/// What to do with a folder that holds a solution already.
enum class IfSolved { refuse, resume, overwrite };

/// What there is to do: solve from the beginning, go on after the last accepted step, or nothing.
enum class SolveStart { anew, go_on, finished };

/// A case about to be solved into a folder.
struct FolderedCase {
  Settings settings;
  std::filesystem::path file;  ///< where the settings come from; it may be the folder's own case.prm
  std::filesystem::path folder;
  Provenance provenance;  ///< of these settings and this program
};

/// Reads the folder and writes nothing. Throws InputError: with IfSolved::refuse if anything is solved there,
/// with IfSolved::resume if that has other inputs or, half solved, another program.
SolveStart check_folder(const FolderedCase& now, IfSolved if_solved);

/// Just before the first file of a solution is written: removes what an earlier solution left, unless this
/// one goes on with it, and writes case.prm. One that says the same case keeps its text; another one is kept
/// as case_given.prm if a person wrote it.
void claim_folder(const FolderedCase& now, SolveStart start);

/// case.prm: every entry, headed by where it comes from.
std::string case_text(const Settings& complete, const Provenance& provenance);

/// What the folder's result.json says it comes from; empty where it does not or is not complete.
Provenance provenance_of_result(const std::filesystem::path& folder);

/// "it was solved with Mesh/Layers = 4, and now it is 6": the first entry in which the folder's case.prm
/// differs, or that a file has changed that it names.
std::string difference_from_folder(const FolderedCase& now);

}  // namespace asperity
