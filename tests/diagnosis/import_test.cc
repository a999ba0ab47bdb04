// Instruments' own text, as written here and as real ones wrote it.
#include "diagnosis/import/import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "diagnosis/import/instrument_text.h"
#include "diagnosis/import/segments.h"
#include "diagnosis/import/text_formats.h"
#include "tests/support/shared_files.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::TemporaryFolder;

ImportOptions with_bodies() {
  ImportOptions options;
  options.radius = 5e-7;
  options.substrate_modulus = 72e9;
  options.substrate_poisson = 0.17;
  return options;
}

std::map<std::string, int> counts(const std::vector<std::string>& segments) {
  std::map<std::string, int> result;
  for (const auto& segment : segments) ++result[segment];
  return result;
}

TEST(Import_analytic, finds_load_hold_and_unload_in_a_noisy_signal) {
  std::vector<double> signal;
  const auto wobble = [&] { return 0.3 * std::sin(static_cast<double>(signal.size()) * 37.0); };
  for (int i = 0; i < 200; ++i) signal.push_back(0.5 * i + wobble());
  for (int i = 0; i < 100; ++i) signal.push_back(100 + wobble());
  for (int i = 0; i < 200; ++i) signal.push_back(100 - 0.5 * i + wobble());
  const FoundSegments found = find_segments(signal);
  EXPECT_EQ(found.segment[100], "load");
  EXPECT_EQ(found.segment[250], "hold");
  EXPECT_EQ(found.segment[400], "unload");
  const auto count = counts(found.segment);
  EXPECT_NEAR(count.at("hold"), 100, 6);
  EXPECT_EQ(found.cycle.back(), 0);
}

TEST(Import_analytic, counts_cycles_of_partial_unloading) {
  std::vector<double> signal;
  for (int cycle = 1; cycle <= 8; ++cycle) {
    for (int i = 0; i < 50; ++i) signal.push_back(cycle * 10 * (0.3 + 0.7 * i / 50.0));
    for (int i = 0; i < 50; ++i) signal.push_back(cycle * 10 * (1 - 0.7 * i / 50.0));
  }
  EXPECT_EQ(find_segments(signal).cycle.back(), 7);
}

TEST(Import_behaviour, a_file_is_fischers_with_a_block_and_its_table_alone) {
  EXPECT_TRUE(is_fischer({"a", {"Block : 1", "F\th\tt"}}));
  EXPECT_FALSE(is_fischer({"a", {"Block : 1", "F;h;t"}}));
  EXPECT_FALSE(is_fischer({"a", {"F\th\tt", "1\t2\t3"}}));
}

TEST(Import_behaviour, reads_latin_1_decimal_commas_and_units_of_fischer_blocks) {
  const TemporaryFolder folder;
  std::string text = "FS1.hap\tName\r\nBlock : 1   Value : 1\nHIT\t[N/mm\xB2]\t8553,6\n\nF\th\tt\r\n";
  for (int i = 0; i <= 40; ++i)
    text +=
        std::to_string(i) + ",5\t0,0" + std::to_string(10 + i) + "\t0," + std::to_string(100 + i) + "\r\n";
  text +=
      "\nFS1.hap again\nBlock : 1   Value : "
      "2\nF\th\tt\r\n1,5\t0,01\t0,1\r\n2,5\t0,02\t0,2\r\n3,5\t0,03\t0,3\r\n";
  const Recording recording = import_recording(folder.write("FS.txt", text), with_bodies());
  const RecordingTable& table = recording.tables[0];
  ASSERT_EQ(table.rows(), 44u);
  EXPECT_NEAR(table.column("normal_force")[2], 2.5e-3, 1e-12);
  EXPECT_NEAR(table.column("normal_displacement")[2], 0.012e-6, 1e-15);
  EXPECT_EQ(table.column("run")[43], 2);
  ImportOptions first = with_bodies();
  first.run = 1;
  EXPECT_EQ(import_recording(folder.path / "FS.txt", first).tables[0].rows(), 41u);
  first.run = 5;
  EXPECT_NE(message_of<InputError>([&] {
              import_recording(folder.path / "FS.txt", first);
            }).find("has no run 5; there are 2"),
            std::string::npos);
}

