// Titles, materials and paths that would be code in an engine's input: none of them is. Each language is read
// as its own program reads it, and the engines that are installed run what was written.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "core/error.h"
#include "engines/engine_input.h"
#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::canonical_contact;
using test::Liggghts;
using test::message_of;
using test::number_after;

/// Each would create the file "pwned", end the run or swallow a line of it, in at least one of the languages.
const std::vector<std::string>& hostile_texts() {
  static const std::vector<std::string> texts{
      "harmless",
      "x\nshell touch pwned",
      "x\rshell touch pwned",
      "x\r\nshell touch pwned\r\n",
      "x\v\fshell touch pwned",
      "x\u0085\u2028\u2029shell touch pwned",
      std::string("x\0y", 3),
      "x\n__import__('os').system('touch pwned')",
      "x')); __import__('os').system('touch pwned'); ((('",
      "'\n\"\"\"\n'''\n__import__('os').system('touch pwned')\n#",
      "coding: utf-7 +AAo-__import__('os').system('touch pwned')+AAo-",
      "coding=utf_7",
      "\"\"\"",
      "ends with a continuation &",
      "ends with a continuation & ",
      "$x ${nope} $(1/0) ${shell}",
      "ends with a backslash \\",
      "ends with a backslash and a blank \\ ",
      "ends with a trigraph ?\?/",
      "*/ #error pwned /*",
      "\"}], \"pwned\": [{\"",
      "no UTF-8 \xff\xc0\x8a",
      "\u202egnp.exe \ufeff",
      "#pragma\n#include \"/etc/passwd\"",
      "{\n% $ ` ; | && rm",
  };
  return texts;
}

ContactParameters record_with(const std::string& text) {
  ContactParameters p = canonical_contact();
  p.title = p.file = text;
  p.particle.material = text;
  p.target.material = text + "2";
  p.sliding_friction->provenance = text;
  return p;
}

std::string input_with(const std::string& engine, const std::string& text) {
  EngineInputOptions options;
  options.load = 1e-4;
  return engine_input(engine, record_with(text), options);
}

/// Commands as LAMMPS reads them: '&' at the end and an odd number of triple quotes go on in the next line,
/// then comments are cut.
std::string lammps_commands(const std::string& text) {
  std::istringstream lines(text);
  std::string commands;
  for (std::string line, next; std::getline(lines, line);) {
    const auto continues = [&] {
      int quotes = 0;
      for (auto at = line.find("\"\"\""); at != std::string::npos; at = line.find("\"\"\"", at + 3)) ++quotes;
      const auto last = line.find_last_not_of(" \t\r\v\f");
      return quotes % 2 == 1 || (last != std::string::npos && line[last] == '&');
    };
    while (continues() && std::getline(lines, next)) line += next;
    const std::string command = line.substr(0, line.find('#'));
    if (command.find_first_not_of(' ') != std::string::npos) commands += command + "\n";
  }
  return commands;
}

/// What a C++ compiler keeps: trigraphs replaced, lines spliced (with blanks behind the backslash, too),
/// comments cut.
std::string cplusplus_code(std::string text) {
  for (auto at = text.find("?\?/"); at != std::string::npos; at = text.find("?\?/"))
    text.replace(at, 3, "\\");
  std::istringstream lines(text);
  std::string code;
  for (std::string line, next; std::getline(lines, line);) {
    const auto last = [&] { return line.find_last_not_of(" \t"); };
    while (last() != std::string::npos && line[last()] == '\\' && std::getline(lines, next))
      line = line.substr(0, last()) + next;
    const std::string kept = line.substr(0, line.find("//"));
    if (!kept.empty()) code += kept + "\n";
  }
  return code;
}

TEST(HostileText_analytic, leaves_visible_ascii_on_as_many_lines_as_harmless_text_in_all_six) {
  for (const auto& engine : engine_input_names()) {
    const std::string harmless = input_with(engine, "harmless");
    for (const auto& text : hostile_texts()) {
      SCOPED_TRACE(engine + ": " + text);
      const std::string input = input_with(engine, text);
      EXPECT_EQ(std::count(input.begin(), input.end(), '\n'),
                std::count(harmless.begin(), harmless.end(), '\n'));
      for (const char c : input) ASSERT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7f)) << static_cast<int>(c);
    }
  }
}

TEST(HostileText_analytic, commands_and_code_are_those_of_a_harmless_title) {
  for (const auto& text : hostile_texts()) {
    SCOPED_TRACE(text);
    for (const std::string engine : {"lammps", "liggghts"})
      EXPECT_EQ(lammps_commands(input_with(engine, text)), lammps_commands(input_with(engine, "harmless")));
    EXPECT_EQ(cplusplus_code(input_with("mercurydpm", text)),
              cplusplus_code(input_with("mercurydpm", "harmless")));
  }
}

