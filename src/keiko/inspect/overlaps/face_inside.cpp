#include "keiko/inspect/overlaps/face_inside.h"

#include "keiko/geometry/seam/border_run.h"
#include "keiko/inspect/basics/face_box.h"

#include <algorithm>
#include <cmath>

namespace keiko {

FaceInside::FaceInside(const SurfaceModel& model, const Face& face, double margin)
    : model_(model), face_(face), margin_(margin) {
    for (std::uint32_t i = 0; i < face.patch_count; ++i)
        for (const double corner : {0.0, 1.0})
            domain_.extend(model.face_parameters(face.first_patch + i, Vec2(corner)));
}

const TrimRegion& FaceInside::trims() {
    if (!trims_) trims_.emplace(model_, face_);
    return *trims_;
}

TrimSide FaceInside::side(std::uint32_t patch, const Box2& uv) {
    if (face_.loop_count == 0) return TrimSide::inside;
    return trims().classify(face_box(model_, patch, uv));
}

ParameterMetric FaceInside::metric(std::uint32_t index, const Vec2& uv,
                                   const SurfaceDerivatives& s) const {
    const Patch& patch = model_.patches[index];
    return {s.du() / patch.map_u.derivative(uv.x), s.dv() / patch.map_v.derivative(uv.y)};
}

bool FaceInside::is_inside(std::uint32_t patch, const Vec2& uv, const SurfaceDerivatives& s) {
    const ParameterMetric step = metric(patch, uv, s);
    const Vec2 place = model_.face_parameters(patch, uv);
    if (face_.loop_count == 0) return !is_near_side(place, step);
    return trims().contains(place) && !trims().nearest_curve(place, step, margin_);
}

bool FaceInside::is_on(std::uint32_t patch, const Vec2& uv, const SurfaceDerivatives& s) {
    if (face_.loop_count == 0) return true;
    const Vec2 place = model_.face_parameters(patch, uv);
    return trims().contains(place) || trims().nearest_curve(place, metric(patch, uv, s), margin_);
}

bool FaceInside::is_near_side(const Vec2& place, const ParameterMetric& metric) const {
    const Vec2 low = place - domain_.lower, high = domain_.upper - place;
    return std::min(low.x, high.x) * metric.least().x <= margin_ ||
           std::min(low.y, high.y) * metric.least().y <= margin_;
}

namespace {

/// The place of a border, which goes round where it is closed.
Vec3 place_at(const FreeEdge& border, double way) {
    const double all = border.length();
    if (border.closed) way = std::fmod(std::fmod(way, all) + all, all);
    return border.at(std::clamp(way, 0.0, all)).position;
}

} // namespace

BorderPassage border_passage(const FreeEdge& border, double way, const Hit& hit, double join) {
    constexpr int steps = 16; // on either side
    const double step = join / 2 / std::sin(parallel_borders) / steps;
    BorderPassage passage;
    double least_before = 0, most_before = 0, least_after = 0, most_after = 0;
    for (int i = -steps; i <= steps; ++i) {
        const Vec3 off = place_at(border, way + i * step) - hit.position;
        const double offset = off.dot(hit.normal);
        if (i < steps && std::abs(offset) <= join) passage.length += step;
        double& least = i < 0 ? least_before : least_after;
        double& most = i < 0 ? most_before : most_after;
        least = std::min(least, offset), most = std::max(most, offset);
    }
    passage.is_through = (least_before < -join / 2 && most_after > join / 2) ||
                         (most_before > join / 2 && least_after < -join / 2);
    return passage;
}

} // namespace keiko
