#include "surfaces/readers/netcdf_library.h"

#include <dlfcn.h>

#include <string>

#include "core/error.h"

namespace asperity {
namespace {

/// Finds functions in the library by their names.
class Loaded {
 public:
  Loaded() : handle_(::dlopen(ASPERITY_NETCDF, RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_) refuse("");
  }
  template <class Function>
  void find(Function& function, const char* name) const {
    function = reinterpret_cast<Function>(::dlsym(handle_, name));
    if (!function) refuse(std::string(" with ") + name);
  }

 private:
  [[noreturn]] static void refuse(const std::string& what) {
    throw InputError("reading NetCDF takes the library " ASPERITY_NETCDF + what +
                     ", which is not installed; install Debian's libnetcdf19, or export the map as .gsf");
  }
  void* handle_;  ///< for as long as the program runs
};

NetcdfLibrary load() {
  const Loaded library;
  NetcdfLibrary n{};
  library.find(n.open_mem, "nc_open_mem");
  library.find(n.close, "nc_close");
  library.find(n.strerror, "nc_strerror");
  library.find(n.free_string, "nc_free_string");
  library.find(n.get_att_double, "nc_get_att_double");
  library.find(n.get_att_string, "nc_get_att_string");
  library.find(n.get_att_text, "nc_get_att_text");
  library.find(n.get_var_double, "nc_get_var_double");
  library.find(n.inq_att, "nc_inq_att");
  library.find(n.inq_dim, "nc_inq_dim");
  library.find(n.inq_type, "nc_inq_type");
  library.find(n.inq_var_chunking, "nc_inq_var_chunking");
  library.find(n.inq_vardimid, "nc_inq_vardimid");
  library.find(n.inq_varid, "nc_inq_varid");
  library.find(n.inq_varndims, "nc_inq_varndims");
  library.find(n.inq_vartype, "nc_inq_vartype");
  return n;
}

}  // namespace

const NetcdfLibrary& libnetcdf() {
  static const NetcdfLibrary library = load();
  return library;
}

}  // namespace asperity
