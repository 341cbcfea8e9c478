#pragma once

#include "keiko/drawing/curves/body_edges.h"
#include "keiko/drawing/curves/outlines.h"
#include "keiko/drawing/hidden/curve_pieces.h"
#include "keiko/drawing/hidden/piercings.h"

#include <utility>
#include <vector>

namespace keiko::test {

/// A body with all that a drawing of one view needs.
struct DrawnBody {
    DrawnBody(SurfaceModel body, const Camera& camera, double chord_error = 0.01)
        : model(std::move(body)),
          tracer(model),
          projection(camera),
          edges(model, {.chord_error = chord_error}),
          outlines(find_outlines(model, LineEye(camera), chord_error)),
          sight(model, tracer, projection),
          pierced(find_piercings(edges.curves(), tracer)),
          image(projection, edges.occluding(), outlines.occluding, sight.size(), chord_error) {
        outlines.curves = find_piercings(outlines.curves, tracer);
    }

    /// All curves of the view.
    std::vector<const ModelCurve*> curves() const {
        std::vector<const ModelCurve*> all;
        for (const ModelCurve& curve : pierced) all.push_back(&curve);
        for (const ModelCurve& curve : outlines.curves) all.push_back(&curve);
        return all;
    }

    SurfaceModel model;
    Tracer tracer;
    ImageProjection projection;
    BodyEdges edges;
    Outlines outlines;
    SightTest sight;
    std::vector<ModelCurve> pierced; ///< the edges
    OccluderImage image;
};

/// A camera by its axes.
inline Camera camera_along(Projection projection, const Vec3& eye, const Vec3& forward,
                           const Vec3& up) {
    Camera camera;
    camera.projection = projection;
    camera.eye = eye, camera.target = eye + forward, camera.up = up;
    camera.orthographic_height = 100;
    return camera;
}

} // namespace keiko::test
