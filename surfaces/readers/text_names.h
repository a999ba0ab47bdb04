// Names under which programs and people write the header of a height map in text, in lower case.
#pragma once

#include <string>
#include <vector>

namespace asperity::text_names {

inline const std::vector<std::string> width{"width",  "breite", "x-length",   "x length",
                                            "size x", "x size", "x-size",     "size_x",
                                            "lx",     "xreal",  "scan size x"};
inline const std::vector<std::string> height{"height",   "höhe",   "h\xF6he", "y-length",
                                             "y length", "size y", "y size",  "y-size",
                                             "size_y",   "ly",     "yreal",   "scan size y"};
inline const std::vector<std::string> size{"size",          "scan size",  "scansize",
                                           "physical size", "image size", "scan range"};
inline const std::vector<std::string> pixel{"pixel size", "pixel",        "pixelsize", "dx",
                                            "spacing",    "grid spacing", "sampling"};
inline const std::vector<std::string> lateral_unit{"lateral units", "lateral unit", "xy unit", "xy units",
                                                   "xyunits",       "x-unit",       "x unit",  "xunit",
                                                   "x_unit",        "length unit"};
inline const std::vector<std::string> value_unit{
    "value units", "value unit", "z unit",      "z units",      "z-unit",     "z-units",       "z_unit",
    "zunit",       "zunits",     "height unit", "height units", "heights in", "werteinheiten", "werteinheit"};
inline const std::vector<std::string> any_unit{"unit", "units", "einheit", "einheiten"};
inline const std::vector<std::string> channel{"channel", "kanal", "title", "channel name"};

}  // namespace asperity::text_names
