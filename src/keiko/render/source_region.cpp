#include "keiko/render/source_region.h"

#include "keiko/spotlight/point_light.h"
#include "keiko/tubes/tube_lamp.h"

namespace keiko {
namespace {

struct Corners {
    const Vec3& point;

    std::vector<Vec3> operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        std::vector<Vec3> corners;
        const double r = frame.radius();
        for (const double along : {-r, frame.length + r})
            for (const double across : {frame.axis(0) - r, frame.last() + r})
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

std::vector<Vec3> source_region(const LightSource& source, const Vec3& point) {
    return std::visit(Corners{point}, source);
}

std::vector<Segment> source_segments(const LightSource& source) {
    std::vector<Segment> segments;
    if (const auto* plane = std::get_if<CPlane>(&source))
        for (const TubeLamp& lamp : lamps_of(*plane)) segments.push_back({lamp.a, lamp.b});
    return segments;
}

} // namespace keiko
