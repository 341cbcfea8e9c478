#pragma once

namespace keiko {

/// Integral of exp(-u tan xi) over xi from `begin` to `end`, within 0 to pi/2, u >= 0: what an even
/// point source leaves along a ray in an even medium (physics 8.6, eq. (8.2); Sun et al. 2005). In
/// closed form, by the exponential integral of complex numbers, to 1e-13 of the width.
double airlight(double u, double begin, double end);

} // namespace keiko
