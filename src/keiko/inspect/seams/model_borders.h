#pragma once

#include "keiko/inspect/seams/face_sizes.h"

namespace keiko {

/// The border curves of a model and the sizes of its placed faces: made once, for everything that
/// needs seams and free edges. A model converts to it for a single query. Keeps a reference to the
/// model.
struct ModelBorders {
    ModelBorders(const SurfaceModel& of) : model(of), curves(of), sizes(curves) {}

    const SurfaceModel& model;
    BoundaryCurves curves;
    FaceSizes sizes;
};

} // namespace keiko
