// NetCDF as SurfaceTopography and contact.engineering write it: a variable `heights` over the dimensions `x`
// and `y`; variables `x` and `y` with attributes `length`, `periodic` and `unit` (older files:
// `length_unit`). The first index along y is the top of the image, as in that program's own readers of
// instrument files. Missing: NaN or fill value. No real file was at hand: checked only against files that the
// tests write from this description.
#include <climits>
#include <limits>
#include <vector>

#include "core/error.h"
#include "core/read_limits.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/netcdf_classic.h"
#include "surfaces/readers/netcdf_library.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

/// An open file; closed on leaving.
class NetcdfFile {
 public:
  explicit NetcdfFile(const SourceFile& file) : file_(file) {
    // From memory, so that no other file and no address is ever opened; libnetcdf does not write to it.
    check(libnetcdf().open_mem(file.path.string().c_str(), NC_NOWRITE, file.bytes.size(),
                               const_cast<char*>(file.bytes.data()), &id_));
  }
  ~NetcdfFile() { libnetcdf().close(id_); }
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  int id() const { return id_; }
  void check(int status) const {
    if (status != NC_NOERR)
      throw InputError(file_.name() + " cannot be read as NetCDF (" + libnetcdf().strerror(status) +
                       "): it is cut off or damaged; copy or export it again");
  }
  /// Number of a variable, or -1.
  int variable(const std::string& name) const {
    int variable = -1;
    return libnetcdf().inq_varid(id_, name.c_str(), &variable) == NC_NOERR ? variable : -1;
  }
  std::optional<double> number(int variable, const std::string& attribute) const {
    double value = 0;
    std::size_t length = 0;
    nc_type type = NC_NAT;
    if (libnetcdf().inq_att(id_, variable, attribute.c_str(), &type, &length) != NC_NOERR || length != 1)
      return std::nullopt;
    if (type == NC_CHAR || type == NC_STRING) return std::nullopt;
    check(libnetcdf().get_att_double(id_, variable, attribute.c_str(), &value));
    return value;
  }
  std::string text(int variable, const std::string& attribute) const {
    std::size_t length = 0;
    nc_type type = NC_NAT;
    if (libnetcdf().inq_att(id_, variable, attribute.c_str(), &type, &length) != NC_NOERR || length == 0)
      return "";
    if (type == NC_CHAR) {
      std::string value(length, ' ');
      check(libnetcdf().get_att_text(id_, variable, attribute.c_str(), value.data()));
      return trimmed_text(value);
    }
    if (type != NC_STRING || length != 1) return "";
    char* value = nullptr;
    check(libnetcdf().get_att_string(id_, variable, attribute.c_str(), &value));
    std::string copy = value ? trimmed_text(value) : "";
    libnetcdf().free_string(1, &value);
    return copy;
  }
  std::string unit(int variable) const {
    if (variable < 0) return "";
    for (const char* name : {"unit", "length_unit", "units"})
      if (std::string value = text(variable, name); !value.empty()) return value;
    return "";
  }

 private:
  const SourceFile& file_;
  int id_ = -1;
};

struct Axis {
  std::string name;
  std::size_t points = 0;
};

/// The two dimensions of `heights` in the order in which they are stored.
std::vector<Axis> axes_of(const SourceFile& file, const NetcdfFile& netcdf, int heights) {
  int count = 0;
  netcdf.check(libnetcdf().inq_varndims(netcdf.id(), heights, &count));
  if (count != 2)
    throw InputError(file.name() + " has heights over " + std::to_string(count) +
                     " dimension(s), a profile and not a map; pass a topography measured over x and y");
  int dimensions[2];
  netcdf.check(libnetcdf().inq_vardimid(netcdf.id(), heights, dimensions));
  std::vector<Axis> axes(2);
  for (int i = 0; i < 2; ++i) {
    char name[NC_MAX_NAME + 1];
    netcdf.check(libnetcdf().inq_dim(netcdf.id(), dimensions[i], name, &axes[i].points));
    axes[i].name = name;
  }
  const bool known =
      (axes[0].name == "x" && axes[1].name == "y") || (axes[0].name == "y" && axes[1].name == "x");
  if (!known)
    throw InputError(file.name() + " has heights over '" + axes[0].name + "' and '" + axes[1].name +
                     "'; name the dimensions x and y");
  return axes;
}

/// Length of an axis in metres: its attribute `length` in its unit (or the heights' unit).
std::optional<double> axis_length(const NetcdfFile& netcdf, const std::string& name,
                                  const std::string& fallback_unit) {
  const int variable = netcdf.variable(name);
  if (variable < 0) return std::nullopt;
  const std::string own_unit = netcdf.unit(variable);
  const auto factor = length_unit_factor(own_unit.empty() ? fallback_unit : own_unit);
  const auto length = netcdf.number(variable, "length");
  return factor && length ? std::optional<double>(*length * *factor) : std::nullopt;
}

bool is_fill(double value, const std::vector<double>& fills) {
  for (const double fill : fills)
    if (value == fill) return true;
  return false;
}

bool is_classic(const SourceFile& file) { return file.bytes.compare(0, 3, "CDF") == 0; }

