#pragma once

#include <vector>

#include "keiko/patch/surface_model.h"

namespace keiko {

/// Which side of a face's trim loops a place of its parameter plane is on.
enum class TrimSide { inside, outside, mixed };

/// The material of one trimmed face, for point and box questions: p-curves split into
/// bi-monotone pieces, answered by the even-odd rule along a line of constant v, decided at each
/// piece by Bezier clipping in one dimension, never by a polyline.
class TrimRegion {
public:
    TrimRegion(const SurfaceModel& model, const Face& face);

    /// Whether the point of the parameter plane is material. Points on a curve itself may go
    /// either way.
    bool contains(const Vec2& face_parameters) const;
    /// inside or outside when no trim curve can touch the box.
    TrimSide classify(const Box2& box) const;
    /// The nearest point of any trim curve within `radius` of the point (both measured after
    /// scaling u and v by `scale`: lengths of du and dv in mm), or nothing.
    struct NearCurve {
        double distance = 0;       ///< scaled, i.e. about mm
        std::uint32_t curve = 0;   ///< into SurfaceModel::trim_curves
        double t = 0;              ///< on that curve
    };
    std::optional<NearCurve> nearest_curve(const Vec2& face_parameters, const Vec2& scale,
                                           double radius) const;
    /// True for a face without loops.
    bool untrimmed() const;

private:
    struct Piece;
    std::vector<Piece> pieces_;
};

} // namespace keiko
