#include "keiko/intersect/subpatch/sub_patch.h"

#include "keiko/geometry/bezier/subpatch.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace keiko {
namespace {

/// Halvings along one parameter: a bent piece gets flat by them, a twisted one (a pole) never
/// does, and each try costs boxes.
constexpr int most_halvings = 4, most_halvings_of_twist = 2;

/// Share of a patch: a trim curve this close to its end is taken to run along it.
constexpr double border_width = 1e-10;

Box2 face_box(const Patch& patch, const Box2& uv) {
    Box2 box;
    box.extend(Vec2(patch.map_u.to_face(uv.lower.x), patch.map_v.to_face(uv.lower.y)));
    box.extend(Vec2(patch.map_u.to_face(uv.upper.x), patch.map_v.to_face(uv.upper.y)));
    return box;
}

/// Splits one patch of a face.
class PatchSplitter {
public:
    PatchSplitter(const SurfaceModel& model, std::uint32_t patch, const TrimRegion& region,
                  const Box2& face_domain, double reach, double flat_enough)
        : patch_(model.patches[patch]),
          region_(region),
          maker_(model.patch(patch), patch, reach),
          flat_enough_(flat_enough) {
        if (!region.untrimmed()) find_reach(face_domain, reach);
    }

    SubPatchSet run() {
        const std::optional<Box2> start =
            maker_.has_area() ? material_box() : std::optional<Box2>();
        if (start) split(*start, 0, 0);
        if (!start) ++set_.trimmed_away;
        return std::move(set_);
    }

private:
    /// `reach` mm in patch parameters, and on which sides the patch may be continued by it.
    void find_reach(const Box2& face_domain, double reach) {
        const SubPatchFrame f = sub_patch_frame(maker_.patch());
        // Where lines run together at a pole, mm say little about parameters; a seam's reach is
        // not worth more than a share of the patch anyhow.
        constexpr double widest = 0.01, epsilon = std::numeric_limits<double>::epsilon();
        reach_.x = std::min(widest, reach / std::max(f.length.x, epsilon * maker_.size()));
        reach_.y = std::min(widest, reach / std::max(f.length.y, epsilon * maker_.size()));
        const Box2 own = face_box(patch_, unit_square);
        Box2 beyond{Vec2(0), Vec2(0)};
        for (unsigned k = 0; k < 2; ++k) {
            const ParameterMap& map = k == 0 ? patch_.map_u : patch_.map_v;
            bool first = own.lower[k] <= face_domain.lower[k];
            bool last = own.upper[k] >= face_domain.upper[k];
            if (map.begin > map.end) std::swap(first, last);
            beyond.lower[k] = first ? reach_[k] : 0;
            beyond.upper[k] = last ? reach_[k] : 0;
        }
        maker_.go_on_by(beyond);
    }

    /// The patch parameters that the trim curves leave, if any.
    std::optional<Box2> material_box() const {
        Box2 box = unit_square;
        if (region_.untrimmed()) return box;
        const Box2 own = face_box(patch_, box), trim = region_.bounds();
        for (unsigned k = 0; k < 2; ++k) {
            const ParameterMap& map = k == 0 ? patch_.map_u : patch_.map_v;
            const double margin = (own.upper[k] - own.lower[k]) * (reach_[k] + 1e-12);
            const double low = std::max(own.lower[k], trim.lower[k] - margin);
            const double high = std::min(own.upper[k], trim.upper[k] + margin);
            if (!(low <= high)) return std::nullopt;
            const auto [a, b] = std::minmax({map.to_patch(low), map.to_patch(high)});
            // Slices so thin are all border; cropping to them would gain nothing.
            if (b - a > 1e-6) box.lower[k] = a, box.upper[k] = b;
        }
        return box.intersection(unit_square);
    }

