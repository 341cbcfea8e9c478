#include "keiko/visibility/boundaries/crease_lines.h"

#include "keiko/geometry/bezier/differential_geometry.h"

namespace keiko {
namespace {

constexpr double same_normal = 1e-9; ///< rad

std::optional<Vec3> normal_at(const SurfaceModel& model, std::uint32_t patch,
                              const Vec2& face_parameters) {
    const Patch& p = model.patches[patch];
    const Vec2 uv(p.map_u.to_patch(face_parameters.x), p.map_v.to_patch(face_parameters.y));
    return unit_normal(evaluate(model.patch(patch), uv, 2), uv);
}

/// The four sides of a patch in face parameters, anticlockwise there.
std::array<std::array<Vec3, 2>, 4> sides_of(const SurfaceModel& model, std::uint32_t patch) {
    Box2 box;
    box.extend(model.face_parameters(patch, Vec2(0)));
    box.extend(model.face_parameters(patch, Vec2(1)));
    const Vec3 a(box.lower.x, box.lower.y, 1), b(box.upper.x, box.lower.y, 1);
    const Vec3 c(box.upper.x, box.upper.y, 1), d(box.lower.x, box.upper.y, 1);
    return {{{a, b}, {b, c}, {c, d}, {d, a}}};
}

} // namespace

CreaseLines::CreaseLines(const SurfaceModel& model) : model_(&model) {
    for (const Face& face : model.faces) grids_.emplace_back(model, face);
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            const Face& face = model.faces[f];
            for (std::uint32_t k = 0; face.patch_count > 1 && k < face.patch_count; ++k)
                for (const auto& side : sides_of(model, face.first_patch + k)) {
                    const CreaseLine line{i, f, side};
                    if (normal_jumps(face.first_patch + k, line)) lines_.push_back(line);
                }
        }
    }
}

bool CreaseLines::normal_jumps(std::uint32_t patch, const CreaseLine& line) const {
    constexpr int samples = 9;
    const Vec2 first(line.p_curve[0].x, line.p_curve[0].y);
    const Vec2 way = Vec2(line.p_curve[1].x, line.p_curve[1].y) - first;
    for (int i = 0; i < samples; ++i) {
        const Vec2 at = first + way * ((i + 0.5) / samples);
        const std::uint32_t beyond = grids_[line.face].locate(at, Vec2(way.y, -way.x));
        if (beyond == patch) return false;
        const auto here = normal_at(*model_, patch, at), there = normal_at(*model_, beyond, at);
        if (here && there && !(angle_between(*here, *there) <= same_normal)) return true;
    }
    return false;
}

SurfaceCurve CreaseLines::curve(const CreaseLine& line) const {
    return {*model_,
            grids_[line.face],
            model_->instances[line.instance].transform,
            {line.p_curve},
            true};
}

std::optional<Vec3> CreaseLines::inward_beyond(const CreaseLine& line, double t) const {
    const CreaseLine back{line.instance, line.face, {line.p_curve[1], line.p_curve[0]}};
    const auto frame = curve(back).frame(1 - t);
    return frame ? std::optional(frame->inward) : std::nullopt;
}

} // namespace keiko
