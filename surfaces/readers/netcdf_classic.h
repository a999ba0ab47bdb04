// How long a NetCDF classic file must be: libnetcdf reads what is cut off as zeros, which are no heights.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace asperity {

/// Bytes that the variables of a classic file (CDF-1, CDF-2, CDF-5) reach to, from its header (NetCDF user
/// guide, "File Format Specifications"); padding between the parts of a record is left out. Empty if the file
/// ends inside its header.
std::optional<std::uint64_t> netcdf_classic_length(const std::string& bytes);

}  // namespace asperity