TEST(Import_behaviour, maps_columns_with_factors_products_and_constants) {
  const TemporaryFolder folder;
  std::string text = "t;x;mu;stress\n";
  for (int i = 0; i < 30; ++i) text += std::to_string(i) + ";" + std::to_string(2 * i) + ",5;0,6;20\n";
  const auto file = folder.write("friction.csv", text);
  ImportOptions options = with_bodies();
  options.mode = Motion::sliding;
  options.columns = {"time [s] = t", "lateral_displacement [\xC2\xB5m] = x",
                     "lateral_force [N] = mu * stress * 1e6", "normal_force [mN] = 20"};
  const RecordingTable table = import_recording(file, options).tables[0];
  EXPECT_NEAR(table.column("lateral_displacement")[3], 6.5e-6, 1e-15);
  EXPECT_NEAR(table.column("lateral_force")[3], 12e6, 1e-3);
  EXPECT_NEAR(table.column("normal_force")[3], 0.02, 1e-15);
  options.columns[0] = "time [s] = tt";
  EXPECT_NE(message_of<InputError>([&] {
              import_recording(file, options);
            }).find("there is no column 'tt' among t, x, mu, stress"),
            std::string::npos);
  options.columns[0] = "time [nm] = t";
  EXPECT_NE(message_of<InputError>([&] { import_recording(file, options); }).find("unit 'nm' does not fit"),
            std::string::npos);
  options.columns[0] = "tim [s] = t";
  EXPECT_NE(message_of<InputError>([&] { import_recording(file, options); }).find("did you mean 'time'?"),
            std::string::npos);
  options.columns.clear();
  EXPECT_NE(
      message_of<InputError>([&] { import_recording(file, options); }).find("there are t, x, mu, stress"),
      std::string::npos);
}

TEST(Import_analytic, units_that_the_file_says_are_believed_unless_the_map_says_others) {
  const TemporaryFolder folder;
  std::string rows;
  for (int i = 0; i < 30; ++i) rows += std::to_string(i) + "," + std::to_string(2 * i) + ",3\n";
  ImportOptions options = with_bodies();
  options.columns = {"time = Time", "normal_displacement = Depth", "normal_force = Load"};
  const auto table = [&](const std::string& header) {
    return import_recording(folder.write("test.csv", header + rows), options).tables[0];
  };
  for (const char* header : {"Time,Depth,Load\ns,nm,mN\n", "Time,Depth,Load\n(s),(nm),[mN]\n",
                             "Time (s),Depth [nm],Load (mN)\n"}) {
    const RecordingTable made = table(header);
    ASSERT_EQ(made.rows(), 30u) << header;
    EXPECT_NEAR(made.column("normal_displacement")[4], 8e-9, 1e-20) << header;
    EXPECT_NEAR(made.column("normal_force")[4], 3e-3, 1e-15) << header;
  }
  EXPECT_NEAR(table("Time,Depth,Load\n").column("normal_force")[4], 3, 1e-12);
  options.columns[2] = "normal_force [uN] = Load";
  EXPECT_NEAR(table("Time,Depth,Load\ns,nm,mN\n").column("normal_force")[4], 3e-6, 1e-15);
  options.columns[2] = "normal_force = 1e-6 * Load";
  EXPECT_NEAR(table("Time,Depth,Load\ns,nm,mN\n").column("normal_force")[4], 3e-6, 1e-15);
  options.columns[2] = "normal_force = Load";
  EXPECT_NE(
      message_of<InputError>([&] { table("Time,Depth,Load\ns,nm,nm\n"); }).find("unit 'nm' does not fit"),
      std::string::npos);
}

TEST(Import_analytic, zeros_that_a_hysitron_header_states_are_taken_off) {
  const TemporaryFolder folder;
  std::string rows = "Disp_nm\tForce_\xB5N\tTime_s\n";
  for (int i = 0; i < 40; ++i)
    rows +=
        std::to_string(100 + 2 * i) + "\t" + std::to_string(50 + 10 * i) + "\t" + std::to_string(i) + "\n";
  const std::string points = "Test Data Points:\t40\n", version = "File Version:\tHysitron 8\n";
  const auto table = [&](const std::string& header) {
    return import_recording(folder.write("test.hld", version + header + points + rows), with_bodies())
        .tables[0];
  };
  const RecordingTable plain = table(""), shifted = table("Disp Shift:\t30\nForce Shift:\t12.5\n");
  ASSERT_EQ(plain.rows(), 40u);
  ASSERT_EQ(shifted.rows(), 40u);
  EXPECT_NEAR(plain.column("normal_displacement")[3], 106e-9, 1e-18);
  EXPECT_NEAR(plain.column("normal_force")[3], 80e-6, 1e-15);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_NEAR(shifted.column("normal_displacement")[i], plain.column("normal_displacement")[i] - 30e-9,
                1e-18);
    EXPECT_NEAR(shifted.column("normal_force")[i], plain.column("normal_force")[i] - 12.5e-6, 1e-15);
  }
}

