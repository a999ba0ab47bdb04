// What a user adds to the solver in one file of his own is solved, written, resumed, explained and shown like
// what asperity has: own_column.cc, own_contact_field.cc, own_body_field.cc, own_fretting.cc. Nothing here or
// elsewhere includes or names these files' contents but by their registered names.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/case_declaration.h"
#include "app/case_file.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "fem/output/paraview_script.h"
#include "report/fields/field_files.h"
#include "report/report.h"
#include "results/solved_case.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace asperity {
namespace {

constexpr double amplitude = 8e-9, load = 100e-6, friction = 0.3;
constexpr int cycles = 1;

CaseInput fretting_case(const std::filesystem::path& folder, const std::string& experiment) {
  const std::string glass = "set Young modulus = 71 GPa\n set Poisson ratio = 0.17\nend\n";
  const std::filesystem::path file = folder / "case.prm";
  std::ofstream(file) << "set Title = <b>fretting & more</b>\nsubsection Particle\n set Radius = 8.5 um\n"
                      << glass << "subsection Substrate\n"
                      << glass << "subsection Interface\n set Friction coefficient = 0.3\nend\n"
                      << "subsection Experiment\n set Normal load = 100 uN\n set Load steps = 2\n"
                      << " set Unload = false\n"
                      << experiment << "end\n"
                      << "subsection Mesh\n set Interface spacing = 50 nm\nend\n"
                      << "subsection Output\n set Fields every = 1\nend\n";
  return read_case(file);
}

const std::string fretting = " set Type = fretting\n set Fretting amplitude = 8 nm\n";

/// Solved once for all tests.
const std::filesystem::path& solved() {
  static const test::TemporaryFolder folder;
  static const std::filesystem::path output = [] {
    test::solve_experiment(fretting_case(folder.path, fretting), folder.path / "solved");
    return folder.path / "solved";
  }();
  return output;
}

TEST(OwnColumn_analytic, stands_in_the_history_and_goes_on_when_resumed) {
  const double path = amplitude * (1 + 4 * cycles);
  const CsvTable history = read_csv(solved() / "history.csv");
  EXPECT_EQ(history.names.back(), "path_length [m]");
  EXPECT_NEAR(history.numbers("path_length [m]").back() / path, 1, 1e-6);

  struct Stop {};
  const test::TemporaryFolder folder;
  const CaseInput input = fretting_case(folder.path, fretting);
  SolveOptions options;
  options.output = folder.path / "cut";
  options.progress = [steps = 0](const std::string& line) mutable {
    if (line.rfind("step ", 0) == 0 && ++steps == 10) throw Stop();
  };
  EXPECT_THROW(solve_case(input, options), Stop);
  const auto resumed = test::solve_experiment(input, options.output, true);
  EXPECT_NEAR(resumed.history.numbers("path_length [m]").back() / path, 1, 1e-6);
}

TEST(OwnField_analytic, of_the_contact_reaches_coulombs_limit_where_all_slips) {
  const auto files = report::field_files(solved() / "interface.pvd");
  ASSERT_FALSE(files.empty());
  const auto ratio =
      report::interface_map(files.rbegin()->second.front(), "traction_ratio", 150e-9, 50).values;
  const auto slipping = std::count_if(ratio.begin(), ratio.end(),
                                      [](double value) { return std::abs(value - friction) < 1e-3; });
  EXPECT_EQ(slipping, static_cast<std::ptrdiff_t>(ratio.size()));
}

TEST(OwnField_analytic, of_the_bodies_is_that_of_the_stress_in_each_cell) {
  const auto files = report::field_files(solved() / "fields.pvd");
  ASSERT_FALSE(files.empty());
  const auto section = report::vertical_section(files.rbegin()->second, 10e-9);
  vtkDataArray *stress = section->GetCellData()->GetArray("stress"),
               *own = section->GetCellData()->GetArray("hydrostatic_pressure");
  ASSERT_TRUE(stress && own);
  ASSERT_GT(own->GetNumberOfTuples(), 100);
  double largest = 0, difference = 0;
  for (vtkIdType i = 0; i < own->GetNumberOfTuples(); ++i) {
    const double* s = stress->GetTuple(i);
    largest = std::max(largest, own->GetComponent(i, 0));
    difference = std::max(difference, std::abs(own->GetComponent(i, 0) + (s[0] + s[1] + s[2]) / 3));
  }
  EXPECT_GT(largest, 1e8);
  EXPECT_LT(difference, 1e-6 * largest);
}

/// The fields of a step, as VTK reads them.
vtkSmartPointer<vtkDataSet> read_fields(const std::filesystem::path& file) {
  vtkNew<vtkXMLGenericDataObjectReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return vtkDataSet::SafeDownCast(reader->GetOutput());
}

TEST(Fields_behaviour, say_units_title_load_and_path_and_run_on_with_the_path) {
  const CsvTable history = read_csv(solved() / "history.csv");
  const auto load_of = history.numbers("normal_force [N]");
  double furthest = 0;
  for (const std::string name : {"fields", "interface"}) {
    for (const auto& [step, files] : report::field_files(solved() / (name + ".pvd"))) {
      const auto data = read_fields(files.front());
      ASSERT_TRUE(data);
      vtkFieldData* notes = data->GetFieldData();
      EXPECT_NEAR(notes->GetArray("load [N]")->GetComponent(0, 0), load_of[step - 1], 1e-6 * load);
      EXPECT_EQ(notes->GetArray("step")->GetComponent(0, 0), step);
      auto* title = vtkStringArray::SafeDownCast(notes->GetAbstractArray("title"));
      ASSERT_TRUE(title);
      EXPECT_EQ(title->GetValue(0), "<b>fretting & more</b>");
      auto* units = vtkStringArray::SafeDownCast(notes->GetAbstractArray("units"));
      ASSERT_TRUE(units);
      EXPECT_GE(units->LookupValue(name == "fields" ? "von_mises [Pa]" : "pressure [Pa]"), 0);
      EXPECT_GE(units->LookupValue(name == "fields" ? "displacement [m]" : "gap [m]"), 0);
      if (name == "interface") continue;
      EXPECT_TRUE(data->GetPointData()->GetArray("plastic_strain_at_nodes"));
      // The driven plane, on top, moves as the particle's frame does.
      const double shift = notes->GetArray("axis x [m]")->GetComponent(0, 0);
      vtkIdType top = 0;
      for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
        if (data->GetPoint(n)[2] > data->GetPoint(top)[2]) top = n;
      EXPECT_NEAR(data->GetPointData()->GetArray("motion")->GetComponent(top, 0), shift, 1e-5 * amplitude);
      furthest = std::max(furthest, shift);
    }
    const std::string list = read_file(solved() / (name + ".pvd"));
    // Pressed in two steps, then to and fro: the nanometre of pressing, then the path.
    EXPECT_NE(list.find("timestep=\"0\""), std::string::npos);
    const double path = amplitude * (1 + 4 * cycles) / 1e-9;
    EXPECT_NE(list.find("timestep=\"" + std::to_string(std::lround(path)) + "\""), std::string::npos);
  }
  EXPECT_NEAR(furthest, amplitude, 1e-3 * amplitude);
  const std::string script = read_file(solved() / "show_in_paraview.py");
  EXPECT_EQ(script.find("@folder@"), std::string::npos);
  EXPECT_NE(script.find("fromhex('2f"), std::string::npos);  // an absolute path
  const std::string hostile = "/tmp/a'); import os #\n\"";
  EXPECT_EQ(fem::paraview_script(hostile).find("a');"), std::string::npos);
}

TEST(OwnExperiment_analytic, slides_to_and_fro_against_coulombs_friction) {
  const SolvedCase found = read_solved_case(solved());
  EXPECT_EQ(found.motion(), Motion::program);
  EXPECT_EQ(found.entries.text("Experiment/Type"), "fretting");
  const auto& shift = found.history.shift;
  EXPECT_NEAR(*std::max_element(shift.begin(), shift.end()) / amplitude, 1, 1e-9);
  EXPECT_NEAR(*std::min_element(shift.begin(), shift.end()) / amplitude, -1, 1e-9);
  const auto& force = found.history.lateral_force;
  EXPECT_NEAR(*std::max_element(force.begin(), force.end()) / (friction * load), 1, 0.01);
  EXPECT_NEAR(*std::min_element(force.begin(), force.end()) / (friction * load), -1, 0.01);
}

TEST(OwnExperiment_behaviour, is_a_choice_of_the_manual_and_refuses_what_is_not_its_own) {
  const std::string manual = case_reference();
  for (const char* said : {"program \\| fretting", "`Fretting amplitude`", "slide A; N times: slide -2 A"})
    EXPECT_TRUE(test::has(manual, said)) << said;
  EXPECT_TRUE(test::has(case_template(), "set Fretting amplitude = 0 m"));
  const test::TemporaryFolder other;
  const auto message = [&](const std::string& experiment) {
    return test::message_of<InputError>([&] { fretting_case(other.path, experiment); });
  };
  EXPECT_TRUE(test::has(message(" set Type = fretting\n"),
                        "needs Experiment/Fretting amplitude: give a length, e.g. 10 nm"));
  EXPECT_TRUE(test::has(message(" set Type = sliding\n set Fretting amplitude = 8 nm\n"),
                        "Experiment/Fretting amplitude is given but Type is another; set Type = fretting"));
  EXPECT_TRUE(test::has(message(fretting + " set Program = slide 5 nm\n"), "remove Program"));
  EXPECT_TRUE(test::has(message(" set Type = freting\n"), "did you mean 'fretting'?"));
}

TEST(OwnSolverParts_behaviour, are_explained_by_the_result_and_drawn_in_the_report) {
  const SolvedCase found = read_solved_case(solved());
  ASSERT_EQ(found.history.added.size(), 1u);
  EXPECT_EQ(found.history.added[0].values.size(), found.history.size());
  ASSERT_EQ(found.result->added_fields.size(), 2u);
  EXPECT_EQ(found.result->added_fields[0].label(), "hydrostatic_pressure [Pa]");
  EXPECT_EQ(found.result->added_fields[1].place, "contact");
  write_report(solved());
  const std::string page = read_file(solved() / "report.html");
  for (const char* said :
       {"Further columns of the history", "path of the particle along x since it began to move",
        "shear traction over contact pressure", "minus a third of the stress' trace",
        "The program of fretting: slide 8 nm in 4 steps; slide -16 nm", "then moved as fretting moves it"})
    EXPECT_TRUE(test::has(page, said)) << said;
}

}  // namespace
}  // namespace asperity
