// Previews of a study's cases, by the program that meshes and solves (app/preview_command.cc).
#pragma once

#include <functional>
#include <string>

#include "app/study.h"

namespace asperity {

/// preview.json of a case of the study, which must outlive it; several threads may call it at once. The call
/// throws InputError where the case cannot be previewed.
std::function<std::string(const StudyCase&)> previews_of_cases(const Study& study);

}  // namespace asperity
