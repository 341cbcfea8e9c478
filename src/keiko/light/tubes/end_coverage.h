#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/light/tubes/plane_image.h"
#include "keiko/math/convex_clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {

/// Image of one end of a lamp on the plane, half of the image of a rim. At q across its strip, -1
/// to 1, it is the curve u = at + shear q + bulge sqrt(1 - q^2).
struct LampEnd {
    double at = 0;               ///< mm along u, like the others
    double shear = 0, bulge = 0; ///< mm, of either sign; the curve bulges to greater u if above 0
};

/// The images of the ends of a row's lamps on the plane; the same for each.
struct LampEnds {
    LampEnd begin; ///< at u = 0 of the row
    LampEnd end;   ///< at u = the length of the lamps

    /// Ends straight across the lamps.
    static LampEnds straight(const CPlaneFrame& frame) { return {{0}, {frame.length}}; }
    /// Ends of round tubes, for rays of a direction in frame coordinates. Each end appears shifted
    /// by the height at which rays meet the rim above or below the plane, times their slope along
    /// the lamps. Dark caps hide the near half of the rim, luminous ones show both.
    static LampEnds of_tubes(const CPlaneFrame& frame, const Vec3& d);
    /// True if rays meet dark caps at the begin.
    bool begins_with_cap() const { return begin.bulge > 0; }
};

/// A function linear in the place in the picture, relative to the pixel's centre.
struct PixelLinear {
    double amid;       ///< value at the pixel's centre
    double by_x, by_y; ///< rates, per pixel

    /// Value at a place, px from the centre.
    double at(const Vec2& place) const { return amid + by_x * place.x + by_y * place.y; }
};

/// A convex part of a pixel, px from its centre.
class ClippedPixel {
public:
    /// The whole pixel.
    ClippedPixel() : count_(4) {
        corners_[0] = {-0.5, -0.5}, corners_[1] = {0.5, -0.5};
        corners_[2] = {0.5, 0.5}, corners_[3] = {-0.5, 0.5};
    }
    /// Copies the corners in use alone.
    ClippedPixel(const ClippedPixel& other) : count_(other.count_) {
        std::copy(other.begin(), other.end(), corners_.begin());
    }
    /// Copies the corners in use alone; safe on itself.
    ClippedPixel& operator=(const ClippedPixel& other) {
        count_ = other.count_;
        std::copy(other.begin(), other.end(), corners_.begin());
        return *this;
    }

    /// The part where `side` is not negative.
    ClippedPixel where(const PixelLinear& side) const {
        ClippedPixel cut{Nothing()};
        clip_convex(
            std::span(begin(), count_), [&](std::size_t i) { return side.at(corners_[i]); },
            [&](const Vec2& corner) { cut.add(corner); });
        return cut;
    }
    /// True if `side` is not negative in all of it; true for an empty part.
    bool is_all_where(const PixelLinear& side) const {
        return std::all_of(begin(), end(),
                           [&](const Vec2& corner) { return side.at(corner) >= 0; });
    }
    /// True if `side` is not negative at any corner; false for an empty part.
    bool is_any_where(const PixelLinear& side) const {
        return std::any_of(begin(), end(),
                           [&](const Vec2& corner) { return side.at(corner) >= 0; });
    }
    /// Area in pixels, 0 to 1 of one within the pixel; 0 for fewer than three corners.
    double area() const {
        double twice = 0;
        for (std::size_t i = 2; i < count_; ++i)
            twice += (corners_[i - 1] - corners_[0]).cross(corners_[i] - corners_[0]);
        return std::abs(twice) / 2;
    }
    /// First corner; they go round the part.
    const Vec2* begin() const { return corners_.data(); }
    /// Place behind the last corner.
    const Vec2* end() const { return corners_.data() + count_; }

private:
    struct Nothing {};
    explicit ClippedPixel(Nothing) : count_(0) {}
    // Adds a corner. A cut adds one to the square's four, and the horizon, sides and chords of
    // three curves are some sixty. Corners that rounding adds to a line of them enclose no area.
    void add(const Vec2& corner) {
        if (count_ < corners_.size()) corners_[count_++] = corner;
    }

