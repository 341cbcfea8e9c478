#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/compare/alignment/placed_model.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace KEIKO_API keiko {

/// The point of a body's material that is nearest to a given point.
struct ClosestSurfacePoint {
    std::uint32_t face = 0;  ///< into the faces of the PlacedModel
    Vec3 position{0};        ///< world, mm
    Vec3 normal{0};          ///< unit, outward as the file has it; 0 where there is none
    double distance = 0;     ///< mm
    double nearest = 0;      ///< mm: nothing of the material is nearer than this, by proof
    bool on_border = false;  ///< the point lies beyond the border of a face
    std::uint32_t piece = 0; ///< of ClosestPointQuery; of no meaning on a border
    Vec2 uv{0};              ///< of the piece, [0, 1]^2; of no meaning on a border

    /// Whether the distance is proved to within `tolerance` mm.
    bool certain(double tolerance) const { return distance - nearest <= tolerance; }
    /// The distance of the place that it was sought for, mm: negative on the inside of the body.
    double signed_distance(const Vec3& place) const {
        return (place - position).dot(normal) < 0 ? -distance : distance;
    }
    /// Whether that place lies aside rather than above or below: more than 45 degrees off the
    /// normal. Never for one that is nearer than `noise` mm.
    bool is_beside(const Vec3& place, double noise) const {
        if (distance <= noise) return false;
        constexpr double steep = 0.7; // of the way there across the normal
        return (place - position).cross(normal).length() > steep * distance;
    }
};

/// A point of a body's material.
struct SurfacePoint {
    std::uint32_t piece = 0; ///< of ClosestPointQuery
    Vec2 uv{0};              ///< of the piece, [0, 1]^2
    std::uint32_t face = 0;  ///< into the faces of the PlacedModel
    Vec3 position{0};        ///< world, mm
    Vec3 normal{0};          ///< as ClosestSurfacePoint::normal
    double stretch = 0;      ///< mm2 of surface in a unit of u times a unit of v
};

/// A point of a border of a body's faces.
struct BorderPoint {
    Vec3 position{0};       ///< world, mm
    std::uint32_t face = 0; ///< into the faces of the PlacedModel
    double claimed = 0;     ///< mm, tolerance that the file claims for the edge
};

/// Whether a face, into the faces of the PlacedModel, counts; an empty one: all do.
using FaceFilter = std::function<bool(std::uint32_t face)>;

/// Finds the nearest points of the exact trimmed surface of a body. Pieces of surface are tried by
/// the distance of their boxes. On each, Newton's iteration finds a minimum. Where bounds of the
/// piece do not prove it to be the only one, the piece is halved, a few times: distances up to
/// about the radius of curvature are proved. A distance is the smallest to 1e-9 mm. What is nearer
/// but trimmed away hands on to the borders, whose distance is found from polylines, not proved:
/// `nearest` is then that of the untrimmed surface. Immutable; any thread may query.
class ClosestPointQuery {
public:
    /// Keeps its own copy of the body. Throws Error for a body without faces, Cancelled.
    explicit ClosestPointQuery(PlacedModel body, const Job& job = {});
    ~ClosestPointQuery();
    /// Takes over the trees of another.
    ClosestPointQuery(ClosestPointQuery&&) noexcept;

    /// Nearest point of the faces that count; nullopt where they are `reach` mm away or farther.
    std::optional<ClosestSurfacePoint> foot(const Vec3& p, double reach,
                                            const FaceFilter& counts = {}) const;
    /// Nearest point of the whole body, likewise. The search begins at the nearest point of a place
    /// near p, which makes it faster.
    std::optional<ClosestSurfacePoint> foot_from(const ClosestSurfacePoint& start, const Vec3& p,
                                                 double reach) const;
    /// Nearest point of the whole body, at any distance.
    ClosestSurfacePoint foot(const Vec3& p) const;
    /// The distance of a point to the borders of all faces, mm; infinity where it is `reach` or
    /// more, and where no face has a border.
    double border_distance(const Vec3& p,
                           double reach = std::numeric_limits<double>::infinity()) const;
    /// The nearest point of the borders of the faces that count, where it is within `reach` mm.
    std::optional<Vec3> border_foot(const Vec3& p, double reach,
                                    const FaceFilter& counts = {}) const;
    /// Points of all borders: where they turn, and three between each two of those.
    std::vector<BorderPoint> border_points() const;
    /// The body that is queried.
    const PlacedModel& body() const;

    /// The pieces that the faces are divided into: bent little, and none without material nearby.
    std::size_t piece_count() const;
    /// About how long a piece is along u and along v, mm.
    Vec2 piece_size(std::size_t piece) const;
    /// Point of a piece; nullopt where the piece is trimmed away.
    std::optional<SurfacePoint> point(std::size_t piece, const Vec2& uv) const;

private:
    struct Pieces;
    class Search;
    std::unique_ptr<Pieces> pieces_;
};

} // namespace keiko