void check_whole(const SourceFile& file) {
  if (!is_classic(file)) return;  // HDF5 checks its own length
  const auto length = netcdf_classic_length(file.bytes);
  if (length && file.bytes.size() >= *length) return;
  throw InputError(
      file.name() +
      (length ? " has " + std::to_string(file.bytes.size()) + " of its " + std::to_string(*length) + " bytes"
              : std::string(" ends inside its NetCDF header")) +
      ": it is cut off; copy or export it again");
}

/// Nothing is allocated for points that the file cannot hold: a classic file is not packed; one of HDF5 may
/// be, in chunks, of which libnetcdf keeps some unpacked.
void check_points(const SourceFile& file, const NetcdfFile& netcdf, int heights, std::size_t columns,
                  std::size_t rows) {
  nc_type type = NC_NAT;
  std::size_t stored_size = 0;
  netcdf.check(libnetcdf().inq_vartype(netcdf.id(), heights, &type));
  if (type == NC_CHAR || type > NC_UINT64 ||
      libnetcdf().inq_type(netcdf.id(), type, nullptr, &stored_size) != NC_NOERR)
    throw InputError(file.name() + " has heights that are no numbers; export the topography");
  const auto refuse = [&](const std::string& what) {
    throw InputError(file.name() + " announces " + what + ", too many for a file of " +
                     std::to_string(file.bytes.size()) +
                     " bytes: it is damaged, or must be passed in another format, such as .gsf");
  };
  const std::string announced = std::to_string(columns) + " x " + std::to_string(rows) + " points";
  const std::uint64_t most_points = is_classic(file)
                                        ? file.bytes.size() / stored_size
                                        : read_limits::most_unpacked(file.bytes.size()) / sizeof(double);
  if (columns > INT_MAX || rows > INT_MAX || (rows > 0 && columns > most_points / rows)) refuse(announced);
  int storage = NC_CONTIGUOUS;
  std::size_t chunk[2] = {0, 0};
  netcdf.check(
      libnetcdf().inq_var_chunking(netcdf.id(), heights, &storage, chunk));  // a classic file is contiguous
  if (storage == NC_CHUNKED && chunk[1] > 0 && chunk[0] > most_points / chunk[1])
    refuse("chunks of " + std::to_string(chunk[0]) + " x " + std::to_string(chunk[1]) + " points");
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  check_whole(file);
  const NetcdfFile netcdf(file);
  const int heights = netcdf.variable("heights");
  if (heights < 0)
    throw InputError(file.name() +
                     " is a NetCDF file without a variable 'heights'; pass a topography that "
                     "contact.engineering or SurfaceTopography wrote");
  if (options.channel && lower_case(*options.channel) != "heights" && *options.channel != "0")
    throw InputError(file.name() + " has no channel '" + *options.channel + "'; its only one is 'heights'");
  const auto axes = axes_of(file, netcdf, heights);
  const bool x_first = axes[0].name == "x";
  const std::size_t columns = axes[x_first ? 0 : 1].points, rows = axes[x_first ? 1 : 0].points;
  check_points(file, netcdf, heights, columns, rows);
  std::vector<double> stored(columns * rows);
  if (!stored.empty()) netcdf.check(libnetcdf().get_var_double(netcdf.id(), heights, stored.data()));
  std::vector<double> fills{NC_FILL_DOUBLE};
  for (const char* name : {"_FillValue", "missing_value"})
    if (const auto fill = netcdf.number(heights, name)) fills.push_back(*fill);

  const std::string lateral_unit = netcdf.unit(netcdf.variable("x"));
  const std::string own_unit = netcdf.unit(heights);
  const std::string unit = own_unit.empty() ? lateral_unit : own_unit;
  const auto factor = length_unit_factor(unit);
  if (!factor && !unit.empty())
    throw InputError(file.name() + " has heights in '" + unit +
                     "', which is no length; export the topography");
  StoredMap map;
  map.height_unit_assumed = !factor;
  if (!factor) map.note = "no unit of height given, metres taken";
  map.nx = static_cast<int>(columns);
  map.ny = static_cast<int>(rows);
  map.heights.resize(stored.size());
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double value = stored[x_first ? column * rows + row : row * columns + column];
      map.heights[row * columns + column] =
          is_fill(value, fills) ? std::numeric_limits<double>::quiet_NaN() : value * factor.value_or(1.0);
    }
  map.lx = axis_length(netcdf, "x", unit);
  map.ly = axis_length(netcdf, "y", unit);
  const int x = netcdf.variable("x"), y = netcdf.variable("y");
  map.periodic = x >= 0 && y >= 0 && netcdf.number(x, "periodic").value_or(0) != 0 &&
                 netcdf.number(y, "periodic").value_or(0) != 0;
  map.channel = "heights";
  map.scale = "heights in " + (factor ? plain_unit(unit) : "m");
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) {
  const std::string hdf5 = "\x89HDF\r\n";
  return is_classic(file) || file.bytes.compare(0, hdf5.size(), hdf5) == 0;
}

}  // namespace

namespace formats {
TopographyFormat make_netcdf() {
  return {"NetCDF of contact.engineering (.nc)",
          {".nc", ".nc4"},
          "the mark 'CDF' or that of HDF5",
          recognises,
          read};
}
}  // namespace formats

}  // namespace asperity
