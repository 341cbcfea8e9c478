#pragma once

#include "keiko/base/memory.h"
#include "keiko/render/antialias/subpixels.h"
#include "keiko/render/reflection/sample_batch.h"

#include <span>
#include <vector>

namespace keiko {

/// The direction in the picture, unit, along which the mirror image of a convex part of it is bent
/// most: in which the normal turns most unevenly, as it and its slopes at the part's corners and
/// amid it tell; 0 where it does not turn. All samples have hits with second derivatives.
/// `corners`: px.
Vec2 max_curvature_direction(std::span<const Vec2> corners,
                             std::span<const PixelSample* const> seen, const PixelSample& amid);

/// A convex part of the picture with what is seen at its corners.
struct SampledPolygon {
    static constexpr std::size_t most_corners = 6;

    InplaceVector<Vec2, most_corners> corners; ///< px, of either sense
    InplaceVector<const PixelSample*, most_corners> seen;

    PixelArea whole() const { return polygon_part(corners); }
    /// Whether a sample amid it shows the same smooth thing as one of its corners.
    bool shows(const PixelSample& amid) const;
    /// How far the place amid it is from telling how all of it looks with a straight image on the
    /// lamps' plane, which may be bent, or reach the plane's horizon, or be seen at angles so
    /// different that the reflectance is not even, or show amid it what no corner does: up to 1 it
    /// tells; n strips take away n^2.
    double unevenness(const PixelSample& amid) const;
    /// Strips of one width along which the image is bent least, as many as make each even, but no
    /// more than it takes for them to be as narrow as `narrowest`, px; at least two. Nothing where
    /// no surface is seen, or one that does not turn.
    std::vector<PixelArea> strips(const PixelSample& amid, double uneven, double narrowest) const;

private:
    /// Whether it is brighter or darker than all corners: it has seen what they have not.
    bool is_outshone_by(const PixelSample& amid) const;
    // Of what may be in a whole pixel: how far cosines differ and normals turn, how far the image
    // on the lamps' plane is bent, how far luminances are from linear.
    double turn(const PixelSample& amid) const;
    double bend(const PixelSample& amid) const;
    double glare(const PixelSample& amid) const;
};

} // namespace keiko