TEST(Import_behaviour, puts_both_ways_of_a_scan_line_together_as_a_loop) {
  const TemporaryFolder folder;
  std::string text = "line,x,fwd,bwd\n";
  for (int line = 1; line <= 2; ++line)
    for (int i = 0; i < 12; ++i)
      text += std::to_string(line) + "," + std::to_string(i) + "," + std::to_string(i) + "," +
              std::to_string(-i) + "\n";
  ImportOptions options = with_bodies();
  options.mode = Motion::sliding;
  options.columns = {"run = line", "lateral_displacement [um] = x", "lateral_force:forward [nN] = fwd",
                     "lateral_force:backward [nN] = bwd", "normal_force [nN] = 20"};
  const RecordingTable table = import_recording(folder.write("scan.csv", text), options).tables[0];
  ASSERT_EQ(table.rows(), 48u);
  EXPECT_EQ(table.segment[11], "forward");
  EXPECT_EQ(table.segment[12], "backward");
  EXPECT_NEAR(table.column("lateral_displacement")[12], 11e-6, 1e-15);
  EXPECT_NEAR(table.column("lateral_force")[12], -11e-9, 1e-18);
  EXPECT_EQ(table.column("run")[24], 2);
}

TEST(Import_behaviour, refuses_with_one_sentence) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text, const ImportOptions& options) {
    const std::string message =
        message_of<InputError>([&] { import_recording(folder.write("file.txt", text), options); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
  };
  EXPECT_NE(refusal("no table here\n", with_bodies()).find("there is no row of names"), std::string::npos);
  EXPECT_NE(refusal(std::string("a\0b", 3), with_bodies()).find("is binary, not text"), std::string::npos);
  EXPECT_NE(
      refusal("Mon\n\nNumber of Points = 5\nDepth (nm)\tLoad (\xB5N)\tTime (s)\n1\t2\t3\n", with_bodies())
          .find("announces 5 points and holds 1"),
      std::string::npos);
  EXPECT_NE(refusal("Mon\n\nNumber of Points = 2\nDepth (nm)\tLoad (\xB5N)\tTime (s)\n1\t2\t3\n1\t2\n",
                    with_bodies())
                .find(":6: 2 cells where the header has 3"),
            std::string::npos);
  EXPECT_NE(refusal("Mon\n\nNumber of Points = 2\nDepth (nm)\tLoad (\xB5N)\tTime (s)\n1\t2\t3\n1\tx\t4\n",
                    with_bodies())
                .find(":6: 'x' in column"),
            std::string::npos);
  ImportOptions options;
  EXPECT_NE(refusal("Mon\n\nNumber of Points = 1\nDepth (nm)\tLoad (\xB5N)\tTime (s)\n1\t2\t3\n", options)
                .find("give it with --radius"),
            std::string::npos);
  options.format = "hysitorn";
  EXPECT_NE(refusal("x\n", options).find("did you mean 'hysitron'?"), std::string::npos);
  EXPECT_NE(message_of<InputError>([&] { import_recording(folder.path / "none.txt", {}); }).find("none.txt"),
            std::string::npos);
}

// ---- what real instruments wrote
// ------------------------------------------------------------------------------------------------

TEST(ImportedFiles_other_code, hysitron_hld_has_its_test_table_and_four_stretches) {
  ASPERITY_SHARED_FILE_OR_SKIP(file, "recordings/hysitron_50mN.hld");
  const RecordingTable table = import_recording(file, with_bodies()).tables[0];
  EXPECT_EQ(table.rows(), 1068u);
  const auto& force = table.column("normal_force");
  EXPECT_NEAR(*std::max_element(force.begin(), force.end()), 50e-3, 0.5e-3);
  const auto count = counts(table.segment);
  EXPECT_NEAR(count.at("load"), 200, 10);
  EXPECT_NEAR(count.at("unload"), 200, 10);
}

TEST(ImportedFiles_other_code, hysitron_text_of_steel_has_ten_seconds_up_five_of_hold_ten_down) {
  ASPERITY_SHARED_FILE_OR_SKIP(file, "recordings/hysitron_steel_3mN_hold.txt");
  const RecordingTable table = import_recording(file, with_bodies()).tables[0];
  EXPECT_EQ(table.rows(), 5304u);
  double load = 0, hold = 0, unload = 0;
  const auto &time = table.column("time"), &force = table.column("normal_force");
  for (std::size_t i = 1; i < table.rows(); ++i) {
    if (force[i] < 0.1e-3) continue;  // in contact
    const double step = time[i] - time[i - 1];
    (table.segment[i] == "load" ? load : table.segment[i] == "hold" ? hold : unload) += step;
  }
  EXPECT_NEAR(load, 10, 0.7);
  EXPECT_NEAR(hold, 5, 0.5);
  EXPECT_NEAR(unload, 10, 0.7);
}

TEST(ImportedFiles_other_code, optics11_says_radius_modulus_and_pulls_off) {
  for (const char* name : {"recordings/sphere_R8um_PEG_X1Y1.txt", "recordings/sphere_R8um_PEG_X2Y2.txt"}) {
    ASPERITY_SHARED_FILE_OR_SKIP(file, name);
    const Recording recording = import_recording(file, {});
    EXPECT_NEAR(recording.particle.radius, 8e-6, 1e-12);
    EXPECT_NEAR(recording.substrate.youngs_modulus, 2e4, 1e3);
    const RecordingTable& table = recording.tables[0];
    const auto& force = table.column("normal_force");
    EXPECT_NEAR(*std::max_element(force.begin(), force.end()), 0.046e-6, 0.01e-6);
    EXPECT_LT(*std::min_element(force.begin(), force.end()), -0.03e-6);
    // Half as stiff a cantilever, half the force.
    ImportOptions softer;
    softer.spring_constant = 0.016;
    EXPECT_NEAR(import_recording(file, softer).tables[0].column("normal_force")[3000] / force[3000], 0.5,
                1e-9);
  }
}

TEST(ImportedFiles_other_code, fischerscope_has_ten_runs_of_eight_cycles) {
  ASPERITY_SHARED_FILE_OR_SKIP(file, "recordings/fischerscope_fusedsilica_8cycles.txt");
  const RecordingTable table = import_recording(file, with_bodies()).tables[0];
  const auto &run = table.column("run"), &cycle = table.column("cycle"),
             &force = table.column("normal_force");
  EXPECT_EQ(*std::max_element(run.begin(), run.end()), 10);
  EXPECT_EQ(*std::max_element(cycle.begin(), cycle.end()), 7);
  EXPECT_NEAR(*std::max_element(force.begin(), force.end()), 0.3, 0.003);
}

TEST(ImportedFiles_other_code, tables_of_other_programs_come_in_by_a_map_of_their_columns) {
  struct Table {
    const char* name;
    Motion mode;
    std::vector<std::string> columns;
    std::size_t rows;
  };
  const std::vector<std::string> probe{"time [s] = time_s", "normal_displacement [nm] = displacement_nm",
                                       "normal_force [uN] = load_uN"};
  for (const Table& t :
       {Table{"csm_popin_Test012.csv",
              Motion::normal,
              {"time [s] = time_s", "normal_displacement [nm] = displacement_nm",
               "normal_force [mN] = load_mN"},
              375},
        Table{"flat_probe_Gold_00000_avg10.csv", Motion::normal, probe, 5100},
        Table{"flat_probe_AIR_reference_avg10.csv", Motion::normal, probe, 5101},
        Table{"rsf_velstep_basalt_BRAVA_b819.txt",
              Motion::sliding,
              {"time [s] = Time(s)", "lateral_displacement [um] = Displ(microns)",
               "lateral_force [N] = Friction * Normal_stress(MPa)", "normal_force [N] = Normal_stress(MPa)"},
              5849},
        Table{"lfm_SBS-PMMA_loops_32lines.csv",
              Motion::sliding,
              {"run = line", "lateral_displacement [um] = x_um", "lateral_force:forward [nN] = lateral_fwd_V",
               "lateral_force:backward [nN] = lateral_bwd_V", "normal_force [nN] = 20"},
              16384}}) {
    ASPERITY_SHARED_FILE_OR_SKIP(file, std::string("recordings/") + t.name);
    ImportOptions options = with_bodies();
    options.mode = t.mode;
    options.columns = t.columns;
    const Recording recording = import_recording(file, options);
    EXPECT_EQ(recording.tables[0].rows(), t.rows) << t.name;
    const TemporaryFolder folder;
    write_recording(recording, folder.path);
    EXPECT_EQ(read_recording(folder.path).tables[0].rows(), t.rows);
  }
}

}  // namespace
}  // namespace asperity
