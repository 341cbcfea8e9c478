#pragma once

namespace keiko {

/// Integral of exp(-u tan xi) over xi from `begin` to `end`, within 0 to pi/2, u >= 0: the airlight
/// of an isotropic point source along a ray in a uniform medium [Sun2005]
/// (docs/theory/fog.md#the-integral). In closed form, by the exponential integral of complex
/// numbers, to 1e-13 of the width.
double airlight(double u, double begin, double end);

} // namespace keiko
