#include "core/motion_program.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <regex>

#include "core/error.h"
#include "core/nearest_name.h"
#include "core/quantity.h"
#include "core/text_pieces.h"

namespace asperity {
namespace {

const std::string example = "slide 200 nm and spin 20 mrad; roll 30 mrad in 12 steps";

/// The value as one of two dimensions, and which; a plain number is the first.
std::pair<double, bool> either(const std::string& text, Dimension first, Dimension second) {
  try {
    return {parse_quantity(text, first), true};
  } catch (const InputError&) {
  }
  try {
    return {parse_quantity(text, second), false};
  } catch (const InputError&) {
    throw InputError("'" + text + "' is neither in " + si_symbol(first) + " nor in " + si_symbol(second));
  }
}

struct Word {
  std::string name;
  std::function<void(ProgramPart&, const std::string&)> read;
};

const std::vector<Word>& words() {
  static const std::vector<Word> words{
      {"press",
       [](ProgramPart& part, const std::string& text) {
         const auto [value, is_force] = either(text, Dimension::force, Dimension::length);
         (is_force ? part.load : part.approach) = value;
       }},
      {"slide across",
       [](ProgramPart& part, const std::string& text) {
         part.slide_across += parse_quantity(text, Dimension::length);
       }},
      {"slide", [](ProgramPart& part,
                   const std::string& text) { part.slide += parse_quantity(text, Dimension::length); }},
      {"roll",
       [](ProgramPart& part, const std::string& text) {
         const auto [value, is_angle] = either(text, Dimension::angle, Dimension::length);
         (is_angle ? part.roll : part.rolled_arc) += value;
       }},
      {"spin", [](ProgramPart& part,
                  const std::string& text) { part.spin += parse_quantity(text, Dimension::angle); }},
      {"indenter",
       [](ProgramPart& part, const std::string& text) {
         part.rolled_arc += 0.5 * parse_quantity(text, Dimension::length);
       }},
      {"hold", [](ProgramPart& part, const std::string& text) {
         part.duration = parse_quantity(text, Dimension::time);
         if (!(part.duration > 0) || std::isinf(part.duration))
           throw InputError("'hold " + text + "': give a time above 0");
       }}};
  return words;
}

void read_motion(const std::string& text, ProgramPart& part) {
  std::vector<std::string> names;
  for (const auto& word : words()) {
    if (text.rfind(word.name + " ", 0) == 0)
      return word.read(part, trimmed(text.substr(word.name.size() + 1)));
    names.push_back(word.name);
  }
  const std::string meant = nearest_name(text.substr(0, text.find(' ')), names);
  throw InputError("'" + text + "' is not a motion" +
                   (meant.empty() ? "" : "; did you mean '" + meant + "'?") + "; write for example '" +
                   example + "'");
}

/// Reads "at V" and "in N steps" at the end of a part; returns what stands before.
std::string without_suffixes(const std::string& piece, ProgramPart& part) {
  static const std::regex steps(R"(^(.*\S)\s+in\s+(\d+)\s+steps?$)"), speed(R"(^(.*\S)\s+at\s+(\S.*)$)");
  std::string motions = piece;
  std::smatch found;
  if (std::regex_match(piece, found, steps)) {
    part.steps = static_cast<int>(std::strtol(found[2].str().c_str(), nullptr, 10));
    if (part.steps < 1 || part.steps > 100000)
      throw InputError("'" + piece + "': give between 1 and 100000 steps");
    motions = trimmed(found[1].str());
  }
  const std::string without_steps = motions;
  if (std::regex_match(without_steps, found, speed)) {
    part.speed = parse_quantity(found[2].str(), Dimension::speed);
    if (!(part.speed > 0) || std::isinf(part.speed))
      throw InputError("'" + piece + "': give a speed above 0");
    motions = trimmed(found[1].str());
  }
  return motions;
}

}  // namespace

std::vector<ProgramPart> parse_motion_program(const std::string& text) {
  std::vector<ProgramPart> program;
  if (trimmed(text).empty()) return program;
  constexpr std::size_t longest = 10000;  // characters: std::regex recurses from one to the next
  if (text.size() > longest)
    throw InputError("a program of motions has at most " + std::to_string(longest) + " characters, not " +
                     std::to_string(text.size()));
  for (const std::string& between : pieces_of(text, ";")) {
    const std::string piece = trimmed(between);
    if (piece.empty()) continue;
    ProgramPart part;
    const std::string motions = without_suffixes(piece, part);
    for (const std::string& motion : pieces_of(motions, " and ")) read_motion(trimmed(motion), part);
    program.push_back(part);
  }
  return program;
}

std::string objection_to_program(const ExperimentInput& e) {
  if (e.type != Motion::program)
    return e.program.empty() ? "" : "Experiment/Program is given but Type is another; set Type = program";
  const auto parts = parse_motion_program(e.program);
  if (parts.empty())
    return "Experiment/Type = program needs Experiment/Program, e.g. 'slide 200 nm and spin 20 mrad; roll 30 "
           "mrad'";
  if (e.cycles > 1)
    return "a program is moved through once: write its cycles out in Experiment/Program and set Cycles = 1";
  const bool by_force = e.control == ExperimentInput::Control::force;
  const double largest_load = by_force ? e.normal_load : e.normal_approach;
  for (const auto& part : parts) {
    if (by_force ? part.approach.has_value() : part.load.has_value())
      return by_force ? "Experiment/Program presses to an approach, but Control is force; give a normal "
                        "load, e.g. 'press 50 uN'"
                      : "Experiment/Program presses to a load, but Control is displacement; give an "
                        "approach, e.g. 'press 5 nm'";
    const auto load = by_force ? part.load : part.approach;
    const Dimension dimension = by_force ? Dimension::force : Dimension::length;
    if (load && !(*load > 0 && *load <= largest_load))
      return "Experiment/Program presses to " + format_quantity(*load, dimension) +
             "; give more than 0 and at most the " + format_quantity(largest_load, dimension) +
             " that the particle is first pressed to, or raise those";
  }
  return "";
}

}  // namespace asperity
