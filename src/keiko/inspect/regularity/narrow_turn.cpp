#include "keiko/inspect/regularity/narrow_turn.h"

#include "keiko/base/job.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/face_box.h"
#include "keiko/inspect/regularity/normal_patch.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>
#include <vector>

namespace keiko {
namespace {

/// Radians about their mean: where all normals are as close, a part has no turn to look for.
constexpr double narrow_cone = 0.25;
/// Share of the negligible length below which a part is not cut further.
constexpr double finest = 1.0 / 16;

class TurnSearch {
public:
    TurnSearch(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
               double negligible)
        : model_(model), face_(model.faces[face]), trims_(model, face_), negligible_(negligible) {
        for (std::uint32_t i = 0; i < face_.patch_count; ++i) {
            patches_.emplace_back(model, face_.first_patch + i, model.instances[instance].transform,
                                  negligible);
            add({&patches_.back(), NormalCell(patches_.back())});
        }
    }

    /// Cuts the parts first whose normals may turn most in a mm.
    std::optional<NarrowTurn> run(std::size_t cuts) {
        for (; !queue_.empty() && cuts > 0 && !is_finest(); --cuts) {
            check_stop();
            std::pop_heap(queue_.begin(), queue_.end());
            const Part part = std::move(queue_.back());
            queue_.pop_back();
            for (NormalCell& half : part.cell.halves(false, finest * negligible_))
                add({part.patch, std::move(half)});
        }
        return narrowest_;
    }

private:
    struct Part {
        const NormalPatch* patch;
        NormalCell cell;
        double turn = 0; ///< 1/mm: of its normals, at most

        bool operator<(const Part& other) const { return turn < other.turn; }
    };

    bool is_finest() const { return narrowest_ && narrowest_->radius < finest * negligible_; }

    /// Keeps a part to be cut, or measures what is turned little or is small enough.
    void add(Part part) {
        if (is_at_tip(part) || is_outside(part)) return;
        const double cone = part.cell.cone(), size = part.cell.size();
        if (cone < narrow_cone || size <= finest * negligible_) return measure(part);
        part.turn = cone / size;
        queue_.push_back(std::move(part));
        std::push_heap(queue_.begin(), queue_.end());
    }

    Vec2 on_face(const Part& part, const Vec2& uv) const {
        return model_.face_parameters(part.patch->index(), uv);
    }

    bool is_outside(const Part& part) const {
        if (trims_.untrimmed()) return false;
        const Box2 box = face_box(model_, part.patch->index(), part.cell.uv());
        return trims_.classify(box) == TrimSide::outside;
    }

    bool is_at_tip(const Part& part) const {
        return part.cell.size() <= negligible_ &&
               part.patch->is_at_tip(part.patch->position(part.cell.uv().center()));
    }

    bool is_material(const Part& part, const Vec2& uv) const {
        return trims_.untrimmed() || trims_.contains(on_face(part, uv));
    }

    /// Takes the narrowest turn about the middle of a part: along either parameter, and across it.
    void measure(const Part& part) {
        const Vec2 middle = part.cell.uv().center(), half = part.cell.uv().extent() / 2;
        for (const Vec2& step : {Vec2(half.x, 0), Vec2(0, half.y), across(part)}) {
            constexpr int most_doublings = 20;
            double reach = 1;
            for (int i = 0; i < most_doublings; ++i, reach *= 2)
                if (!measure(part, unit_square.nearest(middle - step * reach),
                             unit_square.nearest(middle + step * reach)))
                    break;
        }
    }

    /// The step in the parameters that leads from the middle of a part square to its longer side as
    /// far as the part goes: where tangents are nearly parallel it is narrow there.
    static Vec2 across(const Part& part) {
        const Vec2 extent = part.cell.uv().extent();
        const SurfaceDerivatives s = evaluate(part.patch->view(), part.cell.uv().center(), 1);
        const Vec3 u = s.du() * extent.x, v = s.dv() * extent.y, area = u.cross(v);
        const Vec3& longer = u.length2() > v.length2() ? u : v;
        if (!(area.length2() > 0)) return Vec2(0);
        const Vec3 way = area.cross(longer) / (2 * longer.length2());
        return Vec2(way.cross(v).dot(area), u.cross(way).dot(area)) / area.length2() * extent;
    }

    /// Takes the turn between two places if it is the narrowest; false if they are farther apart
    /// than what is negligible, or not on the material.
    bool measure(const Part& part, const Vec2& from, const Vec2& to) {
        const Vec3 begin = part.patch->position(from), way = part.patch->position(to) - begin;
        if (!(way.length() <= negligible_) || !is_material(part, from) || !is_material(part, to))
            return false;
        const auto before = part.patch->normal(from), after = part.patch->normal(to);
        const double turn = before && after ? angle_between(*before, *after) : 0;
        if (turn < narrow_cone) return true;
        const double radius = way.length() / (2 * std::sin(turn / 2));
        if (radius < (narrowest_ ? narrowest_->radius : negligible_))
            narrowest_ = {radius, begin + way / 2};
        return true;
    }

    const SurfaceModel& model_;
    const Face& face_;
    TrimRegion trims_;
    double negligible_;
    std::deque<NormalPatch> patches_;
    std::vector<Part> queue_; ///< a heap
    std::optional<NarrowTurn> narrowest_;
};

} // namespace

std::optional<NarrowTurn> narrow_turn(const SurfaceModel& model, std::uint32_t instance,
                                      std::uint32_t face, double negligible,
                                      std::size_t most_cuts) {
    return TurnSearch(model, instance, face, negligible).run(most_cuts);
}

} // namespace keiko
