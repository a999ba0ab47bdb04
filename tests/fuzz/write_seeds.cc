// Writes the corpus of the fuzz targets: one or a few tiny files of each format, by the same writers as the
// readers' tests.
//   build/fuzz_seeds tests/fuzz/corpus
#include <netcdf.h>

#include <iostream>
#include <map>

#include "tests/surfaces/readers/instrument_list.h"

namespace {

using namespace asperity::test;
namespace fs = std::filesystem;

class Corpus {
 public:
  explicit Corpus(fs::path folder) : folder_(std::move(folder)) {}
  void add(const std::string& target, const std::string& bytes) {
    fs::create_directories(folder_ / target);
    std::ofstream(folder_ / target / ("seed_" + std::to_string(++count_[target])), std::ios::binary) << bytes;
  }

 private:
  fs::path folder_;
  std::map<std::string, int> count_;
};

std::string netcdf_bytes(int format, bool growing) {
  const auto path = write_bytes("a.nc", "");
  int file = 0, dims[2], x = 0, y = 0, heights = 0;
  nc_create(path.c_str(), NC_CLOBBER | format, &file);
  nc_def_dim(file, "x", growing ? NC_UNLIMITED : 3, &dims[0]);
  nc_def_dim(file, "y", 2, &dims[1]);
  nc_def_var(file, "heights", format == NC_64BIT_DATA ? NC_SHORT : NC_DOUBLE, 2, dims, &heights);
  nc_def_var(file, "x", NC_DOUBLE, 1, &dims[0], &x);
  nc_def_var(file, "y", NC_DOUBLE, 1, &dims[1], &y);
  const double length = 3;
  for (const int axis : {x, y}) {
    nc_put_att_double(file, axis, "length", NC_DOUBLE, 1, &length);
    nc_put_att_text(file, axis, "unit", 2, "um");
  }
  nc_enddef(file);
  const double values[] = {1, 2, 3, 4, 5, 6};
  const std::size_t start[] = {0, 0}, count[] = {3, 2};
  nc_put_vara_double(file, heights, start, count, values);
  nc_close(file);
  return bytes_of(path);
}

void add_maps(Corpus& corpus) {
  const std::string sizes =
      "XRes = 3\nYRes = 2\nXReal = 3e-6\nYReal = 2e-6\nXYUnits = m\nZUnits = m\nTitle = Height\n";
  corpus.add("map_gsf", gsf_bytes(sizes, {1e-9f, 2e-9f, 3e-9f, 4e-9f, std::nanf(""), 6e-9f}));
  corpus.add("map_gwy", gwy_bytes(gwy_component("/0/data", 'o', gwy_field({1, 2, 3, 4, 5, 6}, "nm")) +
                                  gwy_component("/0/data/title", 's', std::string("Height\0", 7)) +
                                  gwy_component("/0/mask", 'o', gwy_field({0, 0, 1, 0, 0, 0}, ""))));
  std::string scan = nanoscope_bytes({NanoscopeImage{}}, 2);
  corpus.add("map_001", scan);
  corpus.add("map_001",
             nanoscope_bytes({NanoscopeImage{}, {"Phase", "Sens. Phase", "1000 nm", 4}}, 4, "0x09200000"));
  for (const std::uint32_t type : {0u, 1u, 2u}) {
    ParkImage image;
    image.data_type = type;
    image.data = std::string(type == 0 ? 12 : 24, '\1');
    corpus.add("map_tiff", park_bytes(image));
  }
  for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA})
    for (const bool growing : {false, true}) corpus.add("map_nc", netcdf_bytes(format, growing));
  std::string data;
  for (const int nm : {1, 2, 3, 4, 5, 6}) data += raw(nm * 1e-9);
  corpus.add("map_x3p", bytes_of(write_zip(
                            "a.x3p", {{"main.xml", x3p_main("D", "", "<ValidPointsLink>v</ValidPointsLink>")},
                                      {"bindata/data.bin", data},
                                      {"v", "\x3F"}})));
  corpus.add("map_x3p",
             bytes_of(write_zip("b.x3p", {{"main.xml", x3p_main("I", "<Increment>1e-9</Increment>", "")},
                                          {"bindata/data.bin", data.substr(0, 12)}})));
  corpus.add("map_xyz", "x [um], y [um], z [nm]\n0 0 1\n1 0 2\n0 1 3\n1 1 4\n");
  corpus.add("map_xyz", "# Lateral units: um\n# Value units: nm\n0;0;1,5\n1;0;2\n0;1;3\n1;1;nan\n");
  corpus.add("map_txt",
             "# Channel: Height\n# Width: 2.5 \xC2\xB5m\n# Height: 2.5 \xC2\xB5m\n# Value units: "
             "nm\n1\t2\t3\n4\t5\tbad\n");
  corpus.add("map_txt", "size: 2.5 um x 2 um\nunit: nm\n1,5;2,5;3\n4;5;6\n");
}

