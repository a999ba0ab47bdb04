// What a reader of one file format is, and what it hands over before sizes, rows and missing points are
// settled.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/registry.h"
#include "surfaces/read_topography.h"

namespace asperity {

/// A file as it lies on disk.
struct SourceFile {
  std::filesystem::path path;
  std::string bytes;

  std::string name() const { return "'" + path.string() + "'"; }
};

/// Which row of the image a file stores first.
enum class FirstRow { top, bottom };

/// Heights as a file holds them, already in metres.
struct StoredMap {
  int nx = 0, ny = 0;
  std::vector<double>
      heights;  ///< [row * nx + column] in m, rows in the order of the file; NaN where missing
  FirstRow first_row = FirstRow::top;
  std::optional<double> lx, ly;      ///< physical size [m], empty where the file does not say
  bool height_unit_assumed = false;  ///< metres were taken for want of a unit: refused if implausible
  bool lateral_unit_assumed = false;
  bool periodic = false;
  std::string channel;
  std::string scale;  ///< how stored numbers became metres, e.g. "heights in nm"
  std::string note;   ///< anything assumed, or empty
};

/// When a format is tried: text has no mark of its own at its beginning, and comes after those that have.
enum class Tried { by_mark, particular_text, any_text };

/// One format. Each file of formats/ is one, NAME.cc, and defines formats::make_NAME(); the build lists them.
struct TopographyFormat {
  std::string name;                     ///< as people call it
  std::vector<std::string> extensions;  ///< usual endings, lower case with the dot
  std::string begins_with;              ///< in words, for messages: how such a file begins
  bool (*recognises)(const SourceFile& file);
  StoredMap (*read)(const SourceFile& file, const ReadOptions& options);
  Tried tried = Tried::by_mark;
};

/// Adds a format that stands outside of formats/, before the first file is read.
using RegisteredFormat = Registered<TopographyFormat>;

/// What read_topography() makes of a file that is in memory already.
Topography topography_from(const SourceFile& file, const ReadOptions& options);

/// All formats in the order in which they are tried.
const std::vector<TopographyFormat>& topography_formats();

}  // namespace asperity