    std::array<Vec2, 64> corners_; // the first `count_` of them
    std::size_t count_;
};

/// Image of the places of a pixel on the plane: numerators and one denominator, which is positive
/// where their rays meet it.
class PixelImage {
public:
    /// Image around the hit (u, v) of the pixel's central ray, mm.
    PixelImage(const Vec2& centre, const Footprint& footprint)
        : centre_(centre),
          footprint_(footprint),
          denominator_{1, footprint.descent.x, footprint.descent.y} {}

    /// The part of the pixel whose rays meet the plane.
    ClippedPixel before_horizon() const {
        const ClippedPixel all;
        return all.is_all_where(denominator_) ? all : all.where(denominator_);
    }
    /// `slope` times the vector from a point of the plane, less `least`, times the denominator.
    PixelLinear past(const Vec2& slope, const Vec2& from, double least) const {
        const double off = slope.dot(centre_ - from) - least;
        return {off, slope.dot(footprint_.dx) + off * denominator_.by_x,
                slope.dot(footprint_.dy) + off * denominator_.by_y};
    }
    /// The piece of a part between two values of v.
    ClippedPixel between(const ClippedPixel& part, double low, double high) const {
        return part.where(past({0, 1}, {0, low}, 0)).where(past({0, -1}, {0, high}, 0));
    }
    /// v of a place; not finite on the horizon, to within rounding.
    double v(const Vec2& place) const {
        const double before = denominator_.at(place);
        const double rounding =
            1e-12 * (1 + std::abs(denominator_.by_x) + std::abs(denominator_.by_y));
        if (!(before > rounding)) return std::numeric_limits<double>::quiet_NaN();
        return centre_.y + (footprint_.dx.y * place.x + footprint_.dy.y * place.y) / before;
    }
    /// The smallest area of the image, mm2 per pixel: where the rays meet the plane most steeply.
    double least_area() const {
        const double most = 1 + (std::abs(denominator_.by_x) + std::abs(denominator_.by_y)) / 2;
        return std::abs(footprint_.dx.cross(footprint_.dy)) / (most * most * most);
    }

private:
    Vec2 centre_;
    Footprint footprint_;
    PixelLinear denominator_;
};

/// Side of an end's curve: of lesser u or of greater.
enum class Side {
    before, ///< lesser u
    past    ///< greater u
};

/// Cuts strips in a pixel at the ends of lamps, by chords that bound as much as the curves.
class TubeEndClipper {
public:
    /// `half`: half of a strip's width, mm.
    TubeEndClipper(double half, const PixelImage& image) : half_(half), image_(image) {}

    /// Area of a part, which lies on the strip around `axis`, on one side of an end; accurate to
    /// about 1e-3 of a pixel.
    double area(const ClippedPixel& part, double axis, const LampEnd& end, Side side) const;
    /// The part on one side of an end, as a polygon; requires the side from which the curve bulges
    /// away.
    ClippedPixel cut(const ClippedPixel& part, double axis, const LampEnd& end, Side side) const;

private:
    /// Begin and end of the arc on which a part lies. The arc is of the unit circle that a rim is
    /// across a strip, x along the lamp, and at most half of it.
    std::array<Vec2, 2> arc_on(const ClippedPixel& part, double axis) const;
    /// Number of halvings of an arc until chords are near enough; halves the chord with it.
    int halvings_of(double& half_chord, double bulge) const;

    double half_;
    const PixelImage& image_;
};

/// Share of a pixel whose image, `footprint` around `centre` (u, v), falls on strips of
/// `strip_width` mm between `ends`, 0 to 1. As the map is projective, the pixel's square is cut in
/// the picture itself, by the images of the strips' edges and of the chords of their ends
/// (homogeneous clipping [BlinnNewell1978]). The plane's horizon may thus run through it. If strips
/// overlap, each tube hides those that rays meet later. Not `resolved`: stripes too fine to be
/// distinguished, as a grey band.
double end_coverage(const CPlaneFrame& frame, double strip_width, bool resolved,
                    const LampEnds& ends, const Vec2& centre, const Footprint& footprint);

} // namespace keiko
