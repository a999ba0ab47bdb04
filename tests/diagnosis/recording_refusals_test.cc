// What a recording must be, one refusal for each rule, and what tables hold in which unit.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "diagnosis/recording/recording_table_file.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::TemporaryFolder;

Recording sound_trace() {
  Recording recording;
  recording.mode = Motion::sliding;
  recording.particle = test::borosilicate(), recording.substrate = test::silicon();
  RecordingTable table;
  table.file = "t.csv";
  table.control = {"lateral_displacement", "normal_force"};
  table.response = "lateral_force";
  for (int i = 0; i < 20; ++i) {
    table.columns["time"].push_back(i);
    table.columns["lateral_displacement"].push_back(1e-9 * i);
    table.columns["normal_force"].push_back(1e-3);
    table.columns["lateral_force"].push_back(2e-4);
  }
  recording.tables = {table};
  return recording;
}

/// What is said of the recording after a change; "" if it is taken.
template <class Change>
std::string said_after(const Change& change) {
  Recording recording = sound_trace();
  change(recording, recording.tables[0]);
  try {
    check_recording(recording);
  } catch (const InputError& refusal) {
    return refusal.what();
  }
  return "";
}

#define EXPECT_SAID(part, change)                                                              \
  {                                                                                            \
    const std::string said =                                                                   \
        said_after([](Recording& r, RecordingTable& t) { (void)r, (void)t, (void)(change); }); \
    EXPECT_NE(said.find(part), std::string::npos) << #change << ": " << said;                  \
  }
#define EXPECT_TAKEN(change)                                                                           \
  EXPECT_EQ(said_after([](Recording& r, RecordingTable& t) { (void)r, (void)t, (void)(change); }), "") \
      << #change

TEST(RecordingRules_behaviour, ask_for_bodies_that_can_be) {
  EXPECT_TAKEN(0);
  EXPECT_SAID("'particle' needs its 'youngs_modulus'", r.particle.youngs_modulus = 0);
  EXPECT_SAID("'substrate' needs its 'youngs_modulus'", r.substrate.youngs_modulus = NAN);
  EXPECT_SAID("'poissons_ratio' between -1 and 0.5", r.particle.poissons_ratio = 0.51);
  EXPECT_SAID("'poissons_ratio' between -1 and 0.5", r.particle.poissons_ratio = -1);
  EXPECT_SAID("'poissons_ratio' between -1 and 0.5", r.particle.poissons_ratio = NAN);
  EXPECT_TAKEN(r.particle.poissons_ratio = 0.5);
  EXPECT_SAID("'rms_roughness' below zero", r.substrate.rms_roughness = -1e-9);
  EXPECT_TAKEN(r.substrate.rms_roughness = 0);
  EXPECT_SAID("'particle' needs its 'radius'", r.particle.radius = 0);
  EXPECT_SAID("'particle' needs its 'radius'", r.particle.radius = NAN);
  EXPECT_SAID("needs the 'indenter'", r.mode = Motion::rolling);
  EXPECT_SAID("'indenter' needs its 'youngs_modulus'",
              (r.mode = Motion::rolling, r.indenter = RecordedBody{}));
  EXPECT_TAKEN((r.mode = Motion::rolling, r.indenter = test::diamond()));
  EXPECT_SAID("needs the 'rail_angle'", (r.mode = Motion::rail, r.indenter = test::diamond()));
  EXPECT_TAKEN((r.mode = Motion::rail, r.indenter = test::diamond(), r.rail_angle = 0.8));
}

TEST(RecordingRules_behaviour, ask_for_known_laws_and_numbers_that_can_be) {
  EXPECT_SAID("no law 'x' for 'normal'; use hertz", r.simulation.normal = "x");
  EXPECT_SAID("no law 'x' for 'rolling'; use constant", r.simulation.rolling = "x");
  EXPECT_SAID("no law 'x' for 'torsion'; use none, constant", r.simulation.torsion = "x");
  EXPECT_TAKEN(r.simulation.torsion = "constant");
  EXPECT_SAID("no law 'friction' for 'parameters'", (r.simulation.parameters["friction"] = {1, true}));
  EXPECT_SAID("'sliding_friction' is below zero",
              (r.simulation.parameters["sliding_friction"] = {-0.1, true}));
  EXPECT_TAKEN((r.simulation.parameters["sliding_friction"] = {0, true}));
  EXPECT_SAID("the noise of 'lateral_force' is not above zero", r.noise["lateral_force"] = 0);
  EXPECT_SAID("the noise of 'lateral_force' is not above zero", r.noise["lateral_force"] = -1e-9);
  EXPECT_TAKEN(r.noise["lateral_force"] = 1e-9);
  EXPECT_SAID("there are no tables", r.tables.clear());
}

