#pragma once

#include "keiko/inspect/basics/placed_face.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace keiko {

/// The patches of a placed face as one sheet. Its coordinates (s, t) follow the knot spans of the
/// two parameters and run through each at a constant rate, such that a unit is about one mm.
class FaceSheet {
public:
    /// Control points nearer than `coincidence` mm are one: sides that are points, and the two ends
    /// of a closed surface.
    FaceSheet(const SurfaceModel& model, const PlacedFace& face, double coincidence);

    /// A part of a patch.
    struct Part {
        std::uint32_t patch = 0; ///< into SurfaceModel::patches
        BezierPatchView view;    ///< of the whole patch, mm about `origin`
        Box2 uv;                 ///< of the patch's parameters
        Vec2 extent{0};          ///< of these, in s and t
    };

    /// The box of all patches, from (0, 0).
    const Box2& domain() const { return domain_; }
    /// Size of the domain where the sheet closes in s or t, else 0.
    const Vec2& period() const { return period_; }
    /// World, mm.
    const Vec3& origin() const { return origin_; }
    /// Sides of patches that are points, mm about `origin`.
    const std::vector<Vec3>& tips() const { return tips_; }

    /// The parts over a box of (s, t), which may extend beyond the domain where that is periodic.
    /// nullopt if a part of the box has no patch: trims have removed it.
    std::optional<std::vector<Part>> parts(const Box2& box) const;
    /// The parts over a box inside the domain, without those that trims have removed.
    std::vector<Part> present_parts(const Box2& box) const;
    /// The part at a place; nullopt if there is no patch. The box is the place.
    std::optional<Part> part_at(const Vec2& place) const;
    /// Coordinate at which a box is best cut across `axis`: a line between spans if it has one
    /// inside, else the middle.
    double cut(const Box2& box, unsigned axis) const;

private:
    struct Net {
        std::uint32_t patch;
        int degree_u, degree_v;
        std::vector<Vec4> points; ///< about the origin
    };
    /// Lines between spans, in the face's parameter and in s or t.
    struct Lines {
        std::vector<double> knots, at;
        std::size_t spans() const { return at.size() - 1; }
    };

    void place_nets(const SurfaceModel& model, const PlacedFace& face);
    void list_lines(const SurfaceModel& model, const Face& face);
    void find_tips(double coincidence);
    bool is_closed(unsigned axis, double coincidence) const;
    std::size_t span_of(unsigned axis, double at) const;
    double within(unsigned axis, double at) const;
    const Net* net(std::size_t i, std::size_t j) const;
    bool is_wide(const Box2& box) const;
    bool add_column(const Box2& box, double s, double s_end, std::vector<Part>& parts) const;
    Part part(const Net& net, std::size_t i, std::size_t j, const Box2& box) const;

    Vec3 origin_{0};
    std::vector<Net> nets_;
    Lines lines_[2];
    std::vector<std::size_t> grid_; ///< one more than the index of the net in it; 0: none
    Box2 domain_;
    Vec2 period_{0};
    std::vector<Vec3> tips_;
};

} // namespace keiko
