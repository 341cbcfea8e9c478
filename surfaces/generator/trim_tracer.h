#pragma once

#include "skin.h"

namespace keiko::fixtures {

/// A point of a trim curve: its place in mm and its parameters on every skin it trims.
struct TrimPoint {
    gp_XYZ position;
    std::vector<gp_XY> uv;
};

/// The trim curve at `tau`, found by iteration from a point close by on the same curve.
using TrimPath = std::function<TrimPoint(double tau, const TrimPoint& near)>;

/// The part of a trim curve between two crossings with patch borders, hence inside one cell of
/// every skin. All curves are Bezier curves over the same parameter in [0, 1].
struct TrimPiece {
    std::vector<gp_XYZ> poles;
    /// Per skin: the curve in the skin's parameters.
    std::vector<std::vector<gp_XY>> uv_poles;
    /// Per skin: the cell the piece runs in.
    std::vector<Cell> cells;
    /// Largest distance in mm between the curve and its images on the skins, as sampled.
    double deviation = 0.0;
};

using TrimCurve = std::vector<TrimPiece>;

/// The place in mm at t in [0, 1] of a piece.
gp_XYZ point_on(const TrimPiece& piece, double t);

/// The curve for tau from `first` to `last`, started from a point near tau = `first`, cut wherever
/// it crosses a patch border of one of the skins.
TrimCurve trace(const TrimPath& path, double first, double last, const TrimPoint& start,
                const std::vector<const Skin*>& skins);

/// The mirror image in the plane y = 0. It runs the other way, so what was left of the curve in
/// uv stays left. `mirror_uv[k]` is the mirror map in the parameters of skin k.
TrimCurve mirrored(const TrimCurve& curve,
                   const std::vector<std::function<gp_XY(gp_XY)>>& mirror_uv,
                   const std::vector<const Skin*>& skins);

/// The closed curve made of its right half, from y = 0 to y = 0, and the half's mirror image.
TrimCurve with_mirror_image(TrimCurve right,
                            const std::vector<std::function<gp_XY(gp_XY)>>& mirror_uv,
                            const std::vector<const Skin*>& skins);

/// Is uv, a point clear of the curve, inside the closed curve on skin `side`?
bool encloses(const TrimCurve& curve, std::size_t side, gp_XY uv);

} // namespace keiko::fixtures
