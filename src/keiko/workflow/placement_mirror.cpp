#include "keiko/workflow/placement_mirror.h"

#include "keiko/compare/shape/symmetry.h"
#include "keiko/placement/plane_frame.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Planes through the camera's eye across each axis, at 0 if they are there to within rounding.
std::vector<MirrorPlane> planes_through(const Camera& camera) {
    const double rounding = 1e-9 * (camera.target - camera.eye).length();
    std::vector<MirrorPlane> planes;
    for (const int axis : {1, 0, 2}) {
        const double offset = camera.eye[axis];
        planes.push_back({axis, std::abs(offset) < rounding ? 0 : offset});
    }
    return planes;
}

bool is_symmetric(std::span<const Camera> cameras, const MirrorPlane& plane) {
    return std::all_of(cameras.begin(), cameras.end(),
                       [&](const Camera& camera) { return is_own_image(camera, plane); });
}

/// True if the image of each direction is among them.
bool is_symmetric(const PlaneChoice& where, const MirrorPlane& plane) {
    const auto has_image = [&](const Vec3& direction) {
        constexpr double same = 1 - 1e-12; // cosine
        const Vec3 image = plane.image_of_direction(direction);
        return std::any_of(where.towards.begin(), where.towards.end(),
                           [&](const Vec3& other) { return other.dot(image) > same; });
    };
    return where.frames.empty() &&
           std::all_of(where.towards.begin(), where.towards.end(), has_image);
}

} // namespace

std::optional<MirrorPlane> placement_mirror(const SurfaceModel& model,
                                            std::span<const Camera> cameras,
                                            const PlacementOptions& options,
                                            const SymmetryChoice& choice, const Job& job) {
    if (choice.kind == SymmetryChoice::Kind::off || cameras.empty()) return std::nullopt;
    const bool given = choice.kind == SymmetryChoice::Kind::plane;
    for (const MirrorPlane& plane :
         given ? std::vector{choice.plane} : planes_through(cameras.front()))
        if (is_symmetric(cameras, plane) && is_symmetric(options.where, plane) &&
            mirror_deviation(model, plane, options.sampling.faces, job) <= choice.distance)
            return plane;
    return std::nullopt;
}

} // namespace keiko
