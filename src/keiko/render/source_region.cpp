#include "keiko/render/source_region.h"

#include "keiko/spotlight/point_light.h"
#include "keiko/tubes/tube_lamp.h"

#include <numbers>

namespace keiko {
namespace {

struct Corners {
    std::span<const int> lamps;
    const Vec3& point;

    std::vector<Vec3> operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        std::vector<Vec3> corners;
        corners.reserve(8);
        const double r = frame.radius() * std::numbers::sqrt2; // of boxes however turned
        for (const double along : {-r, frame.length + r})
            for (const double across :
                 {frame.axis(lamps.front()) - r, frame.axis(lamps.back()) + r})
                for (const double height : {-r, r})
                    corners.push_back(frame.at(along, across) + frame.normal * height);
        return corners;
    }
    template <PointLight Light>
    std::vector<Vec3> operator()(const Light& light) const {
        return {light.position};
    }
    std::vector<Vec3> operator()(const Sun& sun) const { return {sun.seen_from(point)}; }
};

} // namespace

std::vector<Vec3> source_region(const LightSource& source, std::span<const int> lamps,
                                const Vec3& point) {
    return std::visit(Corners{lamps, point}, source);
}

} // namespace keiko
