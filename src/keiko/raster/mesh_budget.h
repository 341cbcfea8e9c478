#pragma once

#include "keiko/base/error.h"
#include "keiko/geometry/model/surface_model.h"

#include <atomic>
#include <cstddef>
#include <sstream>

namespace keiko {

/// The number of cells or triangles of a mesh, added up by all threads and held below a limit.
class MeshBudget {
public:
    /// For a mesh of a model within `deviation` mm. Keeps a reference to the model.
    MeshBudget(const SurfaceModel& model, double deviation, std::size_t most)
        : model_(model), deviation_(deviation), most_(most) {}

    /// Throws Error if that is more than the limit with all that was spent before. What it says is
    /// the same whichever thread is first.
    void spend(std::size_t count) {
        if (spent_.fetch_add(count) + count <= most_) return;
        std::ostringstream reason;
        reason << "its mesh within " << deviation_ << " mm has more than " << most_
               << " cells or triangles";
        throw Error(model_.source, "", reason.str());
    }

private:
    const SurfaceModel& model_;
    double deviation_;
    std::size_t most_;
    std::atomic<std::size_t> spent_{0};
};

} // namespace keiko
