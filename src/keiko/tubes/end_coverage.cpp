#include "keiko/tubes/end_coverage.h"

#include "keiko/tubes/end_cutter.h"

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
        for_each_lamp([&](double axis, const PixelCut& strip) {
            const bool end_first = ends_.begins_with_cap();
            const PixelCut part = end_first ? cutter_.cut(strip, axis, ends_.end, Side::before)
                                            : cutter_.cut(strip, axis, ends_.begin, Side::past);
            sum += end_first ? cutter_.area(part, axis, ends_.begin, Side::past)
                             : cutter_.area(part, axis, ends_.end, Side::before);
        });
        return sum;
    }
    /// Of strips that overlap: to each end they go as far as the one of them that does so most,
    /// and dark caps hide what is behind them.
    double of_overlapping_strips() const {
        double sum = -band(pixel_, half_);
        for_each_lamp([&](double axis, const PixelCut& strip) {
            const Range begin = seen_of(axis, ends_.begin.shear > 0);
            const Range end = seen_of(axis, !(ends_.end.shear > 0));
            sum += cutter_.area(image_.between(strip, begin.low, begin.high), axis, ends_.begin,
                                Side::past);
            sum += cutter_.area(image_.between(strip, end.low, end.high), axis, ends_.end,
                                Side::before);
            if (ends_.begins_with_cap()) sum -= cap(strip, axis, ends_.begin, begin);
            if (ends_.ends_with_cap()) sum -= cap(strip, axis, ends_.end, end);
        });
        return std::max(sum, 0.0);
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
            const PixelCut part = pixel_.where(image_.past({1, 0}, {at(ends_.begin), 0}, 0))
                                      .where(image_.past({-1, 0}, {at(ends_.end), 0}, 0));
            sum += band(part, frame_.pitch / 2);
        }
        return std::min(2 * half_ / frame_.pitch, 1.0) * sum / count;
    }

private:
    struct Range {
        double low, high; ///< of v
    };

    double band(const PixelCut& part, double beyond) const {
        return image_.between(part, frame_.first - beyond, frame_.last() + beyond).area();
    }
    /// What of a lamp's strip is seen where of strips that overlap the one is seen whose axis is of
    /// greatest v, or else of least.
    Range seen_of(double axis, bool greatest) const {
        Range seen{axis - half_, axis + half_};
        const double hidden = 2 * half_ - frame_.pitch;
        if (!greatest && axis > frame_.first + frame_.pitch / 2) seen.low += hidden;
        if (greatest && axis < frame_.last() - frame_.pitch / 2) seen.high -= hidden;
        return seen;
    }
    /// Of a cap, what lies beside the range in which no tube is seen past it.
    double cap(const PixelCut& strip, double axis, const LampEnd& end, const Range& alone) const {
        const bool greater = alone.low == axis - half_;
        const PixelCut part = greater ? image_.between(strip, alone.high, axis + half_)
                                      : image_.between(strip, axis - half_, alone.low);
        const LampEnd far{end.at, end.shear, std::abs(end.bulge)};
        const LampEnd near{end.at, end.shear, -std::abs(end.bulge)};
        return cutter_.cut(cutter_.cut(part, axis, far, Side::before), axis, near, Side::past)
            .area();
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
    EndCutter cutter_;
    PixelCut pixel_;
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
