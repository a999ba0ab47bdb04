// The list of formats: a new one needs its own file in this folder and one name here.
#include "surfaces/readers/format.h"

namespace asperity {

TopographyFormat gsf_format();
TopographyFormat gwy_format();
TopographyFormat nanoscope_format();
TopographyFormat park_tiff_format();
TopographyFormat netcdf_format();
TopographyFormat x3p_format();
TopographyFormat xyz_format();
TopographyFormat text_matrix_format();

const std::vector<TopographyFormat>& topography_formats() {
  static const std::vector<TopographyFormat> formats{
      gsf_format(), gwy_format(), nanoscope_format(), park_tiff_format(), netcdf_format(), x3p_format(),
      // text has no mark of its own at its beginning, so it is tried last
      xyz_format(), text_matrix_format()};
  return formats;
}

}  // namespace asperity
