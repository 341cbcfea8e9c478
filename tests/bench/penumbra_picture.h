#pragma once

#include "tests/bench/penumbra_methods.h"

#include <array>

namespace keiko::bench {

/// What the standing eye of a scene sees as a picture of matte surfaces, in which neighbouring
/// points share what they ask of the lamps, and some of its pixels by themselves.
class PenumbraPicture {
public:
    /// `width` by 9/16 of it pixels. The centres of `count` random ones become the receivers of the
    /// scene, which is looked at from then on.
    PenumbraPicture(PenumbraScene& scene, int width, std::size_t count);

    /// Those receivers as the picture has them, rendered by one thread with light taken linear to
    /// within `light_error`; their share of the processor time, camera rays included. Axis or tube.
    Shares render(Emitter emitter, double light_error) const;

private:
    const PenumbraScene& scene_;
    Camera camera_;
    std::vector<std::array<int, 2>> pixels_; ///< of the receivers
};

} // namespace keiko::bench