    void split(const Box2& box, int halved_u, int halved_v) {
        const TrimSide side = classify(box);
        if (side == TrimSide::outside) {
            ++set_.trimmed_away;
            return;
        }
        const std::vector<Vec4> points = subpatch(maker_.patch(), box);
        const SubPatchFrame f =
            sub_patch_frame({maker_.patch().degree_u, maker_.patch().degree_v, points});
        const bool twisted = f.twist > std::max(f.bend_u, f.bend_v);
        const bool along_u = twisted ? f.length.x >= f.length.y : f.bend_u >= f.bend_v;
        const int most = twisted ? most_halvings_of_twist : most_halvings;
        if (f.contraction() <= flat_enough_ || (along_u ? halved_u : halved_v) >= most) {
            emit(box, side, f);
            return;
        }
        Box2 low = box, high = box;
        const unsigned axis = along_u ? 0 : 1;
        low.upper[axis] = high.lower[axis] = box.center()[axis];
        split(low, halved_u + along_u, halved_v + !along_u);
        split(high, halved_u + along_u, halved_v + !along_u);
    }

    /// With all that the reach of a seam adds.
    TrimSide classify(const Box2& box) const {
        if (region_.untrimmed()) return TrimSide::inside;
        const Box2 grown = unit_square.intersection({box.lower - reach_, box.upper + reach_});
        Box2 in_face = face_box(patch_, grown);
        // Beyond the patch's own end there may be a border that the reach still touches.
        const Box2 own = face_box(patch_, unit_square);
        const Vec2 margin = own.extent() * (reach_ + Vec2(1e-12));
        in_face = {in_face.lower - margin, in_face.upper + margin};
        return region_.classify(in_face);
    }

    /// Trim curves mostly run along the patch's own ends, where hits are tested for being on the
    /// patch anyhow.
    bool is_material(const Box2& box) const {
        if (region_.untrimmed()) return true;
        const Box2 core = box.intersection(unit_square.padded(-border_width));
        return region_.classify(face_box(patch_, core)) == TrimSide::inside;
    }

    void emit(const Box2& box, TrimSide side, const SubPatchFrame& f) {
        const bool near_border = side == TrimSide::mixed;
        const TrimSide trim = near_border && is_material(box) ? TrimSide::inside : side;
        maker_.add({box, trim, near_border}, f, set_);
    }

    const Patch& patch_;
    const TrimRegion& region_;
    SubPatchMaker maker_;
    double flat_enough_;
    Vec2 reach_{0}; ///< in patch parameters
    SubPatchSet set_;
};

} // namespace

BezierPatchView SubPatchSet::view(const SubPatch& sub_patch) const {
    const std::size_t count =
        (sub_patch.degree_u + std::size_t{1}) * (sub_patch.degree_v + std::size_t{1});
    return {sub_patch.degree_u, sub_patch.degree_v,
            std::span(points).subspan(sub_patch.first_point, count)};
}

void append(SubPatchSet& all, SubPatchSet more) {
    const auto offset = static_cast<std::uint32_t>(all.points.size());
    for (SubPatch& sub_patch : more.sub_patches) {
        sub_patch.first_point += offset;
        all.sub_patches.push_back(sub_patch);
    }
    all.points.insert(all.points.end(), more.points.begin(), more.points.end());
    all.frames.insert(all.frames.end(), more.frames.begin(), more.frames.end());
    all.polynomials.insert(all.polynomials.end(), more.polynomials.begin(), more.polynomials.end());
    all.roundings.insert(all.roundings.end(), more.roundings.begin(), more.roundings.end());
    all.trimmed_away += more.trimmed_away;
}

SubPatchSet subdivide(const SurfaceModel& model, const Face& face, const TrimRegion& region,
                      double reach, double flat_enough) {
    Box2 domain;
    for (const Patch& patch : model.patches_of(face)) domain.extend(face_box(patch, unit_square));
    SubPatchSet all;
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
        append(all, PatchSplitter(model, p, region, domain, reach, flat_enough).run());
    return all;
}

} // namespace keiko
