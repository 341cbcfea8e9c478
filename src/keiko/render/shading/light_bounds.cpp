#include "keiko/render/shading/light_bounds.h"

#include "keiko/light/rig/light_visibility.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/tubes/tube_lamp.h"

#include <numbers>

namespace keiko {
namespace {

/// Around lamps of a row, so far off their axes and beyond their ends.
std::vector<Vec3> box_around(const CPlaneFrame& frame, int first, int last, double off,
                             double beyond) {
    std::vector<Vec3> corners;
    corners.reserve(8);
    for (const double along : {-beyond, frame.length + beyond})
        for (const double across : {frame.axis(first) - off, frame.axis(last) + off})
            for (const double height : {-off, off})
                corners.push_back(frame.at(along, across) + frame.normal * height);
    return corners;
}

struct Corners {
    std::span<const int> lamps;
    const Vec3& point;

    std::vector<Vec3> operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        const double r = frame.radius() * std::numbers::sqrt2; // of boxes however turned
        return box_around(frame, lamps.front(), lamps.back(), r, r);
    }
    template <PointLight Light>
    std::vector<Vec3> operator()(const Light& light) const {
        return {light.position};
    }
    std::vector<Vec3> operator()(const Sun& sun) const { return {sun.seen_from(point)}; }
};

} // namespace

std::vector<Vec3> light_bounds(const LightSource& source, std::span<const int> lamps,
                               const Vec3& point) {
    return std::visit(Corners{lamps, point}, source);
}

std::vector<Vec3> lamp_corners(const LightSource& source, int lamp, const Vec3& point,
                               TubeModel model) {
    const auto* row = std::get_if<CPlane>(&source);
    if (!row) return light_bounds(source, {&lamp, 1}, point);
    const CPlaneFrame frame(*row);
    if (weighs_width(*row, model)) return box_around(frame, lamp, lamp, frame.radius(), 0);
    return {frame.at(0, frame.axis(lamp)), frame.at(frame.length, frame.axis(lamp))};
}

} // namespace keiko
