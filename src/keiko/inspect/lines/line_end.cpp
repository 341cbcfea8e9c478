#include "keiko/inspect/lines/line_end.h"

#include "keiko/inspect/basics/placed_face.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {

std::string_view name_of(LineEnd end) {
    constexpr std::array<std::string_view, 8> names{"closed",      "lamp",   "silhouette", "hidden",
                                                    "free-border", "crease", "seam",       "patch"};
    return names[static_cast<std::size_t>(end)];
}

LineEnd line_end(const SurfaceModel& model, const SurfaceLine& piece, bool head,
                 const LineBorders::End& end, const LineField& field, double feature_angle) {
    bool at_seam = false;
    for (const LineEndpoint& meeting : end.meetings) {
        if (meeting.angle > feature_angle) return LineEnd::crease;
        at_seam = at_seam || meeting.border.seam != no_index;
    }
    if (at_seam) return LineEnd::seam;
    if (end.on_border) return LineEnd::free_border;
    if (!end.meetings.empty()) return LineEnd::patch;
    const LinePoint& point = head ? piece.line.points.front() : piece.line.points.back();
    const SurfaceDerivatives s = placed_derivatives(model, piece.instance, piece.patch, point.uv);
    const Vec3 normal = s.du().cross(s.dv()).normalized();
    constexpr double grazing = 1e-4, at_lamp_end = 1e-6; // radians; share of the lamp
    if (!(std::abs(field.eye().towards(s.position()).normalized().dot(normal)) > grazing))
        return LineEnd::silhouette;
    const double along = field.image(s.position(), normal).along / field.plane().length;
    const bool ends_with_lamp = std::min(std::abs(along), std::abs(along - 1)) < at_lamp_end;
    return field.look() != LineLook::isophote && ends_with_lamp ? LineEnd::lamp : LineEnd::hidden;
}

} // namespace keiko
