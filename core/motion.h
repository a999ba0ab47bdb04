// What moves a contact: the one list that cases, histories, laws, engines' experiments and recordings go by.
#pragma once

#include <optional>
#include <string>

namespace asperity {

enum class Motion {
  normal,   ///< pressed along the normal
  sliding,  ///< shifted along the surface
  rolling,  ///< rolled over it
  torsion,  ///< spun about the normal
  rail,     ///< rolled and spun between the two slopes of a V-groove
  program,  ///< as a program of motions says (core/motion_program.h)
};

/// "normal", "sliding", ...: in case files, result.json and recordings.
std::string name_of(Motion motion);
/// Empty for any other name.
std::optional<Motion> motion_named(const std::string& name);

}  // namespace asperity
