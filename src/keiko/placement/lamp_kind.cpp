#include "keiko/placement/lamp_kind.h"

namespace keiko {
namespace {

/// The panel of a row from one to another of its coordinates across the lamps.
PolygonLight panel_between(const CPlane& row, double from, double to, const Vec3& body) {
    const CPlaneFrame frame(row);
    PolygonLight panel{{frame.at(0, from), frame.at(frame.length, from), frame.at(frame.length, to),
                        frame.at(0, to)},
                       row.luminance};
    if (!panel.shines_at(body)) std::swap(panel.corners[1], panel.corners[3]);
    return panel;
}

} // namespace

std::string_view name_of(LampKind kind) {
    switch (kind) {
        case LampKind::panel:
            return "panel";
        case LampKind::screen:
            return "screen";
        default:
            return "tube";
    }
}

std::vector<LightSource> lights_of(const CPlane& row, LampKind kind, const Vec3& body) {
    if (kind == LampKind::tube) return {row};
    const CPlaneFrame frame(row);
    if (kind == LampKind::panel) return {panel_between(row, 0, frame.v.dot(row.v), body)};
    std::vector<LightSource> bars;
    for (int lamp = 0; lamp < frame.lamps; ++lamp) {
        const double middle = frame.axis(lamp);
        bars.emplace_back(
            panel_between(row, middle - frame.pitch / 4, middle + frame.pitch / 4, body));
    }
    return bars;
}

} // namespace keiko
