#pragma once

#include "keiko/base/job.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/drawing/sheet/joined_strokes.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/camera.h"

#include <memory>
#include <span>
#include <vector>

namespace keiko {

/// Options of LineBody.
struct LineBodyOptions {
    double join = 0.5;       ///< mm, within which two borders are a seam
    double crease_angle = 1; ///< degrees, above which a seam is a crease at its sharpest place
    /// mm between curves and the chords of their points, as a share of the body's size.
    double chord_error = 2e-5;
};

/// A body made ready for line drawings of any number of views. Keeps references to its model and
/// tracer.
class LineBody {
public:
    /// Finds the edges of a body. `tracer`: of the model. Throws Cancelled.
    LineBody(const SurfaceModel& model, const Tracer& tracer, const LineBodyOptions& options = {},
             const Job& job = {});
    ~LineBody();
    LineBody(const LineBody&) = delete;
    LineBody& operator=(const LineBody&) = delete;

    /// mm between curves and the chords of their points.
    double chord_error() const;

    /// All edges and outlines in one view, and other curves on the body, visible and hidden parts
    /// apart; `wireframe`: all of them as visible. Joined where parts of one kind continue each
    /// other. The same for any number of threads. Throws Error where a perspective eye is not
    /// before all of the body, and Cancelled.
    std::vector<Stroke> strokes(const Camera& camera, std::span<const ModelCurve> others,
                                bool wireframe, const Job& job = {}) const;
    /// Whether points on the body are visible in a view, in order.
    std::vector<bool> visible(const Camera& camera, std::span<const Vec3> places) const;

private:
    struct Edges;
    std::vector<Stroke> parts(const Camera& camera, std::span<const ModelCurve> others,
                              bool wireframe, const Job& job) const;

    const SurfaceModel& model_;
    const Tracer& tracer_;
    double chord_error_;
    std::unique_ptr<const Edges> edges_;
};

} // namespace keiko
