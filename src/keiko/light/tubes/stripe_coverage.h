#pragma once

#include "keiko/light/tubes/plane_image.h"

namespace keiko {

/// Image of a pixel's square along one axis of the C-plane if the map from picture to plane is
/// linear across the pixel. It is the convolution of two boxes of widths |du/dx| and |du/dy|, a
/// trapezoid of unit area. Both widths 0: a point.
template <class Real>
class PixelFilterT {
public:
    /// Filter of two widths in mm, of either sign.
    PixelFilterT(const Real& by_x, const Real& by_y)
        : wide_(max(abs(by_x), abs(by_y))),
          narrow_(min(abs(by_x), abs(by_y))),
          reach_((wide_ + narrow_) * 0.5),
          per_wide_(1 / wide_),
          per_both_(per_wide_ / (narrow_ + narrow_)) {}

    /// Share of the filter that lies in [begin, end], positions relative to its centre; 0 to 1.
    Real share(const Real& begin, const Real& end) const {
        return select(begin < end, below(end) - below(begin), Real(0));
    }
    /// Largest distance of the filter from its centre, mm.
    Real reach() const { return reach_; }
    /// Wider of the two boxes, mm.
    Real width() const { return wide_; }

private:
    /// Integral of the filter from its centre to x.
    Real below(const Real& x) const {
        const Real away = abs(x), rest = reach_ - away;
        const Real flat = away * per_wide_, slope = 0.5 - rest * rest * per_both_;
        const Real inside = select(away <= reach_ - narrow_, flat, slope);
        return copysign(select(away >= reach_, Real(0.5), inside), x);
    }

    Real wide_, narrow_, reach_, per_wide_, per_both_;
};
/// For one pixel.
using PixelFilter = PixelFilterT<double>;

/// Share of a filter centred at v = `center` mm that falls on the row's strips of `width` mm, which
/// is less than the pitch; 0 to 1. Only `wanted` lanes are right.
template <class Real>
Real strips_coverage(const CPlaneFrame& frame, const MaskOf<Real>& wanted, const Real& width,
                     const Real& center, const PixelFilterT<Real>& filter) {
    const Real half = width * 0.5, reach = filter.reach() + half, away = center - frame.first;
    const Real begin = max(ceil((away - reach) / frame.pitch), Real(0));
    const Real end = min(floor((away + reach) / frame.pitch), Real(frame.lamps - 1.0));
    Real sum = 0;
    for (Real lamp = begin;; lamp += 1) {
        const MaskOf<Real> more = wanted && lamp <= end;
        if (!any_of(more)) return sum;
        const Real at = lamp * frame.pitch + frame.first - center;
        sum += select(more, filter.share(at - half, at + half), Real(0));
    }
}

/// Share of a filter on the whole row as one strip, which goes on `beyond` the outer axes.
template <class Real>
Real band_coverage(const CPlaneFrame& frame, const Real& beyond, const Real& center,
                   const PixelFilterT<Real>& filter) {
    return filter.share(frame.first - beyond - center, frame.last() + beyond - center);
}

/// Share of a filter that falls on the row's strips, exact for any filter
/// (docs/theory.md#stripes-without-noise). Strips that overlap count as one. Only `wanted` lanes
/// are right.
template <class Real>
Real comb_coverage(const CPlaneFrame& frame, const MaskOf<Real>& wanted, const Real& width,
                   const Real& center, const PixelFilterT<Real>& filter) {
    if (frame.lamps == 0) return Real(0);
    const MaskOf<Real> apart = width < Real(frame.pitch);
    const Real strips = strips_coverage(frame, wanted && apart, width, center, filter);
    if (!any_of(wanted && !apart)) return strips;
    return select(apart, strips, band_coverage(frame, Real(width * 0.5), center, filter));
}

/// Share of a filter for stripes too fine to be distinguished: the row as a grey band.
template <class Real>
Real mean_coverage(const CPlaneFrame& frame, const Real& width, const Real& center,
                   const PixelFilterT<Real>& filter) {
    if (frame.lamps == 0) return Real(0);
    const Real beyond = max(Real(frame.pitch), width) * 0.5;
    return min(width / frame.pitch, Real(1)) * band_coverage(frame, beyond, center, filter);
}

/// True for stripes that a pixel can show: not more than 4 pitches in it. Others are replaced by
/// their mean.
template <class Real>
MaskOf<Real> is_resolved(const CPlaneFrame& frame, const PixelFilterT<Real>& filter) {
    return filter.width() <= Real(4 * frame.pitch);
}

/// Number of the lamp whose axis is nearest to v.
template <class Real>
Real nearest_lamp(const CPlaneFrame& frame, const Real& v) {
    return clamped(floor((v - frame.first) / frame.pitch + 0.5), 0.0, frame.lamps - 1.0);
}

/// True for images between lamps or beside them, regardless of their ends. Strips widen for rays
/// nearer to the plane's horizon than the centre's; none exceeds `width` by more than that.
template <class Real>
MaskOf<Real> is_in_gap(const CPlaneFrame& frame, const CPlaneHitT<Real>& hit,
                       const FootprintT<Real>& image, const Real& width) {
    const Real least = image.least_descent(), reach = half_sum(image.dx.y, image.dy.y);
    const Real axis = nearest_lamp(frame, hit.v) * frame.pitch + frame.first;
    return least > Real(0) && least * abs(hit.v - axis) > width * 0.5 + reach &&
           reach < 0.5 * least * frame.pitch;
}

/// Coverage of a pixel by a row, in closed form over strips of the lamps' apparent
/// width.
template <class Real>
struct StripeCoverage {
    Real coverage;         ///< 0 to 1; 0 for pixels `at_ends`
    MaskOf<Real> at_ends;  ///< may hold an end of lamps: end_coverage() tells these
    MaskOf<Real> resolved; ///< false: the coverage is the mean

    /// Coverage of `wanted` pixels by their `image` around a hit.
    StripeCoverage(const CPlaneFrame& frame, MirrorModel look, const MaskOf<Real>& wanted,
                   const CPlaneHitT<Real>& hit, const FootprintT<Real>& image) {
        const bool round = look == MirrorModel::tube;
        const PixelFilterT<Real> across(image.dx.y, image.dy.y);
        resolved = is_resolved(frame, across);
        const Real room = round ? image.widened(end_room(frame, hit.direction)) : Real(0);
        const Real reach = image.reach_along(), low = hit.u - reach, high = hit.u + reach;
        const MaskOf<Real> reached = wanted && !(high <= -room || low >= frame.length + room);
        const MaskOf<Real> amid = reached && low >= room && high <= frame.length - room;
        const Real width = round ? apparent_diameter(frame, hit.direction) : Real(frame.diameter);
        coverage = Real(0);
        if (any_of(amid))
            coverage = select(amid, of_strips(frame, amid, width, hit.v, across), Real(0));
        at_ends = reached && !amid;
        if (any_of(at_ends)) at_ends = at_ends && !is_in_gap(frame, hit, image, width);
    }

private:
    Real of_strips(const CPlaneFrame& frame, const MaskOf<Real>& wanted, const Real& width,
                   const Real& center, const PixelFilterT<Real>& filter) const {
        const Real comb = comb_coverage<Real>(frame, wanted && resolved, width, center, filter);
        if (!any_of(wanted && !resolved)) return comb;
        return select(resolved, comb, mean_coverage(frame, width, center, filter));
    }
};

} // namespace keiko
