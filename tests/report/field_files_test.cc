// Before GoogleTest: <signal.h>, which it includes, has a macro si_value.
#include "report/fields/field_files.h"
#include "core/error.h"
#include "report/fields/case_fields.h"
#include "tests/report/synthetic_case.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>

namespace asperity::report {
namespace {

namespace fs = std::filesystem;

class FieldFiles_behaviour : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("asperity-fields-" + std::to_string(::getpid()));
    test::write_synthetic_case(made, folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  test::SyntheticCase made;
  fs::path folder;
};

TEST_F(FieldFiles_behaviour, a_collection_gives_steps_and_files_and_leaves_out_what_is_gone) {
  const auto files = field_files(folder / "fields.pvd");
  ASSERT_EQ(files.size(), 1u);
  ASSERT_EQ(files.count(8), 1u);
  fs::remove(files.at(8).front());
  EXPECT_TRUE(field_files(folder / "fields.pvd").empty());
  EXPECT_TRUE(field_files(folder / "nothing.pvd").empty());
}

TEST_F(FieldFiles_behaviour, the_file_shown_is_that_of_the_largest_load) {
  const SolvedCase solved = read_solved_case(folder);
  write_file_atomically(folder / "interface" / "step_0016.vtp",
                        read_file(folder / "interface" / "step_0008.vtp"));
  write_file_atomically(folder / "interface.pvd",
                        "<DataSet timestep=\"8\" file=\"interface/step_0008.vtp\"/>\n"
                        "<DataSet timestep=\"16\" file=\"interface/step_0016.vtp\"/>\n");
  EXPECT_EQ(files_at_largest_load(solved, "interface.pvd").front().filename(), "step_0008.vtp");
}

TEST_F(FieldFiles_behaviour, are_drawn_about_the_axis_that_they_state) {
  const fs::path file = folder / "interface" / "step_0008.vtp";
  const InterfaceExtent before = interface_extent(file);
  std::string text = read_file(file);
  const std::string piece = "<Piece";
  text.insert(text.find(piece),
              "<FieldData><DataArray type=\"Float64\" Name=\"axis x [m]\" NumberOfTuples=\"1\" "
              "format=\"ascii\">1e-7</DataArray></FieldData>");
  write_file_atomically(file, text);
  const InterfaceExtent about_axis = interface_extent(file);
  EXPECT_NEAR(about_axis.peak_x, before.peak_x - 1e-7, 1e-15);
  EXPECT_NEAR(about_axis.surface, before.surface + 1e-7, 1e-15);
  EXPECT_EQ(about_axis.peak_y, before.peak_y);
}

TEST_F(FieldFiles_behaviour, a_map_of_the_interface_holds_the_values_of_the_surface_in_place) {
  const Hertz hertz = test::synthetic::contact(made);
  const double a = hertz.contact_radius(made.load);
  const Map map = interface_map(folder / "interface" / "step_0008.vtp", "height_particle", 1.5 * a, 60);
  ASSERT_EQ(map.values.size(), 3600u);
  // Bilinear between nodes a thirtieth of a apart; the wave turns by 40/30/2 rad from node to node.
  const double amplitude = 1e-9, half = 2 * a;
  for (int iy = 5; iy < 60; iy += 7)
    for (int ix = 5; ix < 60; ix += 7) {
      const double x = map.x_low + (ix + 0.5) * (map.x_high - map.x_low) / 60;
      const double y = map.y_low + (iy + 0.5) * (map.y_high - map.y_low) / 60;
      const double dx = half / 30 * 40 / half,
                   dy = half / 30 * 30 / half;  // node distances in radians of the wave
      const double bound = amplitude * (dx * dx + dy * dy) / 8;
      EXPECT_NEAR(map.values[static_cast<std::size_t>(iy) * 60 + ix],
                  amplitude * std::sin(40 * x / half) * std::cos(30 * y / half), bound);
    }
}

TEST_F(FieldFiles_behaviour, outside_of_the_surface_a_map_has_no_values) {
  const double a = test::synthetic::contact(made).contact_radius(made.load);
  const Map map = interface_map(folder / "interface" / "step_0008.vtp", "pressure", 4 * a, 40);
  EXPECT_TRUE(std::isnan(map.values.front()));
  EXPECT_TRUE(std::isfinite(map.values[20 * 40 + 20]));
}

TEST_F(FieldFiles_behaviour, the_extent_of_contact_is_that_of_the_pressure) {
  const double a = test::synthetic::contact(made).contact_radius(made.load);
  const InterfaceExtent extent = interface_extent(folder / "interface" / "step_0008.vtp");
  EXPECT_NEAR(extent.surface, 2 * a, 1e-6 * a);
  EXPECT_NEAR(extent.contact, a, 0.07 * a);  // one node distance
}

TEST_F(FieldFiles_behaviour,
       a_section_lies_in_its_plane_and_keeps_the_values_of_the_cells_also_from_files_of_several_ranks) {
  const auto section = vertical_section({folder / "fields" / "step_0008.vtu"}, 1e-9);
  // Two bodies of 30 columns and 20 layers.
  EXPECT_EQ(section->GetNumberOfCells(), 1200);
  ASSERT_NE(section->GetCellData()->GetArray("von_mises"), nullptr);
  double bounds[6];
  section->GetBounds(bounds);
  EXPECT_NEAR(bounds[2], 1e-9, 1e-15);
  EXPECT_NEAR(bounds[3], 1e-9, 1e-15);

  const fs::path file = folder / "fields" / "step_0008.vtu";
  EXPECT_EQ(vertical_section({file, file}, 1e-9)->GetNumberOfCells(), 2400);
  write_file_atomically(
      folder / "fields" / "step_0008.pvtu",
      "<?xml version='1.0'?><VTKFile type='PUnstructuredGrid' version='0.1' byte_order='LittleEndian'>"
      "<PUnstructuredGrid GhostLevel='0'><PPointData><PDataArray type='Float64' Name='displacement' "
      "NumberOfComponents='3'/></PPointData><PCellData><PDataArray type='Float64' "
      "Name='von_mises'/></PCellData>"
      "<PPoints><PDataArray type='Float64' NumberOfComponents='3'/></PPoints><Piece Source='step_0008.vtu'/>"
      "</PUnstructuredGrid></VTKFile>");
  EXPECT_EQ(vertical_section({folder / "fields" / "step_0008.pvtu"}, 1e-9)->GetNumberOfCells(), 1200);
}

TEST_F(FieldFiles_behaviour, what_is_not_vtk_data_or_lacks_an_array_is_refused_by_name) {
  const fs::path file = folder / "interface" / "step_0008.vtp";
  EXPECT_THROW(interface_map(file, "temperature", 1e-7, 10), InputError);
  write_file_atomically(file, "cut off");
  EXPECT_THROW(interface_map(file, "pressure", 1e-7, 10), InputError);
  EXPECT_THROW(vertical_section({folder / "none.vtu"}, 0), InputError);
}

}  // namespace
}  // namespace asperity::report
