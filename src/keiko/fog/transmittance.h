#pragma once

#include "keiko/fog/medium.h"
#include "keiko/luminance/photometry.h"

namespace keiko {

/// Share of light, by channel 0 to 1, that passes `length` mm of the medium unscattered; infinite
/// lengths are allowed.
inline Rgb transmittance(const Medium& medium, double length) {
    const Rgb& extinction = medium.extinction;
    return {passed_share(extinction.r, length), passed_share(extinction.g, length),
            passed_share(extinction.b, length)};
}

/// Luminance in cd/m2 that the medium's own ambient light adds along `length` mm: Ja (1 - T).
inline Rgb ambient_inscatter(const Medium& medium, double length) {
    const Rgb& extinction = medium.extinction;
    return medium.ambient * Rgb(lost_share(extinction.r, length), lost_share(extinction.g, length),
                                lost_share(extinction.b, length));
}

} // namespace keiko
