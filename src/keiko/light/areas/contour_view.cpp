#include "keiko/light/areas/contour_view.h"

#include "keiko/math/box_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Cosine of the widest angle to the middle of a body that is viewed from afar: 75 degrees.
constexpr double widest = 0.2588190451025208;
/// Slope beside the normal up to which one width views a near body.
constexpr double steepest = 1e3;
/// Distance of the plane behind a body, by that of its farthest place.
constexpr double behind = 1.01;

std::vector<Vec3> ways_to_corners(const Box3& box, const Vec3& point) {
    std::vector<Vec3> ways = corners_of(box);
    for (Vec3& way : ways) way -= point;
    return ways;
}

/// True if a part of a box is above the horizon of a point.
bool rises(const Box3& box, const Vec3& point, const Vec3& normal) {
    const std::vector<Vec3> corners = ways_to_corners(box, point);
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Vec3& corner) { return corner.dot(normal) > 0; });
}

/// The longest axis of a box that is not nearly along the view, made square to it.
Vec3 lines_of(const Box3& box, const Vec3& ahead) {
    constexpr double nearly_along = 0.8;
    const Vec3 size = box.extent();
    std::array<unsigned, 3> axes{0, 1, 2};
    std::sort(axes.begin(), axes.end(), [&](unsigned a, unsigned b) { return size[a] > size[b]; });
    for (const unsigned i : axes) {
        Vec3 axis(0, 0, 0);
        axis[i] = 1;
        const double cosine = axis.dot(ahead);
        if (std::abs(cosine) < nearly_along) return (axis - ahead * cosine).normalized();
    }
    return Vec3(0, 0, 0); // no direction is nearly along two axes
}

/// Corners of the part of a box at least so far ahead; between any two of them it is cut.
std::vector<Vec3> cut_ahead(const std::vector<Vec3>& corners, const Vec3& ahead, double least) {
    std::vector<Vec3> kept;
    for (const Vec3& a : corners) {
        const double height = a.dot(ahead) - least;
        if (height >= 0) kept.push_back(a);
        for (const Vec3& b : corners) {
            const double below = b.dot(ahead) - least;
            if (height > 0 && below < 0) kept.push_back(a + (b - a) * (height / (height - below)));
        }
    }
    return kept;
}

ParameterInterval common(const ParameterInterval& a, const ParameterInterval& b) {
    return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

} // namespace

bool ContourView::is_far(const Box3& box, const Vec3& point) {
    const Vec3 view = (box.center() - point).normalized();
    const std::vector<Vec3> corners = ways_to_corners(box, point);
    return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
        return corner.dot(view) > widest * corner.length();
    });
}

std::optional<ContourView> ContourView::within(const LuminousBody& body, const Vec3& point,
                                               const Vec3& ahead, const Vec3& along,
                                               const ParameterInterval& across, double slope) {
    const std::vector<Vec3> corners = ways_to_corners(body.bounds(), point);
    double farthest = 0;
    for (const Vec3& corner : corners) farthest = std::max(farthest, corner.dot(ahead));
    if (!(farthest > 0)) return std::nullopt;
    ContourView view{point, ahead, along, {}, behind * farthest, {}, {}};
    constexpr double none = std::numeric_limits<double>::infinity();
    ParameterInterval u{none, -none}, v = u; // slopes
    constexpr double lowest = 1e-9;          // below which slopes are those of the limits
    for (const Vec3& at : cut_ahead(corners, ahead, lowest * farthest)) {
        const Vec3 own(at.dot(view.along), at.dot(view.across()), at.dot(ahead));
        view.reach.extend(own);
        u = {std::min(u.begin, own.x / own.z), std::max(u.end, own.x / own.z)};
        v = {std::min(v.begin, own.y / own.z), std::max(v.end, own.y / own.z)};
    }
    u = common(u, {-slope, slope}), v = common(v, across);
    if (!(u.begin < u.end && v.begin < v.end)) return std::nullopt;
    view.reach = view.reach.intersection({Vec3(-slope * farthest, across.begin * farthest, 0),
                                          Vec3(slope * farthest, across.end * farthest, farthest)});
    view.extent = {u.begin * view.distance, u.end * view.distance};
    view.turn = {std::atan(v.begin), std::atan(v.end)};
    return view;
}

std::vector<ContourView> ContourView::all(const LuminousBody& body, const Vec3& point,
                                          const Vec3& normal) {
    std::vector<ContourView> views;
    const Box3& box = body.bounds();
    if (!rises(box, point, normal)) return views;
    const auto add = [&](const Vec3& ahead, const Vec3& along, const ParameterInterval& across,
                         double slope) {
        if (auto view = within(body, point, ahead, along, across, slope)) views.push_back(*view);
    };
    if (is_far(box, point)) {
        constexpr double all = std::numeric_limits<double>::infinity();
        const Vec3 ahead = (box.center() - point).normalized();
        add(ahead, lines_of(box, ahead), {-all, all}, all);
        return views;
    }
    const Vec3 x = lines_of(box, normal), y = normal.cross(x);
    add(normal, x, {-1, 1}, 1);
    for (const Vec3& aside : {x, -x, y, -y}) add(aside, normal.cross(aside), {0, 1}, 1);
    return views;
}

std::optional<ContourView> ContourView::one(const LuminousBody& body, const Vec3& point,
                                            const Vec3& normal) {
    const std::vector<ContourView> views = all(body, point, normal);
    if (views.empty()) return std::nullopt;
    if (views.size() == 1) return views.front();
    return within(body, point, normal, lines_of(body.bounds(), normal), {-steepest, steepest},
                  steepest);
}

Vec3 ContourView::on_plane(double u, double wedge_angle) const {
    return point + along * u + (across() * std::tan(wedge_angle) + ahead) * distance;
}

} // namespace keiko
