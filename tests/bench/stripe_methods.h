#pragma once

#include "keiko/render/shading/picture.h"

#include <string>
#include <vector>

namespace keiko::bench {

/// A body in black paint without a base that shines under a row of lamps that are many in its
/// mirror image.
struct StripeScene {
    std::string name{};
    Tracer tracer;
    std::vector<Material> materials{};
    LightRig rig{};
    Camera camera{};

    /// `camera`: looked from; its size is the picture's.
    StripeScene(std::string name, const SurfaceModel& body, const Camera& from);

    PictureScene picture() const { return {tracer, materials, rig, Rgb(36)}; }
};

/// Film as Keiko draws it: one ray a pixel with its footprint, `edge_samples`^2 where outlines
/// cross.
Film with_footprints(const StripeScene& scene, int edge_samples);
/// `n`^2 rays at the centres of each pixel's cells, their mean; without footprints, or each with
/// its cell's.
Film supersampled(const StripeScene& scene, int n, bool footprints);

/// Error of a picture in display space, 0 to 1, white being the same for both: RMS over the pixels
/// for which `chosen` holds, one of `chosen` a pixel.
double display_rms(const Film& picture, const Film& truth, const std::vector<bool>& chosen);
/// Pixels that two pictures show alike.
std::vector<bool> same_pixels(const Film& a, const Film& b);

} // namespace keiko::bench
