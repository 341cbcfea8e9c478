#include "keiko/inspect/overlaps/face_inside.h"

#include <algorithm>

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
    return trims().classify(
        {model_.face_parameters(patch, uv.lower), model_.face_parameters(patch, uv.upper)});
}

bool FaceInside::is_inside(std::uint32_t index, const Vec2& uv, const SurfaceDerivatives& s) {
    const Patch& patch = model_.patches[index];
    const ParameterMetric metric(s.du() / patch.map_u.derivative(uv.x),
                                 s.dv() / patch.map_v.derivative(uv.y));
    const Vec2 place = model_.face_parameters(index, uv);
    if (face_.loop_count == 0) return !is_near_side(place, metric);
    return trims().contains(place) && !trims().nearest_curve(place, metric, margin_);
}

bool FaceInside::is_near_side(const Vec2& place, const ParameterMetric& metric) const {
    const Vec2 low = place - domain_.lower, high = domain_.upper - place;
    return std::min(low.x, high.x) * metric.least().x <= margin_ ||
           std::min(low.y, high.y) * metric.least().y <= margin_;
}

} // namespace keiko
