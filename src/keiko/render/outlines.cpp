#include "keiko/render/outlines.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>

namespace keiko {

Outlines::Outlines(int width, int height)
    : width_(width),
      height_(height),
      places_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

const Outlines::Place& Outlines::at(int x, int y) const {
    return places_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
}

void Outlines::set(int x, int y, const EyeSample& sample) {
    if (!sample.hit) return;
    const Hit& hit = *sample.hit;
    places_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(x)] = {true, sample.paint, sample.mirrored_face.has_value(),
                                            hit.position, hit.normal};
}

bool Outlines::differ(const Place& a, const Place& b) {
    if (a.hit != b.hit) return true;
    if (!a.hit) return false;
    if (a.paint != b.paint) return true;
    if (a.mirrors_body != b.mirrors_body) return true;
    // Normals as lines: neighbouring faces may be oriented differently.
    const double turn =
        std::atan2(a.normal.cross(b.normal).length(), std::abs(a.normal.dot(b.normal)));
    if (turn > degrees_to_radians(10)) return true;
    // A step off the tangent planes of both: one surface in front of another.
    const Vec3 step = b.position - a.position;
    const double off = std::min(std::abs(step.dot(a.normal)), std::abs(step.dot(b.normal)));
    return off > 0.2 * step.length();
}

bool Outlines::cross(int x, int y) const {
    const Place& here = at(x, y);
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height_ - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i)
            if (differ(here, at(i, j))) return true;
    return false;
}

} // namespace keiko
