#include "keiko/inspect/lines/line_visibility.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

/// mm, and share of the size of the visible geometry: an occluder nearer than this is the other
/// side of a seam, which is a little higher. A line does not end there.
constexpr double nearest_occluder = 0.2, nearest_in_sizes = 2e-4;

} // namespace

LineVisibility::LineVisibility(const Tracer& seen, const LineField& field, double level)
    : seen_(seen),
      field_(field),
      level_(level),
      begin_(std::min(nearest_occluder, nearest_in_sizes * seen.bounds().size())) {}

bool LineVisibility::on_lamp(const LineField::Image& image) const {
    // At a collapsed edge the field is 0 on every level, and does not identify the lamp.
    constexpr double rounding = 1e-4; // degrees
    const bool isophote = field_.look() == LineLook::isophote;
    // An isophote has levels of both signs, as the patch's own normal may point away from the
    // viewpoint.
    const double level = isophote ? std::abs(level_) : level_;
    if (!image.faces || !(field_.normal_turn(image, level - image.value) < rounding)) return false;
    return isophote || (image.along >= 0 && image.along <= field_.plane().length);
}

Ray LineVisibility::to_eye(const Vec3& place) const {
    Ray ray;
    ray.origin = place;
    ray.direction = -field_.eye().towards(place);
    if (!field_.eye().parallel) ray.t_max = 1;
    ray.t_min = begin_ / ray.direction.length();
    return ray;
}

bool LineVisibility::sees(const Vec3& place, const Vec3& normal, const Root& root) const {
    const LineField::Image image = field_.image(place, normal);
    if (!on_lamp(image)) return false;
    Ray ray = to_eye(place);
    ray.excluded = root;
    if (seen_.any(ray)) return false;
    if (field_.look() != LineLook::reflection) return true;
    const Vec3 towards = -ray.direction.normalized();
    Ray mirrored;
    mirrored.origin = place;
    mirrored.direction = reflect(towards, normal);
    mirrored.t_min = begin_;
    mirrored.t_max = image.reach;
    mirrored.excluded = root;
    return !seen_.any(mirrored);
}

} // namespace keiko
