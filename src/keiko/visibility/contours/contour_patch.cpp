#include "keiko/visibility/contours/contour_patch.h"

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/visibility/contours/contour_cell.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Traces the silhouettes of a patch from one point, cell by cell.
class ContourTrace {
public:
    ContourTrace(const OccluderPatch& patch, double side, const TrimRegion* region,
                 const Vec3& point, double allowed, ContourArcs& arcs)
        : patch_(patch),
          side_(side),
          region_(region),
          eye_(point - patch.center),
          allowed_(allowed),
          arcs_(arcs) {}

    void add(const ContourCell& cell) {
        if (!cell.is_sound()) arcs_.are_complete = false;
        for (const ParameterInterval& part : cell.parts())
            for (const ParameterInterval& kept : in_material(cell, part)) {
                constexpr int most_halvings = 10;
                add(cell, place(cell, kept.begin), place(cell, kept.end), most_halvings);
            }
    }

private:
    struct Place {
        double along;
        Vec2 uv;
        Vec3 way, normal;
    };

    Place place(const ContourCell& cell, double along) const {
        const Vec2 uv = cell.zero(along);
        const Vec4 at = value_of(patch_.points, uv);
        return {along, uv, (spatial(at) / at.w - eye_).normalized(),
                spatial(value_of(patch_.planes, uv)) * side_};
    }

    bool is_material(const ContourCell& cell, double along) const {
        return region_->contains(patch_.face_parameters(cell.zero(along)));
    }

    /// Parts of a silhouette that trim curves leave.
    std::vector<ParameterInterval> in_material(const ContourCell& cell,
                                               const ParameterInterval& part) const {
        constexpr int steps = 24, halvings = 40;
        if (!region_) return {part};
        std::vector<ParameterInterval> kept;
        double before = part.begin, from = part.begin;
        bool was = is_material(cell, before);
        for (int i = 1; i <= steps; ++i) {
            const double at = part.begin + part.length() * i / steps;
            const bool is = is_material(cell, at);
            double low = before, high = at;
            for (int k = 0; is != was && k < halvings; ++k) {
                const double middle = (low + high) / 2;
                (is_material(cell, middle) == was ? low : high) = middle;
            }
            if (was && (!is || i == steps)) kept.push_back({from, is ? at : low});
            if (!was && is) {
                from = high;
                if (i == steps) kept.push_back({from, at});
            }
            before = at, was = is;
        }
        return kept;
    }

    void add(const ContourCell& cell, const Place& a, const Place& b, int depth) {
        const double step = (b.along - a.along) / 4;
        const Place middle = place(cell, a.along + 2 * step);
        ContourArc arc = arc_through(a.way, middle.way, b.way, a.normal, b.normal);
        const auto fits = [&](double along) {
            return arc.angle_off(place(cell, along).way) <= allowed_;
        };
        if (depth > 0 && !(fits(a.along + step) && fits(b.along - step))) {
            add(cell, a, middle, depth - 1);
            add(cell, middle, b, depth - 1);
            return;
        }
        // The sheets lie on the side to which the surface bends along the line of sight: inwards
        // where it turns away from the viewpoint there.
        const Vec3 left = middle.way.cross(b.way - a.way);
        const Vec3 to_sheets = middle.normal * (turns_away(cell, middle) ? -1 : 1);
        const int sheets = left.dot(to_sheets) > 0 ? 1 : -1;
        arc.left = {sheets, sheets};
        arc.turns_at_begin = arc.turns_at_end = false;
        arcs_.all.push_back(arc);
    }

    /// True if the outer side of the surface faces the viewpoint before a silhouette, and not
    /// behind it.
    bool turns_away(const ContourCell& cell, const Place& at) const {
        const SurfaceDerivatives s = evaluate(patch_.points.view(), at.uv, 1);
        const Vec3 normal = s.du().cross(s.dv());
        const double by_u = at.way.cross(s.dv()).dot(normal);
        const double by_v = s.du().cross(at.way).dot(normal);
        const Vec2 gradient = cell.gradient(at.uv);
        return gradient.x * by_u + gradient.y * by_v < 0;
    }

    const OccluderPatch& patch_;
    double side_;
    const TrimRegion* region_;
    Vec3 eye_; ///< relative to the patch's center
    double allowed_;
    ContourArcs& arcs_;
};

} // namespace

Vec4 value_of(const HomogeneousNet& net, const Vec2& uv) {
    const BernsteinRow by_u = bernstein_values(net.degree_u, uv.x);
    const BernsteinRow by_v = bernstein_values(net.degree_v, uv.y);
    Vec4 sum(0);
    for (int i = 0; i <= net.degree_u; ++i) {
        Vec4 row(0);
        for (int j = 0; j <= net.degree_v; ++j)
            row += net.view().point(i, j) * by_v[static_cast<std::size_t>(j)];
        sum += row * by_u[static_cast<std::size_t>(i)];
    }
    return sum;
}

Vec4 ContourPatch::outer_plane(const Vec2& uv, const Vec3& center) const {
    Vec4 plane = value_of(patch_->planes, (uv - patch_->uv.lower) / patch_->uv.extent()) * side_;
    plane.w += spatial(plane).dot(center - patch_->center);
    return plane;
}

void ContourPatch::append_arcs(const Vec3& point, double allowed, ContourArcs& arcs) const {
    const Vec3 eye = point - patch_->center;
    const Vec4 weights = Vec4(eye.x, eye.y, eye.z, 1) * side_;
    if (patch_->flat || bounds_.weighed(weights).vanishes_nowhere()) return;
    ContourTrace trace(*patch_, side_, region_, point, allowed, arcs);
    for (const ContourCell& cell : ContourCell::all(weighed(patch_->planes, weights)))
        trace.add(cell);
}

} // namespace keiko
