#pragma once

#include "keiko/light/rig/light_rig.h"

#include "tests/bench/penumbra_methods.h"

#include <array>

namespace keiko::bench {

/// View of a scene from its standing eye as a picture of diffuse surfaces, and some of its pixels
/// by themselves. In the picture neighbouring points share what they query of the lamps.
class PenumbraPicture {
public:
    /// `width` by 9/16 of it pixels. The centres of `count` random ones become the receivers of the
    /// scene, which is viewed from then on.
    PenumbraPicture(PenumbraScene& scene, int width, std::size_t count);

    /// Shares of those receivers as the picture has them, rendered by one thread with light taken
    /// linear to within `light_error`. The seconds are their share of the processor time, camera
    /// rays included. Axis or tube.
    Shares render(Emitter emitter, double light_error) const;
    /// Shares of `mean` lx under any rig, in the same way.
    Shares render(const LightRig& rig, double mean, double light_error) const;

private:
    const PenumbraScene& scene_;
    Camera camera_;
    std::vector<std::array<int, 2>> pixels_; ///< of the receivers
};

} // namespace keiko::bench
