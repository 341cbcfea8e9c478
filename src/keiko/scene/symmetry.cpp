#include "keiko/scene/symmetry.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace keiko {

MirrorPlane MirrorPlane::parse(std::string_view text) {
    const Error wrong("", "",
                      "'" + shortened(text) +
                          "' is no plane to mirror at: x, y or z, or one with its place, y=12.5 "
                          "(mm)");
    MirrorPlane plane;
    const std::size_t axis =
        text.empty() ? std::string_view::npos : std::string_view("xyz").find(text.front());
    if (axis == std::string_view::npos) throw wrong;
    plane.axis = static_cast<int>(axis);
    if (text.size() == 1) return plane;
    const char* const end = text.data() + text.size();
    if (text[1] != '=') throw wrong;
    const auto [rest, fault] = std::from_chars(text.data() + 2, end, plane.offset);
    if (fault != std::errc() || rest != end || !std::isfinite(plane.offset)) throw wrong;
    return plane;
}

std::string MirrorPlane::text() const {
    char text[40];
    std::snprintf(text, sizeof text, "%c = %.6g", "xyz"[axis], offset);
    return text;
}

Vec3 MirrorPlane::image(const Vec3& point) const {
    Vec3 image = point;
    image[axis] = 2 * offset - point[axis];
    return image;
}

Vec3 MirrorPlane::image_of_direction(const Vec3& direction) const {
    Vec3 image = direction;
    image[axis] = -direction[axis];
    return image;
}

Affine MirrorPlane::motion() const {
    Affine mirror;
    mirror.rows[static_cast<std::size_t>(axis)][axis] = -1;
    mirror.translation[axis] = 2 * offset;
    return mirror;
}

SymmetryChoice SymmetryChoice::parse(std::string_view text) {
    SymmetryChoice choice;
    if (text == "off") return choice;
    choice.kind = text == "auto" ? Kind::automatic : Kind::plane;
    if (choice.kind == Kind::plane) choice.plane = MirrorPlane::parse(text);
    return choice;
}

} // namespace keiko
