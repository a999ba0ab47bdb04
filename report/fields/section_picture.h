// Draws a vertical section coloured by one of its cell arrays, with VTK on a display.
#pragma once

#include <vtkPolyData.h>

#include <string>
#include <vector>

#include "report/fields/map_figure.h"
#include "report/fields/png.h"
#include "report/page/colour_scale.h"

namespace asperity::report {

/// What is drawn, in which window.
struct SectionView {
  std::string array;                                    ///< cell data
  double x_low = 0, x_high = 0, z_low = 0, z_high = 0;  ///< window [m]
  const ColourScale* scale = &ColourScale::viridis();
  ColourRange range;
  bool edges = true;  ///< of the mesh
  int width = 900;    ///< pixels
};

/// Each view as an image. The drawing runs in a process of its own, so that a display that fails cannot take
/// the report with it: throws WorkError then.
std::vector<Image> draw_sections(vtkPolyData& section, const std::vector<SectionView>& views,
                                 const std::string& display);

}  // namespace asperity::report
