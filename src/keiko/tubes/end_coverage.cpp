#include "keiko/tubes/end_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Something linear in the place in the picture, off the pixel's centre.
struct Linear {
    double amid, by_x, by_y;

    double at(const Vec2& place) const { return amid + by_x * place.x + by_y * place.y; }
};

/// A convex part of a pixel, px off its centre.
class PixelCut {
public:
    /// All of it.
    PixelCut() : count_(4) {
        corners_[0] = {-0.5, -0.5}, corners_[1] = {0.5, -0.5};
        corners_[2] = {0.5, 0.5}, corners_[3] = {-0.5, 0.5};
    }

    /// What of it lies where `side` is not negative.
    PixelCut where(const Linear& side) const {
        PixelCut cut;
        cut.count_ = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 &a = corners_[i], &b = corners_[i + 1 < count_ ? i + 1 : 0];
            const double from = side.at(a), to = side.at(b);
            if (from >= 0) cut.corners_[cut.count_++] = a;
            if ((from >= 0) != (to >= 0))
                cut.corners_[cut.count_++] = a + (b - a) * (from / (from - to));
        }
        return cut;
    }
    double area() const {
        double twice = 0;
        for (std::size_t i = 2; i < count_; ++i)
            twice += (corners_[i - 1] - corners_[0]).cross(corners_[i] - corners_[0]);
        return std::abs(twice) / 2;
    }
    const Vec2* begin() const { return corners_.data(); }
    const Vec2* end() const { return corners_.data() + count_; }

private:
    // A cut adds a corner, and however it is rounded half as many as there are: five leave 28.
    std::array<Vec2, 32> corners_{Vec2(0)};
    std::size_t count_;
};

/// Where the places of a pixel are on the plane: numerators and one denominator, which is positive
/// where their rays meet it.
class Projection {
public:
    Projection(const Vec2& centre, const Footprint& footprint)
        : centre_(centre),
          footprint_(footprint),
          denominator_{1, footprint.descent.x, footprint.descent.y} {}

    PixelCut before_horizon(const PixelCut& part) const { return part.where(denominator_); }
    /// What of a part is between two values of a coordinate.
    PixelCut between(const PixelCut& part, unsigned axis, double low, double high) const {
        const Linear past_low = past(axis, low), past_high = past(axis, high);
        return part.where(past_low).where({-past_high.amid, -past_high.by_x, -past_high.by_y});
    }
    /// No number on the horizon, to rounding.
    double v(const Vec2& place) const {
        const double before = denominator_.at(place);
        const double rounding =
            1e-12 * (1 + std::abs(denominator_.by_x) + std::abs(denominator_.by_y));
        if (!(before > rounding)) return std::numeric_limits<double>::quiet_NaN();
        return centre_.y + (footprint_.dx.y * place.x + footprint_.dy.y * place.y) / before;
    }

private:
    /// By how much a coordinate is more than a value, times the denominator.
    Linear past(unsigned axis, double value) const {
        const double off = centre_[axis] - value;
        return {off, footprint_.dx[axis] + off * denominator_.by_x,
                footprint_.dy[axis] + off * denominator_.by_y};
    }

    Vec2 centre_;
    Footprint footprint_;
    Linear denominator_;
};

/// Of the part that strips, narrower than the pitch, fill.
double area_on_strips(const CPlaneFrame& frame, double half, const Projection& image,
                      const PixelCut& part) {
    double low = frame.last(), high = frame.first;
    for (const Vec2& corner : part) {
        const double v = image.v(corner);
        low = std::isfinite(v) ? std::min(low, v) : frame.first;
        high = std::isfinite(v) ? std::max(high, v) : frame.last();
    }
    const double first = std::ceil((low - half - frame.first) / frame.pitch);
    const double last = std::floor((high + half - frame.first) / frame.pitch);
    double sum = 0;
    for (double i = std::max(first, 0.0); i <= std::min(last, frame.lamps - 1.0); ++i) {
        const double axis = frame.axis(static_cast<int>(i));
        sum += image.between(part, 1, axis - half, axis + half).area();
    }
    return sum;
}

} // namespace

double end_coverage(const CPlaneFrame& frame, double strip_width, bool resolved,
                    const LampEnds& ends, const Vec2& centre, const Footprint& footprint) {
    if (frame.lamps == 0) return 0;
    const Projection image(centre, footprint);
    const PixelCut part = image.between(image.before_horizon(PixelCut()), 0, ends.begin, ends.end);
    const auto band = [&](double beyond) {
        return image.between(part, 1, frame.first - beyond, frame.last() + beyond).area();
    };
    if (!resolved) return std::min(strip_width / frame.pitch, 1.0) * band(frame.pitch / 2);
    return strip_width < frame.pitch ? area_on_strips(frame, strip_width / 2, image, part)
                                     : band(strip_width / 2);
}

} // namespace keiko
