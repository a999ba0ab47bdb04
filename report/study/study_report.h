// The page of a study: its contacts side by side, with scatter over realisations, and the cases that are
// missing. Contacts that were pressed are set beside Hertz, those that slid, rolled or spun answer what
// resists them.
#pragma once

#include <map>
#include <string>

#include "report/fields/section_figures.h"

namespace asperity::report {

struct StudyReport {
  std::string page;
  std::map<std::string, std::string>
      files;  ///< further ones by name: resistance.csv and resistance.json of moving contacts
};
StudyReport study_report(const std::filesystem::path& folder, SectionPainter& painter);

}  // namespace asperity::report
