// What a solved case says of the motion that a diagnosis drove it by.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "diagnosis/forward/forward_model.h"
#include "results/solved_case.h"

namespace asperity {

/// Fewer steps say nothing of a curve.
constexpr std::size_t least_steps_of_curve = 3;

constexpr const char* at_the_rim = "the contact came to the edge of the finely meshed region";

/// Throws WorkError: beyond that edge a solution is too soft.
[[noreturn]] void refuse_outgrown(const std::filesystem::path& folder);

/// Steps before the contact came to the edge of the finely meshed region: all, where it did not.
std::size_t steps_within_region(const History& history);

/// Its resistance is NaN where the contact did not slip as a whole, or roll steadily, on its path. Throws
/// WorkError where the contact outgrew its mesh.
SolvedMotion motion_of(const std::filesystem::path& folder, const MotionProtocol& protocol);

/// Of pressing, up to the edge of the finely meshed region; `ended_early`: why it is not complete. Throws
/// WorkError where it says too little, or does not state its error.
SolvedResponse response_of(const std::filesystem::path& folder, const std::string& ended_early);

/// Whether a solution tells the loading up to a force [N] in six steps or more.
bool tells_loading_up_to(const std::filesystem::path& folder, double force);

}  // namespace asperity
