#include "keiko/scene/view.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace keiko {
namespace {

constexpr double eye_height = 1650;               ///< mm above the ground
constexpr double nearest = 3000, farthest = 5000; ///< mm from the box to a standing eye
constexpr double widest_standing_fov = 60;        ///< degrees; a larger body is seen from farther
constexpr double high_elevation = 40;             ///< degrees

/// One of the eight sides a body is viewed from. Azimuth in degrees from the front (-x) towards the
/// left (-y).
struct Side {
    std::string_view name;
    double azimuth, elevation;
};
constexpr std::array<Side, 10> sides{{
    {"front", 0, 0},
    {"rear", 180, 0},
    {"left", 90, 0},
    {"right", -90, 0},
    {"three-quarter-front", 40, 15},
    {"three-quarter-front-left", 40, 15},
    {"three-quarter-front-right", -40, 15},
    {"three-quarter-rear", 140, 15},
    {"three-quarter-rear-left", 140, 15},
    {"three-quarter-rear-right", -140, 15},
}};

Vec3 direction(double azimuth, double elevation) {
    const double a = degrees_to_radians(azimuth), e = degrees_to_radians(elevation);
    return {-std::cos(a) * std::cos(e), -std::sin(a) * std::cos(e), std::sin(e)};
}

std::array<Vec3, 8> corners(const Box3& box) {
    std::array<Vec3, 8> points;
    for (unsigned i = 0; i < 8; ++i)
        points[i] = {(i & 1 ? box.upper : box.lower).x, (i & 2 ? box.upper : box.lower).y,
                     (i & 4 ? box.upper : box.lower).z};
    return points;
}

/// The box, grown where it is but a point.
Box3 visible_box(const Box3& bounds) {
    if (bounds.empty()) throw Error("", "view", "there is nothing to look at: the model is empty");
    return bounds.size() > 0 ? bounds : bounds.padded(0.5);
}

Camera empty_picture(const Framing& framing) {
    Camera camera;
    camera.vertical_fov = framing.vertical_fov;
    camera.width = framing.width;
    camera.height = framing.height;
    return camera;
}

/// Least distance, and the offset at it, from which a slope of +-`slope` holds all corners that
/// lie `lateral` aside and `depth` behind the middle of the box.
struct Fit {
    double distance, offset;
};
Fit fit(const std::array<Vec3, 8>& corners, const Vec3& lateral, const Vec3& forward,
        double slope) {
    double low = Box3::infinity, high = -Box3::infinity;
    for (const Vec3& corner : corners) {
        low = std::min(low, corner.dot(lateral) + slope * corner.dot(forward));
        high = std::max(high, corner.dot(lateral) - slope * corner.dot(forward));
    }
    return {(high - low) / (2 * slope), (high + low) / 2};
}

/// Points the camera at the middle of what it sees of the box, then opens it until all is in.
void aim_from_fixed_eye(Camera& camera, const Box3& box, double margin) {
    const double aspect = static_cast<double>(camera.width) / camera.height;
    camera.target = box.center();
    camera.vertical_fov = 90;
    double half_height = 0;
    for (int round = 0; round < 8; ++round) { // converges by about a digit a round
        const CameraAxes axes = camera.axes();
        Box2 seen;
        for (const Vec3& corner : corners(box)) {
            const Vec3 offset = corner - camera.eye;
            seen.extend(Vec2(offset.dot(axes.right), offset.dot(axes.up)) /
                        offset.dot(axes.forward));
        }
        const Vec2 middle = seen.center();
        const double distance = (box.center() - camera.eye).length();
        camera.target =
            camera.eye +
            (axes.forward + axes.right * middle.x + axes.up * middle.y).normalized() * distance;
        half_height = std::max(seen.extent().x / aspect, seen.extent().y) / 2;
    }
    camera.vertical_fov = 2 * radians_to_degrees(std::atan(half_height / (1 - 2 * margin)));
}

/// mm, z of the floor on which the viewer of a body stands.
double floor_of(const Box3& box, const Framing& framing) {
    const bool is_over_floor = box.lower.z >= 0 && box.lower.z < eye_height;
    return framing.ground.value_or(is_over_floor ? 0 : box.lower.z);
}

Camera standing_view(const Side& side, const Box3& box, const Framing& framing) {
    Camera camera = empty_picture(framing);
    const Vec3 away = direction(side.azimuth, 0);
    const Vec3 half = box.extent() / 2;
    const double reach = std::abs(away.x) * half.x + std::abs(away.y) * half.y;
    const double wanted =
        frame_direction(away, box, framing).eye.dot(away) - box.center().dot(away) - reach;
    // Half the size keeps every corner of a tall body well before the eye.
    const double start = std::max(std::clamp(wanted, nearest, farthest), box.size() / 2);
    for (double distance = start;; distance *= 1.25) {
        camera.eye = box.center() + away * (reach + distance);
        camera.eye.z = floor_of(box, framing) + eye_height;
        aim_from_fixed_eye(camera, box, framing.margin);
        if (camera.vertical_fov <= widest_standing_fov) return camera;
    }
}

const Side* find_side(std::string_view name) {
    const auto* found = std::find_if(sides.begin(), sides.end(),
                                     [&](const Side& side) { return side.name == name; });
    return found == sides.end() ? nullptr : found;
}

} // namespace

