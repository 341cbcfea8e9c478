#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/scene/camera.h"
#include "keiko/visibility/query/occluders.h"

#include <string>
#include <vector>

namespace keiko::bench {

/// A point of a surface that lamps light.
struct Receiver {
    Vec3 position{0}, normal{0}; ///< the normal unit, on the viewed side
    Root root{};
};

/// Receiver at a ray's hit, on the side that the ray comes from.
Receiver receiver_at(const Hit& hit, const Ray& ray);

/// A body on the ground under a row of lamps, and points of both that a standing eye sees.
struct PenumbraScene {
    std::string name{};
    std::size_t patches = 0, faces = 0; ///< with the ground
    Tracer tracer;
    Occluders occluders;
    CPlane row{};
    Camera camera{}; ///< of the standing eye
    std::vector<Receiver> receivers{};

    /// The row hangs level over the body, somewhat larger than it. `clearance`: between the ground
    /// and the body, in sizes of the body.
    PenumbraScene(std::string name, const SurfaceModel& body, double clearance, int lamps,
                  std::size_t points);

    /// The row's plane with another number of lamps.
    CPlane row_of(int lamps) const;

private:
    PenumbraScene(std::string name, const Box3& box, const SurfaceModel& body, double clearance,
                  int lamps, std::size_t points);
    PenumbraScene(std::string name, const Box3& box, const SurfaceModel& all, int lamps,
                  std::size_t points);
};

/// A sheet with one wave along each side, 1 m wide, as a face of `along_x` x `along_y` bicubic
/// patches: nearly the same surface for any number of them.
SurfaceModel wavy_sheet(int along_x, int along_y);

} // namespace keiko::bench
