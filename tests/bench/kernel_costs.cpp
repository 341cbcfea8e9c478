#include "tests/bench/kernel_costs.h"

#include "keiko/intersect/traversal/tracer.h"

#include "tests/bench/bare_kernels.h"
#include "tests/bench/cpu_clock.h"
#include "tests/bench/leaf_visits.h"
#include "tests/bench/summary.h"
#include <hwy/nanobenchmark.h>

#include <bit>
#include <utility>

namespace keiko::bench {
namespace {

/// SubPatchKernels or BareKernels at work on pairs.
template <class Kernels>
class Work {
public:
    Work(const Kernels& kernels, const TracedModel& model, const LeafVisits& visits)
        : kernels_(kernels), model_(model), visits_(visits) {}

    double look_seconds() {
        return thread_seconds([&] {
            for (const LeafVisit& v : visits_.visits) {
                look(visits_.blocks[v.block], v.rays, model_.hot[v.sub_patch]);
                kept_ += existence_.certain | existence_.single | existence_.undecided;
            }
        });
    }
    double solve_seconds() {
        return thread_seconds([&] {
            for (const LeafVisit& v : visits_.visits) {
                if (v.solved == 0) continue;
                solve(visits_.blocks[v.block], v.solved, model_.hot[v.sub_patch]);
                kept_ += roots_.found;
            }
        });
    }

private:
    void look(const RayPacket& rays, LaneMask mask, const PackedSubPatch& sub_patch) {
        if (std::has_single_bit(mask))
            kernels_.existence_test_single(rays, static_cast<std::size_t>(std::countr_zero(mask)),
                                           sub_patch, existence_);
        else
            kernels_.existence_test(rays, mask, sub_patch, existence_);
    }
    void solve(const RayPacket& rays, LaneMask mask, const PackedSubPatch& sub_patch) {
        const Component4* polynomial = &model_.sub_patches.polynomials[sub_patch.polynomial];
        if (std::has_single_bit(mask))
            kernels_.solve_single(rays, static_cast<std::size_t>(std::countr_zero(mask)), sub_patch,
                                  polynomial, roots_);
        else
            kernels_.solve(rays, mask, sub_patch, polynomial, roots_);
    }

    const Kernels& kernels_;
    const TracedModel& model_;
    const LeafVisits& visits_;
    ExistenceResult existence_;
    SubPatchRoots roots_;
    LaneMask kept_ = 0; ///< so that no compiler drops the work
};

double search_seconds(const Tracer& tracer, std::span<const Ray> rays, Mode mode) {
    return thread_seconds([&] {
        if (mode == Mode::packets)
            tracer.nearest_crossings(rays);
        else
            for (const Ray& ray : rays) tracer.nearest_crossings({&ray, 1});
    });
}

/// All that is measured on one model.
struct Bench {
    Tracer tracer;
    TracedModel model;
    EmbreeScene boxes;
    SubPatchKernels kernels = sub_patch_kernels();
    BareKernels bare = bare_kernels();

    explicit Bench(const SurfaceModel& source)
        : tracer(source),
          model(traced_model(source, TracerOptions().join, TracerOptions().sub_patch_contraction,
                             Job{})),
          boxes(tracer.boxes(), 1) {}

    KernelCosts measure(const RaySet& rays, Mode mode, int rounds) const {
        const LeafVisits visits = leaf_visits(model, boxes, kernels, rays.rays, mode);
        Work proved(kernels, model, visits);
        Work unproved(bare, model, visits);
        const double cycles = hwy::platform::InvariantTicksPerSecond();
        std::vector<double> looks, solves, proofs;
        for (int round = 0; round < rounds; ++round) {
            const double look = proved.look_seconds(), bare_look = unproved.look_seconds();
            const double solve = proved.solve_seconds(), bare_solve = unproved.solve_seconds();
            const double search = search_seconds(tracer, rays.rays, mode);
            looks.push_back(look * cycles / static_cast<double>(visits.pairs()));
            solves.push_back(solve * cycles / static_cast<double>(visits.solved()));
            proofs.push_back((look - bare_look + solve - bare_solve) / search);
        }
        return {median(std::move(looks)), median(std::move(solves)), median(std::move(proofs))};
    }
};

} // namespace

CostsByMode kernel_costs(const SurfaceModel& model, const RaySet& rays, int rounds) {
    const Bench bench(model);
    return {bench.measure(rays, Mode::single, rounds), bench.measure(rays, Mode::packets, rounds)};
}

} // namespace keiko::bench
