#pragma once

#include "keiko/light/tubes/clipped_pixel.h"
#include "keiko/light/tubes/lamp_ends.h"

namespace keiko {

/// Which side of an end's curve: of lesser u or of greater.
enum class Side { before, past };

/// Cuts strips in a pixel at the ends of lamps, by chords that bound as much as the curves.
class TubeEndClipper {
public:
    /// `half`: of a strip's width, mm.
    TubeEndClipper(double half, const PixelImage& image) : half_(half), image_(image) {}

    /// Of a part, which lies on the strip around `axis`, what is on one side of an end; to 1e-3 of
    /// a pixel or so.
    double area(const ClippedPixel& part, double axis, const LampEnd& end, Side side) const;
    /// The same as a part: of the side from which the curve bulges away.
    ClippedPixel cut(const ClippedPixel& part, double axis, const LampEnd& end, Side side) const;

private:
    /// Where the arc begins and ends on which a part lies: of the unit circle that a rim is across
    /// a strip, x along the lamp, half of it at the most.
    std::array<Vec2, 2> arc_on(const ClippedPixel& part, double axis) const;
    /// How often an arc is halved until chords are near enough; halves the chord with it.
    int halvings_of(double& half_chord, double bulge) const;

    double half_;
    const PixelImage& image_;
};

} // namespace keiko
