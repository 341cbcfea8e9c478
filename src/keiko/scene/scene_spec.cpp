#include "keiko/scene/scene_spec.h"

#include "keiko/base/units.h"

#include <algorithm>

namespace keiko {
namespace {

std::vector<double> blend(const std::vector<double>& a, const std::vector<double>& b, double t) {
    std::vector<double> value;
    for (std::size_t i = 0; i < a.size(); ++i) value.push_back(a[i] + (b[i] - a[i]) * t);
    return value;
}

} // namespace

Affine ModelTransform::affine() const {
    return Affine::translate(translation) * Affine::rotate(axis, degrees_to_radians(angle)) *
           Affine::scale(scale);
}

std::vector<double> Animation::at(double frame) const {
    const auto next = std::find_if(keys.begin(), keys.end(),
                                   [frame](const KeyFrame& key) { return key.frame > frame; });
    if (next == keys.begin()) return keys.front().value;
    if (next == keys.end()) return keys.back().value;
    const KeyFrame& last = *(next - 1);
    return blend(last.value, next->value, (frame - last.frame) / (next->frame - last.frame));
}

} // namespace keiko
