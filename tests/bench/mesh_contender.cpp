#include "tests/bench/mesh_contender.h"

#include "tests/bench/embree_pass.h"

#include <algorithm>
#include <utility>

namespace keiko::bench {

MeshContender::MeshContender(TriangleMesh mesh, const Box3& bounds, ContenderFacts facts)
    : mesh_(std::move(mesh)),
      ball_(bounds),
      lift_(std::max(2 * std::max(facts.deflection, mesh_.deviation), 1e-6 * bounds.size())),
      body_(mesh_) {
    facts_ = std::move(facts);
    facts_.elements = mesh_.triangles.size();
    facts_.bytes = mesh_.bytes() + body_.bytes();
    facts_.deviation = mesh_.deviation;
    facts_.mesh_seconds = mesh_.mesh_seconds;
    facts_.build_seconds = body_.build_seconds();
}

void MeshContender::describe(std::string remark, bool exact_enough) {
    facts_.remark = std::move(remark);
    facts_.exact_enough = exact_enough;
}

std::unique_ptr<Pass> MeshContender::pass(const RaySet& rays, Mode mode) const {
    EmbreeRays prepared(rays, ball_, mode, {.lift = lift_});
    return std::make_unique<EmbreePass>(
        body_, rays, std::move(prepared), [this](const EmbreeHit& hit) {
            return Answer{hit.t, mesh_.normal(hit.primitive, hit.u, hit.v)};
        });
}

} // namespace keiko::bench
