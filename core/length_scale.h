// The length that a moment of rolling or torsion is counted in.
#pragma once

namespace asperity {

/// lambda of the limit mu lambda (f + h), or what a stiffness grows with: the particle's radius (its lever
/// arm), that of the contact, or none.
enum class LengthScale { none, particle_radius, contact_radius };

}  // namespace asperity
