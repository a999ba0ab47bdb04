// Case files, parameters of contacts, histories and results, and the texts within them.
#include "app/case_file.h"
#include "core/error.h"
#include "core/json_text.h"
#include "core/motion_program.h"
#include "core/quantity.h"
#include "core/topography_spec.h"
#include "engines/parameters/contact_parameters.h"
#include "results/history.h"
#include "results/solved_case.h"
#include "tests/fuzz/targets.h"

namespace asperity::fuzz {
namespace {

template <class Read>
std::function<void(const std::string&)> refusing(const Read& read) {
  return [read](const std::string& bytes) {
    try {
      read(bytes);
    } catch (const InputError&) {
    }
  };
}

void read_case_file(const std::string& bytes) {
  const FileInMemory file("case.prm", bytes);
  const Settings settings = read_settings(file.path);
  for (const auto& setting : settings) expect_utf8(setting.path() + setting.value);
  case_from_settings(settings, file.path);
}

void read_parameters(const std::string& bytes) {
  std::string again;
  try {
    again = to_json(parse_contact_parameters(parse_json(bytes, "p.json"), "p.json")).dump();
  } catch (const InputError&) {
    return;
  }
  parse_contact_parameters(parse_json(again, "p.json"),
                           "p.json");  // what is written is read, or this is a fault
}

void read_history_file(const std::string& bytes) {
  const FileInMemory file("history.csv", bytes);
  const History history = read_history(file.path);
  history_branches(history);
}

void read_result_file(const std::string& bytes) {
  History history;
  const FileInMemory table("history.csv", format_history(history)), result("result.json", bytes);
  read_solved_case(result.folder);
}

void read_quantity(const std::string& text) {
  std::vector<std::string> written;  // of the dimension at hand
  for (const Dimension dimension :
       {Dimension::none, Dimension::length, Dimension::force, Dimension::pressure, Dimension::time,
        Dimension::angle, Dimension::speed, Dimension::surface_energy, Dimension::area, Dimension::stiffness,
        Dimension::temperature, Dimension::voltage, Dimension::molar_volume}) {
    written.clear();
    try {
      written.push_back(format_quantity(parse_quantity(text, dimension), dimension));
      parse_quantity(written.back(), dimension);
    } catch (const InputError&) {
      expect(written.empty(), "a quantity is read as it is written");
    }
  }
}

void read_topography_entry(const std::string& text) {
  const TopographySpec topography(text);
  if (topography.generator())
    expect(TopographySpec(topography.canonical()).canonical() == topography.canonical(),
           "a surface is read as it is written");
}

}  // namespace

std::vector<Target> parameter_targets() {
  return {{"case_file", refusing(read_case_file)},
          {"parameters_json", read_parameters},
          {"history_csv", refusing(read_history_file)},
          {"result_json", refusing(read_result_file)},
          {"quantity", read_quantity},
          {"topography_entry", refusing(read_topography_entry)},
          {"motion_program", refusing([](const std::string& text) { parse_motion_program(text); })}};
}

}  // namespace asperity::fuzz
