#pragma once

#include "keiko/patch/boundary_curves.h"
#include "keiko/patch/edge_uses.h"
#include "keiko/trace/tracer.h"

#include <optional>
#include <vector>

namespace keiko {

/// The neighbours' borders beyond those of a model's faces: where the file has two faces share an
/// edge. Looks into the model, the borders and the tracer that it was made from.
class BorderPartners {
public:
    BorderPartners(const SurfaceModel& model, const BoundaryCurves& borders, const Tracer& tracer);

    /// The border of the one neighbour that shares an edge.
    class Partner {
    public:
        /// Unit, from the neighbour's border, where it is nearest to `place`, into the neighbour;
        /// nothing where it is so far off that rays pass between the two.
        std::optional<Vec3> inward_at(const Vec3& place) const;

    private:
        friend class BorderPartners;
        struct Sample {
            std::size_t curve;
            double t;
            Vec3 position;
        };
        std::vector<SurfaceCurve> curves_;
        std::vector<Sample> samples_;
        double widest_ = 0; ///< mm
    };
    /// Of a border curve; nothing without an edge, or where not just two faces share it.
    std::optional<Partner> partner(const BoundaryInterval& border) const;

private:
    const SurfaceModel* model_;
    const BoundaryCurves* borders_;
    const Tracer* tracer_;
    std::vector<std::vector<EdgeUse>> uses_; ///< by edge
};

} // namespace keiko
