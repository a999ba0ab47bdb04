// What was measured (Fuchs, Weinhart et al. 2014, Tables 1 and 2, sec. 4): the last column of the comparison.
// Only where the contact is the paper's own: its sphere, its materials, a substrate whose RMS is that of a
// measured surface within its sd, and a load within those measured. SI units.
#pragma once

#include "dem_compare/compare/measured_column.h"
#include "paper/published.h"

namespace asperity {

class PublishedColumn : public MeasuredColumn {
 public:
  explicit PublishedColumn(Published published) : published_(std::move(published)) {}

  ComparedValue value(Quantity quantity, const ComparedContact& contact, double load) const override;
  ComparedValue rail(Quantity quantity, const ComparedContact& contact, double angle,
                     double load) const override;
  /// Rails of the paper: rolling at their own roughness by its eq:murofit, the offset by eq:frofit through
  /// the points of Table 2 (as printed it misses them), loads from those on the plate.
  std::vector<RailCase> rails() const override;
  double rail_rms(double angle) const override;
  /// Sphere and plane are the paper's; the plane's name, "" if not.
  std::string plane_of(const ComparedContact& contact) const;
  /// The measured surface that a substrate stands for: its RMS within the measured one's sd; null if there is
  /// none.
  const PublishedSurface* surface_of(const ComparedContact& contact) const;
  /// Sphere and flat indenter of the rolling experiment, whatever its roughness.
  bool is_with_indenter(const ComparedContact& contact) const;

 private:
  Published published_;
};

}  // namespace asperity
