#pragma once

#include "keiko/base/units.h"
#include "keiko/inspect/lines/joined_lines.h"

#include "tests/unit/inspect/sheets.h"

#include <array>
#include <cmath>

namespace keiko::test {

constexpr double plane_height = 1500; ///< mm

/// Lamps on a level plane, their axes turned by `turn` from the x axis.
inline CPlane lamps_turned(double turn, int lamps = 1500) {
    const double size = 6000;
    CPlane plane;
    plane.u = Vec3(std::cos(turn), std::sin(turn), 0) * size;
    plane.v = Vec3(-std::sin(turn), std::cos(turn), 0) * size;
    plane.origin = Vec3(0, 0, plane_height) - (plane.u + plane.v) * 0.5;
    plane.lamps = lamps;
    return plane;
}

/// Looks along `direction` at the origin with parallel rays.
inline Camera parallel_camera(const Vec3& direction) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.eye = -direction * 3000, camera.target = Vec3(0);
    return camera;
}

inline JoinedLines joined(const SurfaceModel& model, const CPlane& plane, const Camera& camera,
                          const CriteriaPreset& preset = {}, const Job& job = {}) {
    const Tracer tracer(model);
    const std::array sources{LineSource(plane)};
    return join_lines(model, LineSeams(model, 0.5, job),
                      surface_lines(model, tracer, sources, camera, {}, job), sources, camera,
                      LineLook::reflection, preset, job);
}

/// Two flat sheets on either side of the x axis, the second one turned down by an angle.
inline SurfaceModel folded_sheets(double degrees_down) {
    const double angle = degrees_to_radians(degrees_down);
    ModelBuilder builder;
    flat_sheet(builder, {0, -100, 0});
    flat_sheet(builder, Vec3(0, std::cos(angle), -std::sin(angle)) * 100);
    return builder.build();
}

} // namespace keiko::test
