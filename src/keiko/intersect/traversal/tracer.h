#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/hit/hit.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Options of a tracer.
struct TracerOptions {
    /// Compute Hit::second.
    bool second_derivatives = false;
    /// Pure Bezier clipping without the uniqueness short cut, as in [Nishita1990]: the second
    /// implementation that the default must agree with.
    bool clipping_only = false;
    /// mm: the widest gap between the borders of two faces that share an edge in which a hit still
    /// counts, flagged as seam, so that sewn faces do not leak; see SeamGap.
    double join = 0.5;
    /// Patches are halved until SubPatchFrame::contraction is no larger, at most a few times.
    /// Changes what a ray costs, not what it hits; but where two faces lie on each other, it is on
    /// the sub-patches whether they count as one there.
    double sub_patch_contraction = 0.4;
};

/// Cost and size of a build.
struct TracerStatistics {
    /// Number of pieces that rays are tested against, that trimming has removed, and that trim
    /// curves cut.
    std::size_t sub_patches = 0, sub_patches_trimmed_away = 0, sub_patches_mixed = 0;
    std::size_t bytes = 0;            ///< of Keiko's own records
    double build_seconds = 0;         ///< wall-clock time of the build
    const char* instruction_set = ""; ///< that the kernels were chosen for
};

/// Detail in which hits are reported.
enum class HitDetail {
    face, ///< t, flags, seam, instance, face and patch; nothing else is to be read
    all   ///< everything
};

/// The first hits of many rays.
struct FirstHits {
    Hits hits;                         ///< of the rays that have one, in their order
    std::vector<std::uint32_t> of_ray; ///< which of them each ray has; no_index: none

    /// Null where a ray has none.
    const Hit* operator[](std::size_t ray) const {
        return of_ray[ray] == no_index ? nullptr : &hits[of_ray[ray]];
    }
};

/// Ray tracer of the trimmed surfaces of a model: sub-patches under Embree, trimmed by the exact
/// p-curves. On them roots are proved and found by Newton's method or, where that fails, by Bezier
/// clipping [Nishita1990]. Immutable after construction; every query may be called from any thread.
/// Copies share what was built.
/// It gives the same bits for any thread count and any company of rays in a query. A ray whose
/// direction is not between 1e-140 and 1e150 long hits nothing. Neither does a ray from so far away
/// (1e8 times the model's size) that rounding blurs its start by a four millionth of that size.
class Tracer {
public:
    /// Keeps its own copy of what it needs of `model`. Throws Cancelled, and Error for a placement
    /// that is flat or sheared (condition number, by Frobenius norms, above 1e4).
    explicit Tracer(const SurfaceModel& model, const TracerOptions& options = {},
                    const Job& job = {});

    /// Tracer of the whole model without some faces, through which rays pass. `hidden` has one
    /// value a face. Nothing is built anew: it shares what was built, and may outlive this one. On
    /// the other faces it has the same hits, bit for bit. Where one of them borders a hidden one,
    /// the width of their seam still counts as material.
    Tracer without(const std::vector<bool>& hidden) const;

    /// The first hit with t in [t_min, t_max], or nothing: the first of all(), but where two faces
    /// overlap within their seam's width it is the one met first, where all() may keep the
    /// other.
    std::optional<Hit> nearest(const Ray& ray) const;
    /// Whether there is a hit with t in [t_min, t_max].
    bool any(const Ray& ray) const;
    /// Every hit with t in [t_min, t_max], by rising t.
    std::vector<Hit> all(const Ray& ray) const;

    /// Nearest hits of many rays, one answer a ray, in order. Coherent rays should stand together.
    std::vector<std::optional<Hit>> nearest(std::span<const Ray> rays) const;
    /// nearest(), with less memory, and less work for less detail.
    FirstHits first_hits(std::span<const Ray> rays, HitDetail detail = HitDetail::all) const;
    /// any() of many rays, in order.
    std::vector<bool> any(std::span<const Ray> rays) const;
    /// all() of many rays, in order.
    std::vector<std::vector<Hit>> all(std::span<const Ray> rays) const;

    /// The first crossing of each ray, in order, false where there is none: nearest() without what
    /// costs most. Near a seam it may be the neighbour's, flagged so, where nearest() has the hit.
    std::vector<Crossing> nearest_crossings(std::span<const Ray> rays) const;
    /// The hit at a crossing that this tracer found.
    Hit evaluate(const Crossing& crossing) const;

    /// Cost and size of the build.
    const TracerStatistics& statistics() const;
    /// World boxes of the sub-patches that rays may hit, mm.
    std::span<const Box3> boxes() const;
    /// World box of the material, mm; with that of hidden faces.
    const Box3& bounds() const;
    /// How far apart, mm, part coordinates, a trim curve and the border of the neighbour that
    /// shares its edge may be for the two faces to count as one; see SeamGap.
    double seam_width(std::uint32_t trim_curve) const;

private:
    /// Calls `work(search, scene, first, rays)` for every block of rays; `first` is the index of
    /// its first ray.
    template <class Work>
    void each_block(std::span<const Ray> rays, const Work& work) const;
    /// Puts the nearest crossing of each ray into `found`, which must hold as many without a hit.
    void find_nearest(std::span<const Ray> rays, std::span<Crossing> found) const;
    /// The hit at a ray's nearest crossing; within the band of a seam, the one that all() keeps.
    std::optional<Hit> hit_of(const Ray& ray, const Crossing& crossing) const;

    /// The hits at the nearest crossings of rays: each written to `slot(ray)`, but where they are
    /// within the band of a seam `replace(ray, hit)` gets the one that all() keeps, if it does.
    template <class Slot, class Replace>
    void evaluate(std::span<const Ray> rays, std::span<const Crossing> crossings, HitDetail detail,
                  const Slot& slot, const Replace& replace) const;

    struct Scene;
    struct Hidden;
    Tracer(std::shared_ptr<const Scene> scene, std::shared_ptr<const Hidden> hidden);

    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const Hidden> hidden_; ///< null: nothing is hidden
};

} // namespace keiko
