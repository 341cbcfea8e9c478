#pragma once

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/area_penumbra.h"
#include "keiko/math/polygon.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/oracle.h"
#include "tests/support/shapes.h"

#include <algorithm>
#include <vector>

namespace keiko::test {

/// A plate of any outline: a square patch around it, trimmed.
inline void add_plate(std::span<const Vec3> corners, ShapeBuilder& shapes) {
    const Vec3 normal = polygon_normal(corners).normalized();
    const Vec3 x = (corners[1] - corners[0]).normalized(), y = normal.cross(x);
    double size = 0;
    for (const Vec3& corner : corners) size = std::max(size, 2 * (corner - corners[0]).length());
    const Vec3 low = corners[0] - (x + y) * (size / 2);
    std::vector<Vec2> outline;
    for (const Vec3& corner : corners)
        outline.emplace_back((corner - low).dot(x) / size, (corner - low).dot(y) / size);
    const Vec3 u = x * size, v = y * size;
    shapes.face({bilinear(low, low + u, low + v, low + u + v)}, {polygon(outline)});
}

/// The plates of a row of the tables of area sources.
inline SurfaceModel plates_of(const OracleRow& row) {
    const std::vector<Vec3> corners = row.points("in.occ");
    ShapeBuilder shapes;
    std::size_t first = 0;
    for (const double count : row.list("in.occ_n")) {
        add_plate(std::span(corners).subspan(first, static_cast<std::size_t>(count)), shapes);
        first += static_cast<std::size_t>(count);
    }
    return shapes.model();
}

/// Accuracy of keiko illuminance.
inline constexpr WidthOptions of_numbers{5e-5, 0.12, true};

/// Plates between a receiver and its lights.
class Plates {
public:
    explicit Plates(const OracleRow& row)
        : hidden_(row.has("in.occ")),
          model_(plates_of(row)),
          tracer_(model_),
          occluders_(model_, tracer_),
          point_(row.vector("in.P")),
          normal_(row.unit("in.N")) {}

    /// Projected solid angle of what is visible.
    template <class Light>
    double seen(const Light& light, const WidthOptions& options) const {
        const OccludedVisibility visible(hidden_ ? &occluders_ : nullptr, tracer_,
                                         Viewpoint::at(point_), bounds_of(light), {}, normal_);
        return projected_solid_angle(light, point_, normal_) *
               visible_share(light, point_, normal_, visible, options);
    }

private:
    bool hidden_;
    SurfaceModel model_;
    Tracer tracer_;
    Occluders occluders_;
    Vec3 point_, normal_;
};

} // namespace keiko::test
