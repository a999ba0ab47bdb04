// The script that opens a case's fields in ParaView as a picture rather than as a list of files.
#pragma once

#include <string>

namespace asperity::fem {

/// Text of show_in_paraview.py, the same for all cases: contact pressure beside the bodies, displaced and cut
/// through the contact, coloured by plastic strain or stress. Checked with ParaView 5.11.
std::string paraview_script();

}  // namespace asperity::fem