TEST(HostileText_analytic, no_comment_of_python_chooses_an_encoding) {
  for (const auto& text : hostile_texts()) {
    std::istringstream lines(input_with("yade", text));
    for (std::string line; std::getline(lines, line);) {
      const bool declares =
          line.find("coding:") != std::string::npos || line.find("coding=") != std::string::npos;
      EXPECT_FALSE(line[0] == '#' && declares) << line;
    }
  }
}

TEST(HostileText_analytic, kratos_reads_the_names_back_and_nothing_else) {
  const auto harmless = nlohmann::json::parse(input_with("kratos", "harmless"));
  for (const auto& text : hostile_texts()) {
    if (text.find('\xff') != std::string::npos) continue;  // cannot be a string of JSON
    auto json = nlohmann::json::parse(input_with("kratos", text));
    EXPECT_EQ(json["materials"][0]["material_name"], text);
    EXPECT_EQ(json["material_relations"][0]["material_names_list"][0], text);
    EXPECT_EQ(json["material_relations"][0]["Variables"], harmless["material_relations"][0]["Variables"]);
    for (const auto& [key, value] : json.items()) EXPECT_TRUE(harmless.contains(key)) << key;
  }
}

TEST(HostileText_analytic, number_that_is_none_is_refused) {
  ContactParameters p = canonical_contact();
  p.particle.radius = 1e300;
  p.rolling_stiffness->value = 1e300;
  EXPECT_NE(message_of<InputError>([&] { engine_input("yade", p, {}); }).find("beyond what a computer holds"),
            std::string::npos);
}

/// What a program prints that runs `input`, and whether the file "pwned" came into being.
struct Outcome {
  std::string output;
  bool was_attacked = false;
};

Outcome outcome_of(const std::vector<std::string>& command, const std::string& file,
                   const std::string& input) {
  const test::TemporaryFolder folder;
  folder.write(file, input);
  run_program(command, folder.path, "log", std::chrono::seconds(120));
  std::ifstream log(folder.path / "log");
  return {{std::istreambuf_iterator<char>(log), {}}, std::filesystem::exists(folder.path / "pwned")};
}

/// Forces that a program printed, one per input.
std::vector<double> forces_in(const std::string& output) {
  std::vector<double> forces;
  const std::string label = "\nforce: ";
  for (auto at = output.find(label); at != std::string::npos; at = output.find(label, at + 1))
    forces.push_back(number_after(output.substr(at), label));
  return forces;
}

/// All inputs in one run of the program, each after `clear`: a text that swallows or adds a line is missing
/// its force, or prints another.
TEST(HostileText_other_code, lammps_and_liggghts_run_what_was_written_and_nothing_more) {
  const Lammps lammps;
  const Liggghts liggghts;
  if (find_program(lammps.executable()).empty() || find_program(liggghts.executable()).empty())
    GTEST_SKIP() << "LAMMPS or LIGGGHTS is not installed: apt-get install lammps liggghts";
  const std::string measured =
      "variable f equal fz[1]\nthermo_style custom step v_f\nrun 0\nprint \"force: ${f}\"\n";
  std::string for_lammps, for_liggghts;
  for (const auto& text : hostile_texts()) {
    for_lammps +=
        "clear\nunits si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify "
        "vel yes\n"
        "region box block -4e-5 4e-5 -4e-5 4e-5 -1e-7 4e-5\ncreate_box 1 box\nneighbor 1e-6 bin\npair_style "
        "granular\n"
        "pair_coeff * * hertz 1 0 tangential linear_nohistory 0 0\ncreate_atoms 1 single 0 0 8.494e-6\n"
        "set group all diameter 1.7e-5 density 2230\n" +
        input_with("lammps", text) + measured;
    std::string input = input_with("liggghts", text);
    const auto hard = input.find("hard_particles yes");
    input = input.substr(0, hard) + input.substr(input.find('\n', hard) + 1);
    for_liggghts +=
        "clear\nhard_particles yes\natom_style granular\natom_modify map array\nboundary f f f\nnewton "
        "off\ncommunicate single vel yes\nunits si\n"
        "region reg block -2e-5 2e-5 -2e-5 2e-5 -1e-7 4e-5 units box\ncreate_box 2 reg\nneighbor "
        "1e-6 bin\nneigh_modify delay 0\n" +
        input +
        "create_atoms 1 single 0 0 8.494e-6 units box\nset group all diameter 17e-6 density "
        "2230\nfix move all nve\n" +
        measured;
  }
  const double force = canonical_contact().hertz().force(6e-9);
  for (const auto& [program, input, tolerance] :
       {std::tuple{"lmp", for_lammps, 1e-5}, std::tuple{"liggghts", for_liggghts, 1e-3}}) {
    const Outcome outcome =
        outcome_of({find_program(program).string(), "-in", "in", "-log", "none"}, "in", input);
    EXPECT_FALSE(outcome.was_attacked) << program;
    const std::vector<double> forces = forces_in(outcome.output);
    ASSERT_EQ(forces.size(), hostile_texts().size()) << outcome.output;
    for (std::size_t i = 0; i < forces.size(); ++i)
      EXPECT_NEAR(forces[i] / force, 1, tolerance) << program << ": " << hostile_texts()[i];
  }
}

