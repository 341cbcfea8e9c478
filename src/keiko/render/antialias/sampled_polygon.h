#pragma once

#include "keiko/base/memory.h"
#include "keiko/render/antialias/subpixels.h"
#include "keiko/render/reflection/sample_batch.h"

#include <span>
#include <vector>

namespace keiko {

/// Unit direction in the picture along which the reflection in a convex part of it is bent most; 0
/// if the normal does not turn. Along it the normal turns least uniformly, by the normal and its
/// slopes at the part's corners and in its middle. All samples have hits with second derivatives.
/// `corners`: px.
Vec2 max_curvature_direction(std::span<const Vec2> corners,
                             std::span<const PixelSample* const> seen, const PixelSample& amid);

/// A convex part of the picture with the samples at its corners.
struct SampledPolygon {
    static constexpr std::size_t most_corners = 6; ///< a cell's four and two crossings

    InplaceVector<Vec2, most_corners> corners;            ///< px, of either sense
    InplaceVector<const PixelSample*, most_corners> seen; ///< one a corner, in order

    /// The polygon as the area of one camera ray.
    PixelArea whole() const { return polygon_part(corners); }
    /// True if a sample in the middle shows the same smooth thing as one of the corners.
    bool shows(const PixelSample& amid) const;
    /// Nonlinearity of the polygon: up to 1 the place in its middle represents all of it with a
    /// straight image on the lamps' plane. The image may be bent, or reach the plane's horizon. The
    /// surface may be visible at angles so different that the reflectance is not uniform, or show
    /// in the middle what no corner does. n strips divide it by n^2.
    double unevenness(const PixelSample& amid) const;
    /// Strips of one width along which the image is bent least. There are as many as make each
    /// nearly linear, and at least two. They are not divided beyond a width of `narrowest`, px.
    /// Empty if no surface is visible, or one that does not turn.
    std::vector<PixelArea> strips(const PixelSample& amid, double uneven, double narrowest) const;

private:
    /// True if it is brighter or darker than all corners: its sample shows something that theirs do
    /// not.
    bool is_outshone_by(const PixelSample& amid) const;
    // Shares of the limits for a whole pixel: the difference of cosines and the turn of normals,
    // the bend of the image on the lamps' plane, and the deviation of luminances from linear ones.
    double turn(const PixelSample& amid) const;
    double bend(const PixelSample& amid) const;
    double glare(const PixelSample& amid) const;
};

} // namespace keiko
