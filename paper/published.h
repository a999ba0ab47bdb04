// What the paper prints: Fuchs, Weinhart et al. (2014), arXiv:1401.2600, Tables 1 and 2 and quoted numbers,
// read from the small files of runs/paper/published. SI units.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/hertz.h"
#include "core/quantity.h"
#include "dem_compare/numbers/uncertain.h"

namespace asperity {

/// Table 1.
struct PublishedBody {
  std::string name, role;
  ElasticBody elasticity;
  double radius = 0;  ///< [m]; NaN for planes
  Uncertain rms;      ///< [m]
};

/// Table 2, upper part: one silicon surface.
struct PublishedSurface {
  std::string name;
  Uncertain rms, peak_to_valley;          ///< [m]
  Uncertain pull_off;                     ///< h_n [N]
  Uncertain sliding, sliding_offset;      ///< mu_l; h_l [N]
  Uncertain rolling_r, rolling_r_offset;  ///< mean over both contacts, lambda = r; [N]
  Uncertain rolling_a, rolling_a_offset;  ///< lambda = a
};

/// Table 2, lower part: one V-rail.
struct PublishedRail {
  Uncertain angle;           ///< as in text and figures [rad]
  double printed_angle = 0;  ///< as in the table [rad]
  Uncertain rms;             ///< [m]
  Uncertain friction;        ///< mu_rail
  Uncertain offset;          ///< h_rail [N]
};

class Published {
 public:
  std::vector<PublishedBody> bodies;
  std::vector<PublishedSurface> surfaces;
  std::vector<PublishedRail> rails;

  /// By its name; Throws InputError naming what is not there.
  const PublishedBody& body(const std::string& name) const;
  const PublishedBody& particle() const { return body("borosilicate"); }
  /// Of the particle [m].
  double radius() const { return particle().radius; }
  /// Of the particle with a plane.
  Hertz hertz(const std::string& plane) const;
  /// A number of text, caption or equation [SI]; throws InputError naming the file.
  Uncertain quoted(const std::string& name, Dimension dimension = Dimension::none) const;

 private:
  friend Published read_published(const std::filesystem::path& folder);
  struct Quoted {
    Uncertain number;  ///< in its unit
    std::string unit;
  };
  std::map<std::string, Quoted> quoted_;
  std::string folder_;
};

/// Reads bodies.csv, surfaces.csv, rails.csv and quoted.csv; throws InputError naming file and column.
Published read_published(const std::filesystem::path& folder);

}  // namespace asperity