TEST(RecordingRules_behaviour, ask_for_whole_tables) {
  EXPECT_SAID("row 3 of 'lateral_force' is not finite", t.columns["lateral_force"][2] = INFINITY);
  EXPECT_TAKEN(t.columns.erase("time"));
  EXPECT_SAID("is shorter than the others", t.columns["time"].pop_back());
  EXPECT_SAID("column 'segment' is shorter", t.segment = {"forward"});
  EXPECT_TAKEN(t.segment.assign(20, "forward"));
  EXPECT_SAID("no control channel is named", t.control.clear());
  EXPECT_SAID("there is no column 'radius'", t.control = {"radius"});
  EXPECT_SAID("row 4 has no 'normal_force', which drives the simulation", t.columns["normal_force"][3] = NAN);
  EXPECT_SAID("'lateral_force' cannot be control and response at once", t.control = {"lateral_force"});
  EXPECT_SAID("row 1 does not say its 'run'", t.columns["run"].assign(20, NAN));
  EXPECT_SAID("row 1 does not say its 'cycle'", t.columns["cycle"].assign(20, NAN));
  EXPECT_SAID("row 20 of 'lateral_force_sd' is not above zero",
              (t.columns["lateral_force_sd"].assign(20, 1e-6), t.columns["lateral_force_sd"][19] = 0));
  EXPECT_TAKEN(t.columns["lateral_force_sd"].assign(20, 1e-6));
  EXPECT_SAID("there is no column 'normal_force'",
              (t.control = {"lateral_displacement"}, t.columns.erase("normal_force")));
  EXPECT_SAID("there is no channel 'force'", t.columns["force"].assign(20, 1));
}

TEST(RecordingRules_behaviour, ask_for_twenty_samples_of_a_trace_and_three_of_a_series) {
  EXPECT_SAID("19 samples of 'lateral_force' are too few for a trace; it takes 20",
              t.columns["lateral_force"][5] = NAN);
  const auto series = [](Recording&, RecordingTable& t, std::size_t rows) {
    t.kind = TableKind::series;
    for (auto& [name, values] : t.columns) values.resize(rows);
  };
  EXPECT_EQ(said_after([&](Recording& r, RecordingTable& t) { series(r, t, 3); }), "");
  EXPECT_NE(said_after([&](Recording& r, RecordingTable& t) {
              series(r, t, 2);
            }).find("too few for a series; it takes 3"),
            std::string::npos);
}

TEST(RecordingRules_behaviour, ask_for_time_that_falls_in_no_run_and_may_stand_still) {
  EXPECT_TAKEN(t.columns["time"][4] = 3);
  EXPECT_SAID("row 5 has no time; fill it, or leave out the column", t.columns["time"][4] = NAN);
  EXPECT_SAID("time falls from row 10 to row 11 (9 s, then 0 s)", t.columns["time"][10] = 0);
  EXPECT_TAKEN((t.columns["run"].assign(10, 1), t.columns["run"].insert(t.columns["run"].end(), 10, 2.0),
                t.columns["time"][10] = 0));
}

RecordingTable table_of(const std::string& text) {
  const TemporaryFolder folder;
  RecordingTable table;
  read_table_file(folder.write("t.csv", text), table);
  return table;
}
std::string refusal_of_table(const std::string& text) {
  return message_of<InputError>([&] { table_of(text); });
}

TEST(TableFile_behaviour, takes_a_dash_for_a_number_without_unit_and_for_nothing_else) {
  for (const char* dash : {"[-]", "[–]", "[ - ]", ""}) {
    const RecordingTable table = table_of(std::string("cycle ") + dash + ",humidity [-]\n3,0.4\n");
    EXPECT_EQ(table.column("cycle"), std::vector<double>{3}) << dash;
    EXPECT_EQ(table.column("humidity"), std::vector<double>{0.4});
  }
  EXPECT_NE(refusal_of_table("normal_force [-]\n1\n")
                .find("in column 'normal_force [-]' the unit '-' does not fit"),
            std::string::npos);
  EXPECT_NE(refusal_of_table("cycle [N]\n1\n").find("in column 'cycle [N]' the unit 'N' does not fit"),
            std::string::npos);
}

