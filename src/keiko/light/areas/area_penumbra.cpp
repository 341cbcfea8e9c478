#include "keiko/light/areas/area_penumbra.h"

#include "keiko/light/areas/area_width.h"

#include <optional>
#include <vector>

namespace keiko {
namespace {

double share_of(const AreaWidth& width, const Visibility& visible, const WidthOptions& options) {
    const Segment first = width.line_of(width.sub_axis(-1));
    const Segment last = width.line_of(width.sub_axis(1));
    const Prism around{first, first, last, last};
    if (const auto whole = visible.classify_prisms({&around, 1}).front()) return *whole ? 1 : 0;
    WidthShare share(width, options);
    std::vector<Segment> lines;
    share.add_lines(width, lines);
    const std::vector<IntervalSet> seen = visible.intervals(lines);
    auto next = seen.begin();
    share.hide_lines(width, next);
    return share.visible_share(width, visible);
}

} // namespace

double visible_share(const PolygonLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    const auto width = width_of(light, point, normal);
    return width ? share_of(*width, visible, options) : 0;
}

double visible_share(const SphereLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    const auto width = width_of(light, point, normal);
    return width ? share_of(*width, visible, options) : 0;
}

} // namespace keiko
