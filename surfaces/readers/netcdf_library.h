// libnetcdf, loaded when the first NetCDF file is read: with all that it links it is three quarters of the
// libraries that a start of the program would load.
#pragma once

#include <netcdf.h>
#include <netcdf_mem.h>

namespace asperity {

/// Its functions that are called here, by their own names without nc_.
struct NetcdfLibrary {
  decltype(&::nc_open_mem) open_mem;
  decltype(&::nc_close) close;
  decltype(&::nc_strerror) strerror;
  decltype(&::nc_free_string) free_string;
  decltype(&::nc_get_att_double) get_att_double;
  decltype(&::nc_get_att_string) get_att_string;
  decltype(&::nc_get_att_text) get_att_text;
  decltype(&::nc_get_var_double) get_var_double;
  decltype(&::nc_inq_att) inq_att;
  decltype(&::nc_inq_dim) inq_dim;
  decltype(&::nc_inq_type) inq_type;
  decltype(&::nc_inq_var_chunking) inq_var_chunking;
  decltype(&::nc_inq_vardimid) inq_vardimid;
  decltype(&::nc_inq_varid) inq_varid;
  decltype(&::nc_inq_varndims) inq_varndims;
  decltype(&::nc_inq_vartype) inq_vartype;
};

/// Loads it the first time. Throws InputError where it is not installed, naming the package.
const NetcdfLibrary& libnetcdf();

}  // namespace asperity
