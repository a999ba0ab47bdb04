// All files of instrument_files.h and jpk_file.h by name.
#pragma once

#include "tests/surfaces/readers/instrument_files.h"
#include "tests/surfaces/readers/jpk_file.h"

namespace asperity::test {

/// A file of the common map.
struct InstrumentFile {
  std::string name;
  std::string bytes;
  bool says_size = true;  ///< else size and unit of heights are to be passed
  bool is_text = false;   ///< cut off in its last number it is a map still
};

inline std::vector<InstrumentFile> instrument_files() {
  const std::string nanoscope_text =
      "\"?*File list\"\r\n\"\\Version: 0x08150300\"\r\n\"\\*Ciao image list\"\r\n\"\\Scan Size: 3 2 ~m\"\r\n"
      "\"\\@2:Image Data: S [Phase] \"Phase\"\"\r\n\"\\*Ciao image list\"\r\n\"\\Scan Size: 3 2 ~m\"\r\n"
      "\"\\@2:Image Data: S [ZSensor] \"Height Sensor\"\"\r\n\"\\*File list end\"\r\n"
      "\\Exported image units: deg\r\n1,1,1\r\n1,1,1\r\n\\Exported image units: nm\r\n4,5,6\r\n1,2,3\r\n";
  return {{"npy", npy_map(), false},
          {"mat", mat_map(), false},
          {"ibw", igor_map()},
          {"nid", nid_map()},
          {"sur", sur_map()},
          {"opd", opd_map()},
          {"al3d", al3d_map()},
          {"mi", mi_map()},
          {"sdf", sdf_map()},
          {"sdf_text", sdf_text(), true, true},
          {"os3d", os3d_map()},
          {"stp", wsxm_map()},
          {"dat", metropro_map()},
          {"vk4", vk4_map()},
          {"bcr", bcr_map()},
          {"bcrf", bcrf_map()},
          {"frt", frt_map()},
          {"jpk", jpk_map()},
          {"nanoscope_text", nanoscope_text, true, true}};
}

}  // namespace asperity::test
