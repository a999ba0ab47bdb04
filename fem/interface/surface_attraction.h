// The attraction of a case's surfaces as half-spaces take it.
#pragma once

#include <limits>
#include <optional>

#include "core/case.h"
#include "half_space/adhesive_contact.h"

namespace asperity::fem {

/// Gap at which all but a share of the work of adhesion has been done [m]; 0 without adhesion. left: that
/// share [-].
double attraction_reach(const InterfaceInput& input, double left = 0.02);

/// None: no adhesion, or one that is told as a force (Interface/Attraction force). Throws InputError as
/// make_adhesion_laws does.
std::optional<half_space::Attraction> surface_attraction(const InterfaceInput& input);

/// Of an attraction whose stress at contact is s and whose work of adhesion is w.
struct AttractionScales {
  /// Of the zone at the edge of a contact in which it acts (core/attraction_zone.h) [m].
  double zone = std::numeric_limits<double>::infinity();
  double length = 0;  ///< w/s, over which it falls with the gap [m]

  bool acts() const { return length > 0; }
};
/// Of a case; none acts where attraction is told as a force. Throws InputError as make_adhesion_laws does.
AttractionScales attraction_scales(const CaseInput& input);

}  // namespace asperity::fem
