#pragma once

#include "keiko/base/units.h"
#include "keiko/triage/triage.h"

#include "tests/support/model_builder.h"

#include <array>
#include <cmath>

namespace keiko::test {

/// Two sheets, `length` mm along x, that meet at an angle in degrees.
inline void bent_pair(ModelBuilder& builder, const Vec3& from, double length, double degrees,
                      double parts = 1) {
    const double turn = degrees_to_radians(degrees), width = 100;
    for (double i = 0; i < parts; ++i) {
        const Vec3 run(length / parts, 0, 0), origin = from + run * i;
        builder.plane(origin, run, {0, width, 0});
        builder.plane(origin, run, {0, -width * std::cos(turn), -width * std::sin(turn)});
    }
}

/// Two sheets, 400 mm along x, tangent to each other and to the plane z = from.z, of other
/// curvatures across, 1/mm; above 0: hollow from above.
inline void curved_pair(ModelBuilder& builder, const Vec3& from, double before, double after) {
    const double width = 100;
    for (const auto& [side, curvature] : {std::pair(-1.0, before), {1.0, after}}) {
        std::vector<Vec3> points;
        for (const double x : {0.0, 400.0})
            for (const double share : {0.0, 0.5, 1.0})
                points.push_back(from + Vec3(x, side * width * share,
                                             share == 1 ? curvature * width * width / 2 : 0));
        builder.patch(1, 2, points);
    }
}

/// The walls of a closed box.
inline void closed_box(ModelBuilder& builder, const Vec3& low, const Vec3& size) {
    const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    for (const Vec3& origin : {low, low + z}) builder.plane(origin, x, y);
    for (const Vec3& origin : {low, low + y}) builder.plane(origin, x, z);
    for (const Vec3& origin : {low, low + x}) builder.plane(origin, y, z);
}

struct Triaged {
    Inspection inspection;
    Triage triage;

    explicit Triaged(const ModelBuilder& builder) {
        const SurfaceModel model = builder.build();
        inspection = inspect(model);
        triage = keiko::triage(model, Tracer(model), inspection, {});
    }
    double angle_of(const TriageItem& item) const {
        return inspection.seams[item.seams.front()].angle->value;
    }
};

/// Eight sheets around a hole of 10 x 8 mm.
inline void holed_sheet(ModelBuilder& builder, const Vec3& from) {
    constexpr std::array<double, 4> x{0, 100, 110, 210}, y{0, 100, 108, 208};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (i != 1 || j != 1)
                builder.plane(from + Vec3(x[i], y[j], 0), {x[i + 1] - x[i], 0, 0},
                              {0, y[j + 1] - y[j], 0});
}

} // namespace keiko::test
