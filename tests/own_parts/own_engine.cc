// A discrete element engine of somebody's own, all of it: one line of friction.
#include "engines/engine_registry.h"
#include "engines/input_notes.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

std::string own_input(InputNotes& notes) { return "friction " + text_number(notes.sliding()) + "\n"; }

const RegisteredEngine entry{[] { return written_engine("own", "Own engine", {own_input}); }};

}  // namespace
}  // namespace asperity
