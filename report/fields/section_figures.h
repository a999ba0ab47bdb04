// A vertical section through both bodies of one solved case: stress and plastic strain.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "report/fields/section_picture.h"
#include "report/fields/virtual_display.h"
#include "results/solved_case.h"

namespace asperity::report {

/// The display is started when the first section is drawn and shared by all.
class SectionPainter {
 public:
  /// One picture for each view. Throws WorkError where no display can be started.
  std::vector<Image> draw(vtkPolyData& section, const std::vector<SectionView>& views);

 private:
  std::unique_ptr<VirtualDisplay> display_;
};

/// Figures as HTML, or a note that says why there are none.
std::string section_figures(const SolvedCase& solved, SectionPainter& painter);

}  // namespace asperity::report
