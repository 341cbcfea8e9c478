#include "keiko/geometry/trim/highest_place.h"

#include "keiko/geometry/trim/patch_material.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace keiko {
namespace {

struct PlacedPart {
    std::uint32_t instance = 0;
};

struct PlacedFace {
    std::uint32_t instance = 0, face = 0;
};

struct PlacedPatch {
    PlacedFace face;
    std::uint32_t patch = 0;
};

struct FaceTrims {
    TrimRegion region;
    std::vector<CurveStretch> border;
};

/// A box of a patch or a stretch of one of its sides.
struct SurfacePart {
    std::shared_ptr<const PatchMaterial> patch;
    PatchHeight height;
    bool inside = false; ///< no trim curve touches it
};

/// The part of a stretch of a trim curve that is on a patch.
struct CurvePart {
    std::shared_ptr<const PatchMaterial> patch;
    CurveStretch stretch;
    bool monotone = false; ///< its highest place is one of its ends
};

/// A part of the model that may hold the highest place.
struct Candidate {
    double upper = 0; ///< mm: none of its places is higher
    std::variant<PlacedPart, PlacedFace, PlacedPatch, SurfacePart, CurvePart> part;

    bool operator<(const Candidate& other) const { return upper < other.upper; }
};

double highest_control_point(const BezierPatchView& patch, const Height& height) {
    double highest = -Box3::infinity;
    for (const Vec4& p : patch.points) highest = std::max(highest, height.of(euclidean(p)));
    return highest;
}

class HighestPlace {
public:
    HighestPlace(const SurfaceModel& model, const HullBoxes& hulls, const Vec3& direction,
                 const SearchLimits& limits)
        : model_(model), hulls_(hulls), limits_(limits) {
        for (const Instance& instance : model.instances) {
            const Affine& placed = instance.transform;
            const auto& r = placed.rows;
            heights_.push_back({r[0] * direction.x + r[1] * direction.y + r[2] * direction.z,
                                direction.dot(placed.translation)});
        }
    }

    double run(const Job& job) {
        for (std::uint32_t i = 0; i < model_.instances.size(); ++i)
            add(heights_[i].most(hulls_.parts[model_.instances[i].part]), PlacedPart{i});
        constexpr std::size_t between_checks = 256;
        for (std::size_t count = 0; !open_.empty(); ++count) {
            if (count % between_checks == 0) job.check();
            const double upper = open_.front().upper;
            if (!is_higher(upper)) break;
            if (upper - best_ <= limits_.accuracy || cuts_ >= limits_.most_cuts) return upper;
            const Candidate next = taken();
            std::visit([&](const auto& part) { split(part); }, next.part);
        }
        return best_;
    }

private:
    bool is_higher(double height) const { return height > best_; }

    template <class Part>
    void add(double upper, Part part) {
        if (!is_higher(upper)) return;
        open_.push_back({upper, std::move(part)});
        std::push_heap(open_.begin(), open_.end());
    }

    Candidate taken() {
        std::pop_heap(open_.begin(), open_.end());
        Candidate first = std::move(open_.back());
        open_.pop_back();
        return first;
    }

