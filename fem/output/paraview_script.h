// The script that opens a case's fields in ParaView as a picture rather than as a list of files.
#pragma once

#include <filesystem>
#include <string>

namespace asperity::fem {

/// Text of show_in_paraview.py for the fields in `folder`: contact pressure beside the bodies, displaced and
/// cut through the contact, coloured by stress. The folder's name stands in it as bytes, which are no code.
/// Checked with pvbatch of ParaView 5.11.
std::string paraview_script(const std::filesystem::path& folder);

}  // namespace asperity::fem
