#pragma once

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/inspect/flaws/face_surface.h"
#include "keiko/inspect/flaws/surface_poles.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace keiko {

/// A plane that touches a surface, as frame for its surroundings. Unit vectors, world, mm.
struct TangentFrame {
    Vec3 origin{0}; ///< where the plane touches, world, mm
    Vec3 x{0};      ///< unit tangent along the direction that the frame was made for
    Vec3 y{0};      ///< unit tangent, z x x
    Vec3 z{0};      ///< unit normal of the plane

    /// Position in the frame, mm.
    Vec3 local(const Vec3& position) const {
        const Vec3 from = position - origin;
        return {from.dot(x), from.dot(y), from.dot(z)};
    }
};

/// The placed faces of a model and their smooth connections. These lead over seams that are no
/// creases and whose gap, angle and, if the preset limits it, curvature pass.
class FaceAdjacency {
public:
    /// `spacing`, mm: distance between the lookups of a seam. Keeps a reference to the model.
    FaceAdjacency(const SurfaceModel& model, std::span<const MeasuredSeam> seams,
                  std::span<const Seam> pieces, double spacing);

    /// Number of placed faces, instances outer, as in measure_faces.
    std::size_t size() const { return faces_.size(); }
    /// A placed face by its number, from 0 to size() - 1.
    const FaceSurface& face(std::size_t index) const { return faces_[index]; }
    /// Number of the connected surface of a face; faces share it if one can be reached from the
    /// other.
    std::size_t sheet(std::size_t face) const { return sheets_[face]; }

    /// The surface at a place with its derivatives up to `order`, world, mm, regardless of trims;
    /// nullopt more than a quarter of a span beyond the sides of the face.
    std::optional<SurfaceDerivatives> evaluate(const SheetPoint& at, int order) const {
        return faces_[at.face].evaluate_beyond(at.place, order);
    }
    /// The plane at a place with x along `direction`, z outwards; nullopt where the surface has no
    /// normal, as at the tip of a cone.
    std::optional<TangentFrame> frame(const SheetPoint& at, const Vec3& direction) const;
    /// The plane at a place whose derivatives are known.
    std::optional<TangentFrame> frame(const SheetPoint& at, const SurfaceDerivatives& there,
                                      const Vec3& direction) const;
    /// Second fundamental form in the plane at a place, whose derivatives to order 2 are known, by
    /// the plane's normal. At a smooth pole it is taken `aside` mm further along x.
    std::optional<SecondForm> bend(const SheetPoint& at, const SurfaceDerivatives& there,
                                   const TangentFrame& frame, double aside) const;
    /// The place over (or under) the point (x, y) of a plane that a straight trace from `from`
    /// reaches, over smooth seams and poles; nullopt if material ends before.
    std::optional<SheetPoint> moved(const TangentFrame& over, const SheetPoint& from,
                                    const Vec2& to) const;
    /// The place reached from the origin of the plane, where the derivatives to order 2 are known.
    std::optional<SheetPoint> moved(const TangentFrame& over, const SheetPoint& from,
                                    const SurfaceDerivatives& there, const Vec2& to) const;

private:
    /// A point of a face's border where another face continues it.
    struct Crossing {
        Vec3 position{0}; ///< world, mm
        SheetPoint beyond;
    };
    using Key = std::pair<std::uint32_t, std::uint32_t>; ///< instance and face

    void add_crossings(const BoundaryCurves& curves, const Seam& piece, double spacing);
    /// `goes_on`: the crossing follows the last one of the face along the same seam.
    void add_crossing(std::size_t face, const Crossing& crossing, bool goes_on);
    /// True if a seam of the face may come within `reach` mm of a position.
    bool has_crossing_near(std::size_t face, const Vec3& position, double reach) const;
    std::optional<Vec2> solved(const TangentFrame& over, const SheetPoint& from,
                               const Vec2& to) const;
    std::optional<SheetPoint> moved(const TangentFrame& over, const SheetPoint& from,
                                    const Vec2& to, std::size_t barred, int crossings_left) const;
    /// The last place on the face of `from` on the trace to `to`. `there` is the trace's end on
    /// that face beyond its trims, if known.
    SheetPoint border(const TangentFrame& over, const SheetPoint& from, const Vec2& to,
                      const std::optional<Vec2>& there) const;
    /// The place on a face other than `barred` that continues a place on a border.
    std::optional<SheetPoint> beyond(const TangentFrame& over, const SheetPoint& border,
                                     std::size_t barred) const;

    /// The smooth pole of a place's face at a position; nullptr if there is none.
    const SurfacePole* pole_at(std::size_t face, const Vec3& position) const;
    /// The end of a trace that passes a pole of its face nearer than half its length.
    std::optional<SheetPoint> across_pole(const TangentFrame& over, const SheetPoint& from,
                                          const Vec2& to, int crossings_left) const;

    std::vector<FaceSurface> faces_;
    std::map<Key, std::size_t> index_;             ///< into faces_
    std::vector<std::vector<Crossing>> crossings_; ///< a face
    std::vector<double> crossing_steps_; ///< mm, a face: the largest distance between neighbours
    std::vector<std::size_t> sheets_;
    SurfacePoles poles_;
};

} // namespace keiko
