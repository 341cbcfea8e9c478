#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/flaws/face_surface.h"
#include "keiko/inspect/openings/bodies.h"
#include "keiko/inspect/seams/model_borders.h"

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace keiko {

/// A border curve of a placed face.
struct PanelBorder {
    BoundaryInterval on;    ///< the whole curve
    SurfaceCurve curve;     ///< in world coordinates, mm
    CurvePolyline polyline; ///< near the curve, for searches
    std::size_t body = 0;   ///< into Bodies

    /// The face that it bounds.
    PlacedFace face() const { return {on.instance, on.face}; }
};

/// A place of a border, and the face beyond it.
struct BorderNeighbour {
    PlacedFace face;     ///< the face beyond
    BoundaryFrame frame; ///< of that face's own border, nearest to the place
    Vec2 parameters{0};  ///< there, of that face
};

/// The border curves of all placed faces, the faces beyond them, and the bodies that these form.
/// Keeps references to the borders.
class PanelBorders {
public:
    /// Borders of a model with these seams.
    PanelBorders(const ModelBorders& borders, std::span<const Seam> seams, const Job& job = {});

    /// The model itself.
    const SurfaceModel& model() const { return borders_.model; }
    /// All borders, instances outer, faces and loops in file order.
    const std::vector<PanelBorder>& all() const { return all_; }
    /// Number of bodies.
    std::size_t body_count() const { return bodies_.count(); }
    /// The borders of a placed face, indices into all().
    std::span<const std::uint32_t> of(const PlacedFace& face) const;
    /// A placed face over all its knot spans.
    const FaceSurface& surface(const PlacedFace& face) const;
    /// mm, by the borders of a placed face.
    double size(const PlacedFace& face) const;
    /// Borders of other bodies, ascending, that may face a place of one that runs along a unit
    /// vector: in a box, at most `radius` mm away, in about the same direction, about square to it.
    std::vector<std::uint32_t> others_facing(std::size_t body, const Vec3& place, const Vec3& along,
                                             double radius, const Box3& box) const;

    /// The face that a seam joins at parameter `t` of a border; nullopt at a free edge, and where
    /// that face has no frame.
    std::optional<BorderNeighbour> beyond(const PanelBorder& border, double t) const;
    /// True if no seam covers parameter `t` of a border.
    bool is_free(const PanelBorder& border, double t) const;

private:
    using Key = std::pair<std::uint32_t, std::uint32_t>; ///< instance and face
    /// A side of a seam and the other one, which runs in the same direction.
    struct Joined {
        BoundaryInterval own, other;
    };

    /// Consecutive chords of a border's polyline.
    struct Chords {
        std::uint32_t border = 0; ///< into all_
        std::size_t begin = 0;    ///< index of the first point
        std::size_t end = 0;      ///< index of the last point
    };

    bool may_face(const Chords& chords, const Vec3& place, const Vec3& along, double radius) const;
    const Joined* joined_at(const PanelBorder& border, double t) const;
    void list_borders();
    void add_seam(const BoundaryInterval& own, const BoundaryInterval& other);
    std::vector<Box3> list_chords();

    const ModelBorders& borders_;
    Bodies bodies_;
    std::vector<PanelBorder> all_;
    std::map<Key, std::vector<std::uint32_t>> by_face_; ///< into all_
    std::map<Key, std::vector<Joined>> joined_;
    std::map<Key, std::size_t> surface_of_; ///< into surfaces_
    std::vector<std::optional<FaceSurface>> surfaces_;
    std::vector<Chords> chords_;
    BoxTree tree_; ///< of chords_
};

} // namespace keiko
