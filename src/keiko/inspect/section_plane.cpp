#include "keiko/inspect/section_plane.h"

#include "keiko/base/error.h"

#include <cmath>
#include <cstdio>

namespace keiko {

SectionPlane section_plane(const std::string& text) {
    SectionPlane plane{text, Vec3(0), 0};
    int end = 0;
    char axis = 0;
    const auto whole = [&] { return static_cast<std::size_t>(end) == text.size(); };
    if (std::sscanf(text.c_str(), "%c=%lf%n", &axis, &plane.height, &end) == 2 && whole() &&
        axis >= 'x' && axis <= 'z') {
        plane.normal[static_cast<unsigned>(axis - 'x')] = 1;
    } else if (Vec3& n = plane.normal; std::sscanf(text.c_str(), "%lf,%lf,%lf=%lf%n", &n.x, &n.y,
                                                   &n.z, &plane.height, &end) == 4 &&
                                       whole() && n.length() > 0 && std::isfinite(n.length())) {
        n = n.normalized();
    } else {
        throw Error("", "--section", "'" + text + "' is not x=MM, y=MM, z=MM or A,B,C=MM");
    }
    if (!std::isfinite(plane.height)) throw Error("", "--section", "'" + text + "' is nowhere");
    return plane;
}

} // namespace keiko
