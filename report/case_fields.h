// Pictures of one solved case: its roughness, the pressure in the contact, a vertical section through both bodies.
#pragma once

#include <memory>
#include <string>

#include "dem_compare/solved_case.h"
#include "report/field_files.h"
#include "report/section_picture.h"
#include "report/virtual_display.h"

namespace asperity::report {

/// The display is started when the first section is drawn and shared by all.
class SectionPainter {
 public:
  std::vector<Image> draw(vtkPolyData& section, const std::vector<SectionView>& views);

 private:
  std::unique_ptr<VirtualDisplay> display_;
};

/// The field files at the largest load of the history (else the last); empty if none were written.
StepFiles files_at_largest_load(const SolvedCase& solved, const std::string& pvd);

/// Figures as HTML, or a note that says why there are none.
std::string roughness_figures(const SolvedCase& solved);
std::string pressure_map_figure(const SolvedCase& solved, const std::string& title);
std::string pressure_profile_figure(const SolvedCase& solved);
std::string section_figures(const SolvedCase& solved, SectionPainter& painter);

}  // namespace asperity::report
