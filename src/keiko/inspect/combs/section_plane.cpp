#include "keiko/inspect/combs/section_plane.h"

#include "keiko/base/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace keiko {
namespace {

/// The finite number that the whole text states, without blanks; nullopt for any other text.
std::optional<double> number(std::string_view text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc() || rest != end || !std::isfinite(value)) return {};
    return value;
}

/// Unit normal named "x", "y", "z" or "A,B,C".
std::optional<Vec3> normal(std::string_view text) {
    Vec3 n(0);
    if (text.size() == 1 && text[0] >= 'x' && text[0] <= 'z') {
        n[static_cast<unsigned>(text[0] - 'x')] = 1;
        return n;
    }
    for (unsigned k = 0; k < 3; ++k) {
        const std::size_t comma = k < 2 ? text.find(',') : text.size();
        if (comma == text.npos) return {};
        const auto component = number(text.substr(0, comma));
        if (!component) return {};
        n[k] = *component;
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    if (!(n.length() > 0) || !std::isfinite(n.length())) return {};
    return n.normalized();
}

} // namespace

SectionPlane section_plane(const std::string& text) {
    const std::string_view all(text);
    const std::size_t sign = all.find('=');
    if (sign != all.npos) {
        const auto along = normal(all.substr(0, sign));
        const auto height = number(all.substr(sign + 1));
        if (along && height) return {text, *along, *height};
    }
    throw FieldError("section", "'" + text + "' is not x=MM, y=MM, z=MM or A,B,C=MM");
}

std::array<double, 2> heights(const SurfaceModel& model, const Vec3& along) {
    std::array<double, 2> reach{Box3::infinity, -Box3::infinity};
    const auto extend = [&](const Affine& placed, const Vec4& point) {
        const double height = along.dot(placed.point(euclidean(point)));
        reach = {std::min(reach[0], height), std::max(reach[1], height)};
    };
    for (const Instance& instance : model.instances) {
        const Part& part = model.parts[instance.part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            for (std::uint32_t p = 0; p < model.faces[f].patch_count; ++p)
                for (const Vec4& point : model.patch(model.faces[f].first_patch + p).points)
                    extend(instance.transform, point);
    }
    return reach;
}

} // namespace keiko
