#include "keiko/light/areas/sign.h"

#include "keiko/light/luminance/photometry.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace keiko {
namespace {

using Ring = std::vector<Vec3>;

/// True if a way crosses a side of a ring in the plane with this normal.
bool crosses(const Vec3& from, const Vec3& to, const Ring& ring, const Vec3& normal) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (segments_cross(from, to, ring[i], ring[(i + 1) % ring.size()], normal)) return true;
    return false;
}

/// A straight cut from a corner of the outline to one of a hole, by their indices.
struct Cut {
    double length = 0;
    std::size_t corner = 0, hole = 0, hole_corner = 0;
};

/// The shortest cut that meets no side. There is one, as holes are apart from each other.
Cut shortest_cut(const Ring& outline, const std::vector<Ring>& holes, const Vec3& normal) {
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i < outline.size(); ++i)
        for (std::size_t h = 0; h < holes.size(); ++h)
            for (std::size_t k = 0; k < holes[h].size(); ++k)
                cuts.push_back({(holes[h][k] - outline[i]).length(), i, h, k});
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const Cut& a, const Cut& b) { return a.length < b.length; });
    const auto is_free = [&](const Cut& cut) {
        const Vec3 &from = outline[cut.corner], &to = holes[cut.hole][cut.hole_corner];
        return !crosses(from, to, outline, normal) &&
               std::none_of(holes.begin(), holes.end(),
                            [&](const Ring& hole) { return crosses(from, to, hole, normal); });
    };
    const auto found = std::find_if(cuts.begin(), cuts.end(), is_free);
    return found == cuts.end() ? cuts.front() : *found;
}

} // namespace

std::vector<Vec3> without_holes(std::vector<Vec3> outline, std::vector<std::vector<Vec3>> holes) {
    const Vec3 normal = polygon_normal(outline);
    for (Ring& hole : holes)
        if (polygon_normal(hole).dot(normal) > 0) std::reverse(hole.begin(), hole.end());
    while (!holes.empty()) {
        const Cut cut = shortest_cut(outline, holes, normal);
        Ring& hole = holes[cut.hole];
        std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(cut.hole_corner),
                    hole.end());
        hole.push_back(hole.front());
        hole.push_back(outline[cut.corner]);
        outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(cut.corner) + 1, hole.begin(),
                       hole.end());
        holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(cut.hole));
    }
    return outline;
}

double LuminousSign::legend_luminance() const {
    if (legend.empty()) return luminance(panel.luminance);
    double sum = 0, area = 0;
    for (const PolygonLight& part : legend) {
        const double own = polygon_normal(part.corners).length();
        sum += own * luminance(part.luminance), area += own;
    }
    return sum / area;
}

Vec3 LuminousSign::center() const {
    Vec3 sum(0);
    for (const Vec3& corner : panel.corners) sum += corner;
    return sum / static_cast<double>(panel.corners.size());
}

std::vector<PolygonLight> LuminousSign::panels() const {
    std::vector<Ring> holes;
    for (const PolygonLight& part : legend) holes.push_back(part.corners);
    std::vector<PolygonLight> all{panel};
    all.front().corners = without_holes(panel.corners, std::move(holes));
    all.insert(all.end(), legend.begin(), legend.end());
    return all;
}

} // namespace keiko
