// What `asperity preview` says, writes and draws.
#pragma once

#include <string>
#include <vector>

#include "core/case.h"
#include "half_space/previewed_case.h"

namespace asperity::report {

/// What the preview leaves out, a sentence each.
std::vector<std::string> left_out_sentences(const LeftOutOfPreview& left_out);

/// All of it in lines for a person.
std::vector<std::string> preview_lines(const CaseInput& input, const PreviewedCase& preview);

/// The same as JSON ("asperity-preview/1", docs/result.md).
std::string preview_json(const CaseInput& input, const PreviewedCase& preview);

/// The pressure seen from above, with axes and a colour bar: white where nothing presses, dark red at the
/// largest. SVG.
std::string pressure_picture(const half_space::CaseContact& contact);

}  // namespace asperity::report
