#include "keiko/light/tubes/end_coverage.h"

#include "keiko/light/tubes/tube_end_clipper.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

/// The strips of a row in a pixel.
class RowInPixel {
public:
    RowInPixel(const CPlaneFrame& frame, double strip_width, const LampEnds& ends,
               const Vec2& centre, const Footprint& footprint)
        : frame_(frame),
          half_(strip_width / 2),
          ends_(ends),
          image_(centre, footprint),
          cutter_(half_, image_),
          pixel_(image_.before_horizon()) {}

    /// Of strips narrower than the pitch.
    double of_strips_apart() const {
        double sum = 0;
        for_each_lamp([&](double axis, const ClippedPixel& strip) {
            sum += seen_of(cut_convex(strip, axis), axis);
        });
        return sum;
    }
    /// Of strips that overlap: of each lamp what is seen past the tube, cap included, that rays
    /// meet right before it. What tubes before that one hide is hidden by that one too. (Tubes that
    /// shine all over may be taken in either order.)
    double of_overlapping_strips() const {
        double sum = 0;
        for_each_lamp([&](double axis, const ClippedPixel& strip) {
            const ClippedPixel part = cut_convex(strip, axis);
            sum += seen_of(part, axis) - hidden_of(part, axis);
        });
        return std::clamp(sum, 0.0, 1.0);
    }
    /// Of strips too fine to be told apart, in the mean over the places that they may have.
    double of_grey_band() const {
        const int count = ends_.begin.shear == 0 ? 1 : 8;
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            const double q = (i + 0.5) * 2 / count - 1;
            const auto at = [&](const LampEnd& end) {
                return end.at + end.shear * q + pi / 4 * end.bulge;
            };
            const ClippedPixel part = pixel_.where(image_.past({1, 0}, {at(ends_.begin), 0}, 0))
                                          .where(image_.past({-1, 0}, {at(ends_.end), 0}, 0));
            sum += band(part, frame_.pitch / 2);
        }
        return 2 * half_ / frame_.pitch * sum / count;
    }

private:
    double band(const ClippedPixel& part, double beyond) const {
        return image_.between(part, frame_.first - beyond, frame_.last() + beyond).area();
    }
    /// What of a strip is on the lamp's side of its end without a dark cap, or of its begin: it is
    /// convex.
    ClippedPixel cut_convex(const ClippedPixel& strip, double axis) const {
        return ends_.begins_with_cap() ? cutter_.cut(strip, axis, ends_.end, Side::before)
                                       : cutter_.cut(strip, axis, ends_.begin, Side::past);
    }
    /// Of what is cut so, the area that is on the lamp's side of its other end too.
    double seen_of(const ClippedPixel& part, double axis) const {
        return ends_.begins_with_cap() ? cutter_.area(part, axis, ends_.begin, Side::past)
                                       : cutter_.area(part, axis, ends_.end, Side::before);
    }
    /// Of the same, the area behind the neighbour that rays meet before the lamp.
    double hidden_of(const ClippedPixel& part, double axis) const {
        const bool from_begin = ends_.begins_with_cap();
        const bool is_lesser = from_begin == (ends_.begin.shear > 0);
        const double before = is_lesser ? axis - frame_.pitch : axis + frame_.pitch;
        const double room = frame_.pitch / 2;
        if (before < frame_.first - room || before > frame_.last() + room) return 0;
        const ClippedPixel both = image_.between(part, before - half_, before + half_);
        const ClippedPixel hidden =
            from_begin ? cutter_.cut(both, before, rim(ends_.begin, -1), Side::past)
                       : cutter_.cut(both, before, rim(ends_.end, 1), Side::before);
        return seen_of(hidden, axis);
    }
    /// The half of an end's rim that bulges to greater u, or to lesser.
    static LampEnd rim(const LampEnd& end, double sign) {
        return {end.at, end.shear, sign * std::abs(end.bulge)};
    }
    /// `use`(axis, what of the pixel lies on the strip), of lamps in it.
    template <class Use>
    void for_each_lamp(const Use& use) const {
        double low = frame_.last(), high = frame_.first;
        for (const Vec2& corner : pixel_) {
            const double v = image_.v(corner);
            low = std::isfinite(v) ? std::min(low, v) : frame_.first;
            high = std::isfinite(v) ? std::max(high, v) : frame_.last();
        }
        const double first = std::ceil((low - half_ - frame_.first) / frame_.pitch);
        const double last = std::floor((high + half_ - frame_.first) / frame_.pitch);
        for (double i = std::max(first, 0.0); i <= std::min(last, frame_.lamps - 1.0); ++i) {
            const double axis = frame_.axis(static_cast<int>(i));
            use(axis, image_.between(pixel_, axis - half_, axis + half_));
        }
    }

    const CPlaneFrame& frame_;
    double half_;
    const LampEnds& ends_;
    PixelImage image_;
    TubeEndClipper cutter_;
    ClippedPixel pixel_;
};

} // namespace

double end_coverage(const CPlaneFrame& frame, double strip_width, bool resolved,
                    const LampEnds& ends, const Vec2& centre, const Footprint& footprint) {
    if (frame.lamps == 0) return 0;
    const RowInPixel row(frame, strip_width, ends, centre, footprint);
    if (!(strip_width < frame.pitch)) return row.of_overlapping_strips();
    return resolved ? row.of_strips_apart() : row.of_grey_band();
}

} // namespace keiko