/// Python without YADE reads the same language, in a fraction of the time: the input, then what it made of
/// the two names.
TEST(HostileText_other_code, python_gives_the_names_back_and_runs_nothing_more) {
  const auto python = find_program("python3");
  if (python.empty()) GTEST_SKIP() << "Python is not installed: apt-get install python3";
  for (const auto& text : hostile_texts()) {
    if (text.find('\xff') != std::string::npos) continue;  // bytes become characters
    SCOPED_TRACE(text);
    const Outcome outcome =
        outcome_of({python.string(), "input.py"}, "input.py",
                   input_with("yade", text) +
                       "\nprint('name: ' + PARTICLE.encode().hex() + ' end', len(asperity_contacts))\n");
    std::string hex;
    for (const char c : text) {
      char digits[3];
      std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
      hex += digits;
    }
    EXPECT_NE(outcome.output.find("name: " + hex + " end 1"), std::string::npos) << outcome.output;
    EXPECT_FALSE(outcome.was_attacked);
  }
}

TEST(HostileText_other_code, yade_runs_with_hostile_labels) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  const std::string text = "x\n')); __import__('os').system('touch pwned'); \u2028 coding: utf-7 \\";
  const Outcome outcome =
      outcome_of({find_program("yade").string(), "-n", "-x", "in.py"}, "in.py", input_with("yade", text) + R"(
from yade import *
import os, sys
R, d = 8.5e-6, 6e-9
def material(label): return O.materials.append(FrictMat(young=1e9, poisson=0.2, frictionAngle=0.1,
    density=2230, label=label))
O.bodies.append(utils.sphere((0, 0, -1e5*R), 1e5*R, material=material(TARGET), fixed=True))
b = O.bodies.append(utils.sphere((0, 0, R - d), R, material=material(PARTICLE)))
O.dt = 1e-9
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
    [Ip2_FrictMat_FrictMat_MindlinPhys()], [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),
    PyRunner(command='asperity_step()', iterPeriod=1, initRun=True), NewtonIntegrator(damping=0)]
O.run(1, True)
print('force: %.12g end' % O.forces.f(b)[2])
sys.stdout.flush(); os._exit(0)
)");
  EXPECT_NEAR(number_after(outcome.output, "force: ") / canonical_contact().hertz().force(6e-9), 1, 1e-4)
      << outcome.output;
  EXPECT_FALSE(outcome.was_attacked);
}

TEST(HostileText_other_code, compiler_sees_the_code_of_a_harmless_title) {
  const auto compiler = find_program("c++");
  if (compiler.empty()) GTEST_SKIP() << "no C++ compiler is installed: apt-get install g++";
  std::string all;
  for (const auto& text : hostile_texts()) {
    std::string input = input_with("mercurydpm", text);
    const auto include = input.find("\n#include <Species");
    input.erase(include, input.find('\n', include + 1) - include);
    all += "BEGIN\n" + input;
  }
  const Outcome outcome =
      outcome_of({compiler.string(), "-std=c++14", "-trigraphs", "-w", "-E", "-P", "in.cc"}, "in.cc", all);
  std::istringstream lines(outcome.output);
  std::vector<std::string> code(1);
  for (std::string line; std::getline(lines, line);)
    line == "BEGIN" ? code.push_back("") : (void)(code.back() += line + "\n");
  ASSERT_EQ(code.size(), hostile_texts().size() + 1) << outcome.output;
  for (std::size_t i = 2; i < code.size(); ++i) EXPECT_EQ(code[i], code[1]) << hostile_texts()[i - 1];
  EXPECT_NE(code[1].find("contact->setSlidingFrictionCoefficient("), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace asperity
