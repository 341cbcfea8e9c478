#pragma once

#include "tests/bench/contender.h"
#include "tests/bench/embree_body.h"
#include "tests/bench/triangle_mesh.h"

#include <string>

namespace keiko::bench {

/// Embree's own triangles, default build quality.
class MeshContender : public Contender {
public:
    /// `facts` needs kind, name and deflection; `bounds` are those that the mesh is centred in.
    MeshContender(TriangleMesh mesh, const Box3& bounds, ContenderFacts facts);
    std::unique_ptr<Pass> pass(const RaySet& rays, Mode mode) const override;
    /// Records the outcome of the search for a grid that is exact enough.
    void describe(std::string remark, bool exact_enough);

private:
    TriangleMesh mesh_;
    Ball ball_;
    double lift_; ///< mm over the surface where reflected rays begin
    EmbreeBody body_;
};

} // namespace keiko::bench
