// Coefficient of restitution of a Hertz contact with the dashpot gamma = c (m k_n)^(1/2), k_n = 2 E* a: it
// does not depend on the speed (Tsuji et al. 1992; Antypov and Elliott 2011). Ends when the approach has come
// back to zero.
#pragma once

namespace asperity {

/// Restitution e [-] for a factor c [-].
/// Throws InputError for c outside of 0 to 1.83, where nothing comes back.
double hertz_restitution(double damping_factor);
/// The c that gives a restitution between 0.1 and 1.
/// Restitution [-] in, c [-] out.
double hertz_damping_factor(double restitution);

}  // namespace asperity