const std::vector<std::string>& view_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const std::string_view prefix : {"", "high-", "standing-"})
            for (const Side& side : sides)
                all.push_back(std::string(prefix) + std::string(side.name));
        all.insert(all.end(), {"top", "bottom"});
        return all;
    }();
    return names;
}

Camera frame_direction(const Vec3& towards_eye, const Box3& bounds, const Framing& framing) {
    const Box3 box = visible_box(bounds);
    Camera camera = empty_picture(framing);
    camera.eye = box.center() + towards_eye.normalized() * box.size();
    camera.target = box.center();
    const CameraAxes axes = camera.axes();
    camera.up = axes.up;

    std::array<Vec3, 8> around = corners(box);
    for (Vec3& corner : around) corner -= box.center();
    const double slope =
        std::tan(degrees_to_radians(framing.vertical_fov) / 2) * (1 - 2 * framing.margin);
    const double aspect = static_cast<double>(camera.width) / camera.height;
    const Fit across = fit(around, axes.right, axes.forward, slope * aspect);
    const Fit upright = fit(around, axes.up, axes.forward, slope);
    camera.target += axes.right * across.offset + axes.up * upright.offset;
    camera.eye = camera.target - axes.forward * std::max(across.distance, upright.distance);
    return camera;
}

Camera frame_view(std::string_view name, const Box3& bounds, const Framing& framing) {
    constexpr std::string_view standing = "standing-", high = "high-";
    if (name == "top") return frame_direction({0, 0, 1}, bounds, framing);
    if (name == "bottom") return frame_direction({0, 0, -1}, bounds, framing);
    if (const Side* side = find_side(name))
        return frame_direction(direction(side->azimuth, side->elevation), bounds, framing);
    if (name.starts_with(high))
        if (const Side* side = find_side(name.substr(high.size())))
            return frame_direction(direction(side->azimuth, high_elevation), bounds, framing);
    if (name.starts_with(standing))
        if (const Side* side = find_side(name.substr(standing.size())))
            return standing_view(*side, visible_box(bounds), framing);
    throw Error("", "view",
                "unknown view '" + std::string(name) + "'" + did_you_mean(name, view_names()) +
                    "; views are " + comma_list(view_names()));
}

namespace {

/// Share of its extent by which a symmetric box may miss the plane, and one that is not symmetric
/// must.
constexpr double even = 1e-3, uneven = 0.02;

/// Distance of the middle of the box from 0 along an axis, as share of its extent.
double offset(const Box3& body, int axis) {
    return std::abs(body.center()[axis]) / body.extent()[axis];
}

Diagnostic remark(const char* plane, const char* suggestion) {
    return {Severity::note, "axes",
            std::string("the body lies evenly about ") + plane +
                " = 0, not about y = 0, the middle plane of a vehicle: named views take x as "
                "rearwards, y as to the right and z as up; where y is up, axes " +
                suggestion + " turns it"};
}

} // namespace

std::optional<Diagnostic> axes_remark(const Box3& body) {
    if (body.empty() || !(body.center().y > 0) || !(offset(body, 1) > uneven)) return {};
    const bool about_x = offset(body, 0) < even, about_z = offset(body, 2) < even;
    if (about_x == about_z) return {};
    return about_x ? remark("x", "z,x,y") : remark("z", "x,-z,y");
}

} // namespace keiko
