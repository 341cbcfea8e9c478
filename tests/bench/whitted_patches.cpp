#include "tests/bench/whitted_patches.h"

#include "keiko/geometry/bezier/subpatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko::bench {

WhittedPatches::WhittedPatches(const SurfaceModel& model, double tolerance)
    : tolerance_(tolerance) {
    for (const Instance& instance : model.instances)
        for (std::uint32_t p = 0; p < model.patches.size(); ++p) {
            if (model.faces[model.patches[p].face].part != instance.part) continue;
            const BezierPatchView patch = model.patch(p);
            std::vector<Vec4> points;
            for (const Vec4& point : patch.points)
                points.push_back(instance.transform.homogeneous(point));
            patches_.push_back(piece_of(patch.degree_u, patch.degree_v, std::move(points)));
        }
}

WhittedPatches::Piece WhittedPatches::piece_of(int degree_u, int degree_v,
                                               std::vector<Vec4> points) {
    Box3 box;
    for (const Vec4& point : points) box.extend(euclidean(point));
    Piece piece{degree_u, degree_v, std::move(points), box.center()};
    for (const Vec4& point : piece.points)
        piece.radius = std::max(piece.radius, (euclidean(point) - piece.center).length());
    return piece;
}

std::vector<WhittedPatches::Piece> WhittedPatches::quarters(const Piece& piece) {
    std::vector<Piece> parts;
    const BezierPatchView patch{piece.degree_u, piece.degree_v, piece.points};
    for (const double u : {0.0, 0.5})
        for (const double v : {0.0, 0.5})
            parts.push_back(piece_of(piece.degree_u, piece.degree_v,
                                     subpatch(patch, {Vec2(u, v), Vec2(u + 0.5, v + 0.5)})));
    return parts;
}

std::optional<double> WhittedPatches::first(const Ray& ray) const {
    std::optional<double> first;
    std::vector<Piece> todo;
    const auto add = [&](const Piece& piece) {
        const Vec3 way = piece.center - ray.origin;
        const double along = way.dot(ray.direction);
        const double off = (way - ray.direction * along).length();
        if (off > piece.radius || along + piece.radius <= 0) return;
        if (first && along - piece.radius >= *first) return;
        if (piece.radius > tolerance_)
            todo.push_back(piece);
        else if (!first || along < *first)
            first = along;
    };
    for (const Piece& patch : patches_) add(patch);
    while (!todo.empty()) {
        const Piece piece = std::move(todo.back());
        todo.pop_back();
        for (const Piece& part : quarters(piece)) add(part);
    }
    return first;
}

} // namespace keiko::bench
