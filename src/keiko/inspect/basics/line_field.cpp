#include "keiko/inspect/basics/line_field.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>

namespace keiko {

std::string_view name_of(LineLook look) {
    switch (look) {
        case LineLook::reflection:
            return "reflection";
        case LineLook::highlight:
            return "highlight";
        case LineLook::isophote:
            return "isophote";
    }
    return "";
}

LineEye::LineEye(const Camera& camera)
    : point(camera.eye),
      direction(camera.axes().forward),
      parallel(camera.projection == Projection::orthographic) {}

LineField::LineField(LineLook look, const LineEye& eye, const CPlane& plane, const Vec3& body)
    : look_(look),
      eye_(eye),
      plane_(plane),
      towards_lamps_(plane_.point(body).z > 0 ? -plane_.normal : plane_.normal) {}

LineField::Image LineField::image(const Vec3& place, const Vec3& normal) const {
    const Vec3 view = eye_.towards(place);
    const Vec3 facing = normal.normalized() * (view.dot(normal) > 0 ? -1.0 : 1.0);
    Image image;
    if (look_ == LineLook::isophote) {
        image.value = facing.dot(towards_lamps_);
        image.faces = true;
        return image;
    }
    const Vec3 ray = look_ == LineLook::highlight ? facing : reflect(view.normalized(), facing);
    const Vec3 from = plane_.point(place), slope = plane_.vector(ray);
    image.reach = -from.z / slope.z;
    image.value = from.y + image.reach * slope.y;
    image.along = from.x + image.reach * slope.x;
    image.faces = image.reach > 0 && std::isfinite(image.reach);
    return image;
}

double LineField::normal_turn(const Image& image, double change) const {
    if (look_ == LineLook::isophote) {
        const double from = std::acos(std::clamp(image.value, -1.0, 1.0));
        const double to = std::acos(std::clamp(image.value + change, -1.0, 1.0));
        return radians_to_degrees(std::abs(from - to));
    }
    const double turn = radians_to_degrees(std::atan2(std::abs(change), image.reach));
    return look_ == LineLook::highlight ? turn : turn / 2;
}

double LineField::turn_gain(const Vec3& place, const Vec3& normal) const {
    const Vec3 n = normal.normalized();
    const Vec3 beside = std::abs(n.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 e = n.cross(beside).normalized(), f = n.cross(e);
    const Triple<FirstJet> turned{{n.x, e.x, f.x}, {n.y, e.y, f.y}, {n.z, e.z, f.z}};
    const Triple<FirstJet> fixed{place.x, place.y, place.z};
    const LineRatio<FirstJet> value = ratio(fixed, turned);
    const FirstJet v = value.above / value.below;
    return std::hypot(v.u, v.v);
}

} // namespace keiko