    void split(const PlacedPart& placed) {
        const Part& part = model_.parts[model_.instances[placed.instance].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            add(heights_[placed.instance].most(hulls_.faces[f]), PlacedFace{placed.instance, f});
    }

    void split(const PlacedFace& placed) {
        const Face& face = model_.faces[placed.face];
        for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
            add(highest_control_point(model_.patch(p), heights_[placed.instance]),
                PlacedPatch{placed, p});
    }

    /// Splits a placed patch into the parts that its highest place may be on.
    void split(const PlacedPatch& placed) {
        const FaceTrims& trims = trims_of(placed.face.face);
        const auto patch = std::make_shared<const PatchMaterial>(model_, placed.patch, trims.region,
                                                                 heights_[placed.face.instance]);
        const TrimSide side = patch->classify(unit_square);
        if (side == TrimSide::outside) return;
        const bool inside = side == TrimSide::inside;
        const PatchHeight& whole = patch->whole();
        add_surface({patch, whole, inside});
        for (const Box2& line : {Box2{{0, 0}, {0, 1}}, Box2{{1, 0}, {1, 1}}, Box2{{0, 0}, {1, 0}},
                                 Box2{{0, 1}, {1, 1}}})
            add_surface({patch, whole.over(line), inside});
        if (inside) return;
        for (const CurveStretch& stretch : trims.border) add_curve(patch, stretch);
    }

    void add_surface(SurfacePart part) {
        if (!is_higher(part.height.upper())) return;
        const Box2& uv = part.height.uv();
        if (!part.inside) {
            const TrimSide side = part.patch->classify(uv);
            if (side == TrimSide::outside) return;
            part.inside = side == TrimSide::inside;
        }
        const std::array<double, 4> heights = part.height.corners();
        const std::array<Vec2, 4> corners{uv.lower, Vec2(uv.upper.x, uv.lower.y),
                                          Vec2(uv.lower.x, uv.upper.y), uv.upper};
        for (std::size_t k = 0; k < 4; ++k)
            if (heights[k] > best_ && (part.inside || part.patch->contains(corners[k])))
                best_ = heights[k];
        const double upper = part.height.upper(); // read before the part is moved
        add(upper, std::move(part));
    }

    void split(const SurfacePart& part) {
        // A box of this width, in patch parameters, is not cut: the curves that trim it are
        // searched by themselves.
        constexpr double narrowest = 1e-12;
        if (!part.height.may_be_level()) return;
        const bool by_u = part.height.varies_by_u();
        const Vec2 extent = part.height.uv().extent();
        if (!(extent[by_u ? 0 : 1] > narrowest)) return;
        ++cuts_;
        for (PatchHeight& half : part.height.halves(by_u))
            add_surface({part.patch, std::move(half), part.inside});
    }

    void add_curve(const std::shared_ptr<const PatchMaterial>& patch, CurveStretch stretch) {
        const auto overlap = patch->overlap(stretch);
        if (!overlap || !is_higher(patch->whole().over(overlap->uv).upper())) return;
        // A curve that leaves the patch is cut at once, until its parts are this share of it:
        // places on the patch must be known before boxes that the curve touches are cut.
        constexpr double shortest_cut = 1e-4;
        if (!overlap->whole && stretch.share() > shortest_cut) {
            for (CurveStretch& half : stretch.halves()) add_curve(patch, std::move(half));
            return;
        }
        // Material need not lie straight beside the ends, which may be corners.
        constexpr double near_end = 1e-6;
        try_place(*patch, stretch, stretch.first(), near_end);
        try_place(*patch, stretch, stretch.at(0.5)[0], 0.5);
        try_place(*patch, stretch, stretch.last(), 1 - near_end);
        const PatchMaterial::CurveBound bound = patch->bound(stretch, *overlap);
        add(bound.upper, CurvePart{patch, std::move(stretch), bound.monotone});
    }

    /// `beside`: the parameter of the stretch at which material must lie beside it.
    void try_place(const PatchMaterial& patch, const CurveStretch& stretch, const Vec2& place,
                   double beside) {
        const std::optional<double> height = patch.height_at(place);
        if (height && *height > best_ && beside_material(patch.trims(), stretch, beside))
            best_ = *height;
    }

    void split(const CurvePart& part) {
        // A stretch this short, as a share of its curve, is dropped if no material lies beside it.
        constexpr double finest = 1e-3, narrowest = 1e-12;
        const double share = part.stretch.share();
        if (part.monotone || share < narrowest) return;
        if (share < finest && !beside_material(part.patch->trims(), part.stretch, 0.5)) return;
        ++cuts_;
        for (CurveStretch& half : part.stretch.halves()) add_curve(part.patch, std::move(half));
    }

    const FaceTrims& trims_of(std::uint32_t face) {
        const Face& own = model_.faces[face];
        const auto found = trims_.find(face);
        if (found != trims_.end()) return found->second;
        return trims_.emplace(face, FaceTrims{{model_, own}, border_of(model_, own)}).first->second;
    }

    const SurfaceModel& model_;
    const HullBoxes& hulls_;
    SearchLimits limits_;
    std::vector<Height> heights_;              ///< by instance, part coordinates
    std::map<std::uint32_t, FaceTrims> trims_; ///< of faces met so far
    std::vector<Candidate> open_;              ///< a heap
    double best_ = -Box3::infinity;            ///< height of a place of the material
    std::size_t cuts_ = 0;
};

} // namespace

double highest_place(const SurfaceModel& model, const HullBoxes& hulls, const Vec3& direction,
                     const SearchLimits& limits, const Job& job) {
    return HighestPlace(model, hulls, direction, limits).run(job);
}

} // namespace keiko
