#include "keiko/geometry/trim/material_bounds.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/trim/highest_place.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

HullBoxes hull_boxes(const SurfaceModel& model, const Job& job) {
    HullBoxes boxes;
    boxes.faces.resize(model.faces.size());
    constexpr std::size_t chunk = 256;
    parallel_for((model.faces.size() + chunk - 1) / chunk, job, "", [&](std::size_t task) {
        const std::size_t end = std::min(model.faces.size(), (task + 1) * chunk);
        for (std::size_t f = task * chunk; f < end; ++f)
            for (std::uint32_t p = 0; p < model.faces[f].patch_count; ++p)
                boxes.faces[f].extend(hull_bounds(model.patch(model.faces[f].first_patch + p)));
    });
    for (const Part& part : model.parts) {
        Box3& box = boxes.parts.emplace_back();
        for (std::uint32_t f = 0; f < part.face_count; ++f)
            box.extend(boxes.faces[part.first_face + f]);
    }
    return boxes;
}

Box3 placed_hull(const SurfaceModel& model, const HullBoxes& hulls) {
    Box3 box;
    for (const Instance& instance : model.instances)
        if (!hulls.parts[instance.part].empty())
            box.extend(transformed(instance.transform, hulls.parts[instance.part]));
    return box;
}

Box3 searched(const SurfaceModel& model, const HullBoxes& hulls, const SearchLimits& limits,
              const Job& job) {
    Box3 box;
    constexpr std::size_t sides = 6;
    parallel_for(sides, job, "", [&](std::size_t side) {
        const auto axis = static_cast<unsigned>(side / 2);
        const double sign = side % 2 == 0 ? -1 : 1;
        Vec3 direction(0);
        direction[axis] = sign;
        const double height = highest_place(model, hulls, direction, limits, job);
        (sign < 0 ? box.lower : box.upper)[axis] = sign * height + 0.0; // never -0
    });
    return box.empty() ? Box3() : box;
}

} // namespace

Box3 material_bounds(const SurfaceModel& model, const Job& job) {
    constexpr double accuracy = 1e-9, rounding = 1e-14, least_share = 0.1;
    const HullBoxes hulls = hull_boxes(model, job);
    Box3 hull = placed_hull(model, hulls);
    if (hull.empty()) return hull;
    const double finest = rounding * std::max(hull.lower.length(), hull.upper.length());
    for (double size = hull.size();;) {
        const double limit = std::max(finest, accuracy * size);
        Box3 box = searched(model, hulls, {limit}, job);
        if (box.size() >= least_share * size || box.empty() || limit == finest) return box;
        size = box.size(); // much was trimmed away: for the rest the limit was too coarse
    }
}

} // namespace keiko
