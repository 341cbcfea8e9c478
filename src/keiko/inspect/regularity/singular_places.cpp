#include "keiko/inspect/regularity/singular_places.h"

#include "keiko/base/job.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/face_box.h"
#include "keiko/inspect/regularity/normal_break.h"
#include "keiko/inspect/regularity/normal_patch.h"

#include <algorithm>
#include <deque>
#include <span>

namespace keiko {
namespace {

constexpr double most_weight_ratio = 1e4;
/// Largest ratio of a trim curve. A step of its parameter by the rounding of 1 then goes up to
/// 1e-10 of its length.
constexpr double most_border_ratio = 1e6;

/// Largest weight over the smallest; `weight` is that coordinate of a homogeneous point.
template <class Point>
double weight_ratio(std::span<const Point> points, double Point::*weight) {
    const auto [least, most] = std::minmax_element(
        points.begin(), points.end(),
        [weight](const Point& a, const Point& b) { return a.*weight < b.*weight; });
    return (*most).*weight / (*least).*weight;
}

bool has_uneven_border(const SurfaceModel& model, const Face& face) {
    for (const TrimLoop& loop : model.loops_of(face))
        for (std::uint32_t c = 0; c < loop.curve_count; ++c)
            if (weight_ratio(model.trim_curve(loop.first_curve + c).points, &Vec3::z) >
                most_border_ratio)
                return true;
    return false;
}

/// The places of one kind, and their box.
struct Cluster {
    SingularPlace place;
    Box3 places;
};

class SingularSearch {
public:
    SingularSearch(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                   const SingularLimits& limits)
        : model_(model), face_(model.faces[face]), limits_(limits) {
        Box3 bounds;
        for (std::uint32_t i = 0; i < face_.patch_count; ++i) {
            patches_.emplace_back(model, face_.first_patch + i, model.instances[instance].transform,
                                  limits.negligible);
            bounds.extend(patches_.back().box());
            if (weight_ratio(model.patch(face_.first_patch + i).points, &Vec4::w) >
                most_weight_ratio)
                add({SingularPlace::Kind::uneven, 0, 0, patches_.back().box().center()});
        }
        if (has_uneven_border(model, face_))
            add({SingularPlace::Kind::uneven_border, 0, 0, bounds.center()});
        coarse_ = std::max(limits.negligible, bounds.size() / 32);
    }

    std::vector<SingularPlace> run(std::size_t cuts) {
        for (const NormalPatch& patch : patches_) queue_.push_back({&patch, NormalCell(patch), 0});
        for (; !queue_.empty(); queue_.pop_front()) {
            check_stop();
            const Part& part = queue_.front();
            // Most parts are regular after few cuts, before trims matter.
            constexpr int soon = 6;
            if (part.cell.is_regular() || ((part.depth >= soon || cuts == 0) && is_outside(part)) ||
                is_judged(part))
                continue;
            if (cuts == 0) {
                add_unresolved(part);
                continue;
            }
            --cuts;
            cut(part);
        }
        return places();
    }

private:
    struct Part {
        const NormalPatch* patch;
        NormalCell cell;
        int depth;
    };

    void cut(const Part& part) {
        const bool turned = part.cell.turned_corners().has_value() && part.depth > 8;
        for (NormalCell& half : part.cell.halves(turned, limits_.negligible))
            queue_.push_back({part.patch, std::move(half), part.depth + 1});
    }

    const TrimRegion& trims() {
        if (!trims_) trims_.emplace(model_, face_);
        return *trims_;
    }

    bool is_outside(const Part& part) {
        if (face_.loop_count == 0) return false;
        const Box2 box = face_box(model_, part.patch->index(), part.cell.uv());
        return trims().classify(box) == TrimSide::outside;
    }

    IsMaterial material_of(const NormalPatch& patch) {
        if (face_.loop_count == 0) return [](const Vec2&) { return true; };
        return [&region = trims(), &patch, this](const Vec2& uv) {
            return region.contains(model_.face_parameters(patch.index(), uv));
        };
    }

    /// True if further cuts of a part would find nothing.
    bool is_judged(const Part& part) {
        const double size = part.cell.size();
        if (size > coarse_) return false;
        const double near = limits_.negligible;
        const NormalPatch& patch = *part.patch;
        const Box2& uv = part.cell.uv();
        if (size > near) {
            const auto corners = part.cell.turned_corners();
            if (!corners) return false;
            const auto over = turn_between(patch, *corners, uv, near, material_of(patch));
            if (!over) return false;
            // At a point that is a side, borders in files cross by what their digits leave.
            const bool folds = over->turns_over && (over->wide || patch.tips().empty());
            if (folds || !patch.is_at_tip(over->place)) add(*over, folds);
            return over->turns_over;
        }
        if (patch.is_at_tip(patch.position(uv.center()))) return true;
        const auto found = break_about(patch, uv, near, material_of(patch));
        if (found && found->angle > limits_.angle) add(*found, found->turns_over);
        return true;
    }

    void add(const NormalBreak& found, bool folds) {
        using Kind = SingularPlace::Kind;
        add({folds ? Kind::fold : Kind::no_limit, found.angle, 0, found.place});
    }

    void add_unresolved(const Part& part) {
        add({SingularPlace::Kind::unresolved, 0, 0, part.patch->position(part.cell.uv().center())});
    }

    void add(const SingularPlace& place) {
        const auto same = [&](const Cluster& other) { return other.place.kind == place.kind; };
        auto all = std::find_if(clusters_.begin(), clusters_.end(), same);
        if (all == clusters_.end()) all = clusters_.insert(all, {place, {}});
        if (place.angle > all->place.angle) all->place = place;
        all->places.extend(place.place);
        all->place.extent = all->places.size();
    }

    std::vector<SingularPlace> places() const {
        std::vector<SingularPlace> result;
        for (const Cluster& cluster : clusters_) result.push_back(cluster.place);
        std::stable_sort(
            result.begin(), result.end(),
            [](const SingularPlace& a, const SingularPlace& b) { return a.angle > b.angle; });
        return result;
    }

    const SurfaceModel& model_;
    const Face& face_;
    SingularLimits limits_;
    double coarse_ = 0; ///< mm: a fold is followed in parts of that size
    std::deque<NormalPatch> patches_;
    std::deque<Part> queue_;
    std::optional<TrimRegion> trims_;
    std::vector<Cluster> clusters_;
};

} // namespace

Verdict verdict_of(SingularPlace::Kind kind) {
    using Kind = SingularPlace::Kind;
    if (kind == Kind::fold) return Verdict::fail;
    return kind == Kind::no_limit ? Verdict::pass : Verdict::undecided;
}

std::vector<SingularPlace> singular_places(const SurfaceModel& model, std::uint32_t instance,
                                           std::uint32_t face, const SingularLimits& limits,
                                           std::size_t most_cuts) {
    return SingularSearch(model, instance, face, limits).run(most_cuts);
}

} // namespace keiko
