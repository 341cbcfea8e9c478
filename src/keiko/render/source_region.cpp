#include "keiko/render/source_region.h"

#include "keiko/tubes/c_plane_frame.h"

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
    std::vector<Vec3> operator()(const Spotlight& light) const { return {light.position}; }
    std::vector<Vec3> operator()(const Sun& sun) const { return {sun.seen_from(point)}; }
};

} // namespace

std::vector<Vec3> source_region(const LightSource& source, const Vec3& point) {
    return std::visit(Corners{point}, source);
}

} // namespace keiko