TEST(TableFile_analytic, reads_units_as_their_factor) {
  const RecordingTable table = table_of(
      "time [ms], normal_force [uN],normal_displacement [nm],rail_angle [deg],speed [um/s],normal_force_sd "
      "[nN]\n"
      "2,3,4,180,5,6\n");
  EXPECT_DOUBLE_EQ(table.column("time")[0], 2e-3);
  EXPECT_DOUBLE_EQ(table.column("normal_force")[0], 3e-6);
  EXPECT_DOUBLE_EQ(table.column("normal_displacement")[0], 4e-9);
  EXPECT_DOUBLE_EQ(table.column("rail_angle")[0], M_PI);
  EXPECT_DOUBLE_EQ(table.column("speed")[0], 5e-6);
  EXPECT_DOUBLE_EQ(table.column("normal_force_sd")[0], 6e-9);
  EXPECT_DOUBLE_EQ(table_of("normal_force\n3\n").column("normal_force")[0], 3);  // SI without a unit
}

TEST(TableFile_behaviour, refuses_heads_that_are_no_columns) {
  EXPECT_NE(refusal_of_table("normal_force [uN\n1\n").find("lacks the closing bracket"), std::string::npos);
  EXPECT_NE(
      refusal_of_table("time,normal_force [N],time [s]\n1,2,3\n").find("column 'time' stands there twice"),
      std::string::npos);
  EXPECT_NE(refusal_of_table("").find("the table is empty"), std::string::npos);
  EXPECT_NE(refusal_of_table("# only a remark\n\n").find("the table is empty"), std::string::npos);
  EXPECT_NE(refusal_of_table("time,cycle\n1\n").find("t.csv:2: 1 cells where the header has 2"),
            std::string::npos);
}

TEST(TableFile_behaviour, says_what_another_way_of_writing_tables_is_to_become) {
  const auto said = [](const std::string& text, const std::string& part) {
    EXPECT_NE(refusal_of_table(text).find(part), std::string::npos) << refusal_of_table(text);
  };
  said("time;normal_force [N]\n1;2\n", "cells are separated by ';' here; separate them by commas");
  said("time\tnormal_force [N]\n1\t2\n", "cells are separated by tabs here");
  said("time (s),cycle\n1,2\n", "round brackets; write it in square ones, as 'time [...]'");
  said("time,cycle\ns,\n1,2\n",
       "t.csv:2: 's' in column 'time' is not a number; write units behind the names, as "
       "'time [s]'");
  said("time,cycle\nm,\n1,2\n", "'m' in column 'time' is not a number; leave the cell empty");
  said("time,cycle,\n1,2,\n1,2,3\n", "t.csv:3: column 3 holds '3' and has no name");
  said("[s],cycle\n1,2\n", "there is no channel ''");
}

TEST(TableFile_behaviour, reads_what_spreadsheets_save) {
  for (const std::string text : {"\xEF\xBB\xBFtime,normal_force [uN],segment\r\n1,2,load\r\n",
                                 "time,normal_force [\xB5N],segment\r1,2,load\r",
                                 "\"time\",\"normal_force [uN]\",segment,,\n1,2,load,,\n"}) {
    const RecordingTable table = table_of(text);
    EXPECT_EQ(table.column("time"), std::vector<double>{1}) << text;
    EXPECT_DOUBLE_EQ(table.column("normal_force").at(0), 2e-6) << text;
    EXPECT_EQ(table.segment, std::vector<std::string>{"load"}) << text;
    EXPECT_EQ(table.columns.size(), 2u) << text;
  }
}

TEST(TableFile_behaviour, writes_known_channels_in_their_order_with_units_and_gaps) {
  RecordingTable table;
  table.columns["normal_force"] = {1e-6, NAN};
  table.columns["normal_force_sd"] = {2e-7, 3e-7};
  table.columns["cycle"] = {0, 1};
  table.segment = {"load", "unload"};
  EXPECT_EQ(format_table_file(table),
            "cycle,normal_force [N],normal_force_sd [N],segment\n0,1e-06,2e-07,load\n1,,3e-07,unload\n");
}

TEST(Channels_behaviour, are_known_by_name_and_have_the_unit_of_what_they_measure) {
  EXPECT_EQ(unit_of_channel("lateral_force_sd"), "N");
  EXPECT_EQ(unit_of_channel("rail_angle"), "rad");
  EXPECT_EQ(unit_of_channel("cycle"), "");
  EXPECT_NE(message_of<InputError>([] {
              dimension_of_channel("lateral_fore_sd");
            }).find("did you mean 'lateral_force'?"),
            std::string::npos);
  EXPECT_THROW(dimension_of_channel("_sd"), InputError);
  for (const Motion mode : all_modes()) EXPECT_EQ(mode_of(name_of(mode)), mode);
  EXPECT_NE(message_of<InputError>([] { mode_of("slidng"); }).find("did you mean 'sliding'?"),
            std::string::npos);
}

#undef EXPECT_SAID
#undef EXPECT_TAKEN

}  // namespace
}  // namespace asperity
