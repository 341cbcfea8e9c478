#include "keiko/workflow/three_views.h"

#include "keiko/drawing/curves/image_projection.h"

#include <cmath>

namespace keiko {
namespace {

/// Extent of a body along an axis of the picture that is one of space.
std::optional<double> extent_along(const Box3& box, const Vec3& axis) {
    constexpr double aligned = 1e-9;
    for (unsigned k = 0; k < 3; ++k)
        if (std::abs(std::abs(axis[k]) - 1) < aligned) return box.extent()[k];
    return std::nullopt;
}

} // namespace

const std::vector<std::string>& three_views() {
    static const std::vector<std::string> names{"left", "front", "top"};
    return names;
}

void add_dimensions(SheetView& view, const Camera& camera, const Box3& box) {
    const CameraAxes axes = camera.axes();
    view.width = extent_along(box, axes.right);
    view.height = extent_along(box, axes.up);
    if (!view.width || !view.height) view.width = view.height = std::nullopt;
}

std::vector<SheetMark> marks_at(const std::vector<Vec3>& places, const LineBody& body,
                                const Camera& camera, bool wireframe) {
    const ImageProjection projection(camera);
    const std::vector<bool> visible = body.visible(camera, places);
    std::vector<SheetMark> marks;
    for (std::size_t i = 0; i < places.size(); ++i)
        marks.push_back({projection.image(places[i]).at, static_cast<std::uint32_t>(i + 1),
                         wireframe || visible[i]});
    return marks;
}

} // namespace keiko
