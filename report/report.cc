#include "report/report.h"

#include <vtkObject.h>
#include <vtkSMPTools.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "dem_compare/cases/case_collection.h"
#include "report/case/case_report.h"
#include "report/study/study_report.h"

namespace asperity {

void write_report(const std::filesystem::path& directory) {
  // Drawing forks: there must be no threads of VTK's that a copy of the process would miss.
  vtkSMPTools::SetBackend("Sequential");
  vtkObject::GlobalWarningDisplayOff();  // what matters is said in the page
  report::SectionPainter painter;
  std::string page;
  if (is_study_folder(directory)) {
    const report::StudyReport study = report::study_report(directory, painter);
    for (const auto& [name, content] : study.files) write_file_atomically(directory / name, content);
    page = study.page;
  } else if (is_case_folder(directory)) {
    page = report::case_report_html(directory, painter);
  } else {
    throw InputError(directory.string() +
                     ": holds neither a solved case (history.csv) nor a study (study.json); name a folder "
                     "that 'asperity solve' or 'asperity study' wrote");
  }
  write_file_atomically(directory / "report.html", page);
}

}  // namespace asperity
