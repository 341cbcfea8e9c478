#pragma once

#include "keiko/base/error.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/raster/triangle_limit.h"

#include <atomic>
#include <cstddef>
#include <sstream>

namespace keiko {

/// The number of cells or triangles of a mesh, added up by all threads and held below a limit.
class MeshBudget {
public:
    /// For a mesh of a model within `deviation` mm. Keeps a reference to the model.
    MeshBudget(const SurfaceModel& model, double deviation, const TriangleLimit& limit)
        : model_(model), deviation_(deviation), limit_(limit), spent_(limit.beside) {}

    /// Throws Error if that is more than the limit with all that was spent before. What it says is
    /// the same whichever thread is first.
    void spend(std::size_t count) {
        if (spent_.fetch_add(count) + count <= limit_.most) return;
        std::ostringstream reason;
        reason << "its mesh within " << deviation_ << " mm has more than " << limit_.most
               << " cells or triangles";
        if (limit_.beside > 0) reason << ", with those of the meshes beside it";
        throw Error(model_.source, "", reason.str());
    }

private:
    const SurfaceModel& model_;
    double deviation_;
    TriangleLimit limit_;
    std::atomic<std::size_t> spent_;
};

} // namespace keiko