void add_instruments(Corpus& corpus) {
  const std::map<std::string, std::string> of_another{
      {"sdf_text", "sdf"}, {"bcrf", "bcr"}, {"nanoscope_text", "001"}, {"dat", "zygo"}};
  for (const auto& file : instrument_files()) {
    const auto other = of_another.find(file.name);
    corpus.add("map_" + (other == of_another.end() ? file.name : other->second), file.bytes);
  }
  corpus.add("map_gz", deflated(sdf_map(), gzip_bits));
  corpus.add("map_gz", deflated("size: 3 um x 2 um\nunit: nm\n1 2 3\n4 5 6\n", gzip_bits));
}

void add_recordings(Corpus& corpus) {
  corpus.add("recording_json",
             "{\"format\": \"asperity-recording/1\", \"title\": \"a\", \"mode\": \"normal\", \"particle\": "
             "{\"youngs_modulus\": \"71 GPa\", "
             "\"poissons_ratio\": 0.17, \"radius\": \"8.5 um\"}, \"substrate\": {\"youngs_modulus\": 1.3e11, "
             "\"poissons_ratio\": 0.22, "
             "\"yield_stress\": \"5 GPa\"}, \"simulation\": {\"normal\": \"hertz\", \"parameters\": "
             "{\"sliding_friction\": {\"value\": 0.1, "
             "\"calibrate\": true}}}, \"noise\": {\"normal_force\": \"1 nN\"}, \"tables\": [{\"file\": "
             "\"loading.csv\", \"kind\": \"trace\", "
             "\"control\": [\"normal_displacement\"], \"response\": \"normal_force\"}]}");
  corpus.add("recording_table",
             "# a loading\ntime [s],normal_displacement [nm],normal_force "
             "[uN],segment\n0,0,0,load\n1,2.5,,load\n2,1,3e1,unload\n");
  std::string hld =
      "File Version: Hysitron 1\nDisp Shift: 1.5\nTest Data Points: 20\nTime_s\tDisp_nm\tForce_\xC2\xB5N\n";
  std::string optics =
      "Optics11\nTip radius (um)\t25\nk (N/m)\t0.5\nE[v=0.50] (Pa)\t1000\n\n"
      "Time (s)\tLoad (uN)\tIndentation (nm)\tCantilever (nm)\tPiezo (nm)\n";
  std::string fischer = "F 1\tx\nBlock : 1  Value : 1\nF\th\tt\n", csv = "a file\nt,h,F\n";
  for (int i = 0; i < 20; ++i) {
    const std::string n = std::to_string(i);
    hld += n + "\t" + n + "\t" + n + ".5\n";
    optics += n + "\t" + n + "\t" + n + "\t1\t" + n + "\n";
    fischer += n + ",5\t" + n + "\t" + n + "\n";
    csv += n + "," + n + "," + n + "\n";
  }
  corpus.add("import_hysitron", hld);
  corpus.add("import_optics11", optics);
  corpus.add("import_fischer", fischer);
  corpus.add("import_csv", csv);
}

