#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/intersect/traversal/tracer.h"

#include <optional>
#include <vector>

namespace keiko {

/// The neighbours' borders beyond those of a model's faces. Neighbours are two faces of an edge of
/// the file. They are also borders without an edge in common that are the same curve to within
/// rounding, as those of bare patches are. Keeps references to the model, the borders and the
/// tracer.
class AdjacentFaces {
public:
    /// Neighbours of the borders of `model`; `tracer` is of the same model and tells the widths of
    /// its seams.
    AdjacentFaces(const SurfaceModel& model, const BoundaryCurves& borders, const Tracer& tracer);

    /// The border of the one neighbour.
    class Partner {
    public:
        /// Unit, from the neighbour's border, where it is nearest to `place`, into the neighbour;
        /// nothing where it is so far off that rays pass between the two.
        std::optional<Vec3> inward_at(const Vec3& place) const;

    private:
        friend class AdjacentFaces;
        struct Sample {
            std::size_t curve;
            double t;
            Vec3 position;
        };
        struct Foot {
            std::size_t curve;
            double t;
        };
        explicit Partner(double widest) : widest_(widest) {}
        void add(const SurfaceCurve& curve);
        /// Nearest place of the neighbour's border; nothing where that is too far away.
        std::optional<Foot> nearest(const Vec3& place) const;

        std::vector<SurfaceCurve> curves_;
        std::vector<Sample> samples_;
        double widest_ = 0; ///< mm
    };
    /// Neighbour along a border curve; nothing where not just one neighbour follows it.
    std::optional<Partner> partner(const BoundaryInterval& border) const;

private:
    /// Neighbour across an edge of the file.
    std::optional<Partner> across_edge(const BoundaryInterval& border) const;
    /// Neighbour whose border is the same curve all along.
    std::optional<Partner> same_curve(const BoundaryInterval& border) const;
    bool has_edge(const BoundaryInterval& border) const;
    /// Drops borders that an edge joins from loose_.
    std::vector<Box3> loose_boxes();

    const SurfaceModel* model_;
    const BoundaryCurves* borders_;
    const Tracer* tracer_;
    std::vector<std::vector<EdgeUse>> uses_; ///< by edge
    std::vector<BoundaryInterval> loose_;    ///< borders that no edge joins to another
    BoxTree loose_boxes_;
};

} // namespace keiko