void add_parameters(Corpus& corpus) {
  corpus.add("case_file",
             "# a case\nset Title = a\nsubsection Particle\n  set Radius = 8.5 um\n  set Topography = "
             "generated(rms=1.5 nm, seed=3)\n"
             "end\nsubsection Experiment\n  set Type = program\n  set Normal load = 100 \\\n uN\n  set "
             "Program = roll 3 mrad\nend\n");
  corpus.add("case_file",
             "{\"Particle\": {\"Radius\": \"8.5 um\", \"Poisson_20ratio\": {\"value\": \"0.17\", "
             "\"default_value\": \"0.3\"}}, "
             "\"Output\": {\"Fields\": true}}");
  corpus.add("parameters_json",
             "{\"format\": \"asperity-parameters/1\", \"title\": \"a\", \"particle\": {\"material\": "
             "\"silica\", \"radius\": \"8.5 um\", "
             "\"youngs_modulus\": \"71 GPa\", \"poissons_ratio\": 0.17, \"density\": 2200, \"rms\": 0}, "
             "\"target\": {\"geometry\": \"plane\", "
             "\"youngs_modulus\": 1.3e11, \"poissons_ratio\": 0.22}, \"quantities\": {\"reduced_modulus\": "
             "{\"value\": 4.8e10, \"unit\": \"Pa\"}, "
             "\"reduced_shear_modulus\": {\"value\": 1e10, \"unit\": \"Pa\", \"sd\": 1e8}, "
             "\"rolling_friction\": {\"value\": 0.01, \"unit\": \"-\", "
             "\"length_scale\": \"a\", \"load_range\": [1e-5, 1e-4], \"provenance\": \"b\"}}}");
  corpus.add("history_csv",
             "step,time [s],normal_displacement [m],normal_force [N],lateral_displacement [m],lateral_force "
             "[N],rolling_angle [rad],"
             "rolling_moment [N m],torsion_angle [rad],torsion_moment [N m],contact_radius [m],contact_area "
             "[m^2],max_pressure [Pa],"
             "plastic_volume [m^3],dissipated_energy "
             "[J]\n1,0,1e-9,1e-6,0,0,0,0,0,0,1e-7,1e-14,1e9,0,0\n2,1,2e-9,2e-6,0,0,0,0,0,0,1e-7,,1e9,0,0\n");
  corpus.add("result_json",
             "{\"format\": \"asperity-result/1\", \"title\": \"a\", \"complete\": true, \"inputs\": "
             "{\"radius\": 8.5e-6, \"control\": \"force\", "
             "\"particle\": {\"youngs_modulus\": 7.1e10, \"poissons_ratio\": 0.17, \"topography\": "
             "\"smooth\"}, \"substrate\": "
             "{\"youngs_modulus\": 1.3e11, \"poissons_ratio\": 0.22}}, \"mesh\": {\"interface_spacing\": "
             "{\"value\": 2e-8}}}");
  for (const char* text : {"2.5 um", "-1e-9 N", "5 %", "inf", "3 \xC2\xB0", "7 mJ/m^2"})
    corpus.add("quantity", text);
  corpus.add("topography_entry",
             "generated(rms=1.5 nm, window=2.5 um, hurst=0.8, rolloff=200 nm, cutoff=20 nm, seed=3, "
             "amplitudes=fixed)");
  corpus.add("topography_entry",
             "scan(a.gsf, size=2.5 um, channel=Height, unit=nm, level=plane, cutoff=20 nm, outside=mirror)");
  corpus.add("motion_program",
             "press 50 uN; slide 200 nm and spin 20 mrad; roll 30 mrad in 12 steps; slide across 5 nm; "
             "indenter 1 um");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  Corpus corpus(argv[1]);
  add_maps(corpus);
  add_instruments(corpus);
  add_recordings(corpus);
  add_parameters(corpus);
  return 0;
}
