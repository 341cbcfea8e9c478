#include "keiko/trace/leaf.h"

#include "keiko/trace/leaf_polynomial.h"
#include "keiko/trace/subpatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Halvings along one parameter: a bent piece gets flat by them, a twisted one (a pole) never
/// does, and each try costs boxes.
constexpr int most_halvings = 4, most_halvings_of_twist = 2;
/// Of a leaf's width: neighbours overlap by this much, so that no ray slips through between them.
constexpr double overlap = 1e-11;
/// A leaf so small beside its coordinates' rounding errors is a point; it gets no wider overlap.
constexpr double widest_overlap = 1e-6;

/// Of a patch: a trim curve this close to its end is taken to run along it.
constexpr double border_width = 1e-10;

Box2 face_box(const Patch& patch, const Box2& uv) {
    Box2 box;
    box.extend(Vec2(patch.map_u.to_face(uv.lower.x), patch.map_v.to_face(uv.lower.y)));
    box.extend(Vec2(patch.map_u.to_face(uv.upper.x), patch.map_v.to_face(uv.upper.y)));
    return box;
}

/// Bounds, in parameters of the leaf, of how far apart along u and along v two places may be that
/// are `distance` mm apart by the tangents anywhere on the leaf.
Vec2 farthest_apart(const LeafFrame& f, double distance) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!f.regular) return Vec2(infinity);
    const auto bound = [&](const ComponentBounds& own, const Vec3& row) {
        // X = (x + e) / w, so X_x = (1 + e_x - X w_x) / w.
        const double farthest = (1 + own.value) / (1 - f.w.value);
        const double least = (1 - own.slope - farthest * f.w.slope) / (1 + f.w.value);
        const bool known = f.w.value < 1 && least > 0;
        return known ? 0.5 * distance * row.length() / least * (1 + 1e-9) : infinity;
    };
    return {bound(f.u, f.rows[0]), bound(f.v, f.rows[1])};
}

struct WeightRange {
    double least, largest;
};

WeightRange weight_range(const std::vector<Vec4>& points) {
    const auto [least, largest] = std::minmax_element(
        points.begin(), points.end(), [](const Vec4& a, const Vec4& b) { return a.w < b.w; });
    return {least->w, largest->w};
}

/// Splits one patch; the points are taken relative to `origin_`, the patch's own centre, before
/// anything is computed with them.
class PatchSplitter {
public:
    PatchSplitter(const SurfaceModel& model, std::uint32_t patch, const TrimRegion& region,
                  const Box2& face_domain, double reach, double flat_enough)
        : patch_(model.patches[patch]),
          index_(patch),
          region_(region),
          original_(model.patch(patch)),
          reach_in_mm_(reach),
          flat_enough_(flat_enough),
          origin_(hull_bounds(original_).center()) {
        for (const Vec4& p : original_.points) {
            const Vec3 moved = Vec3(p.x, p.y, p.z) - origin_ * p.w;
            points_.emplace_back(moved.x, moved.y, moved.z, p.w);
        }
        local_ = {original_.degree_u, original_.degree_v, points_};
        size_ = hull_bounds(local_).size();
        weights_ = weight_range(points_);
        if (!region.untrimmed()) find_reach(face_domain, reach);
    }

    LeafSet run() {
        const std::optional<Box2> start = material_box();
        if (start) split(*start, 0, 0);
        if (!start) ++set_.trimmed_away;
        return std::move(set_);
    }

private:
    /// `reach` mm in patch parameters, and on which sides the patch may be continued by it.
    void find_reach(const Box2& face_domain, double reach) {
        const LeafFrame f = leaf_frame(local_);
        // Where lines run together at a pole, mm say little about parameters; a seam's reach is
        // not worth more than a share of the patch anyhow.
        constexpr double widest = 0.01;
        reach_.x = std::min(widest, reach / std::max(f.length.x, epsilon * size_));
        reach_.y = std::min(widest, reach / std::max(f.length.y, epsilon * size_));
        const Box2 own = face_box(patch_, unit_square);
        for (unsigned k = 0; k < 2; ++k) {
            const ParameterMap& map = k == 0 ? patch_.map_u : patch_.map_v;
            bool first = own.lower[k] <= face_domain.lower[k];
            bool last = own.upper[k] >= face_domain.upper[k];
            if (map.begin > map.end) std::swap(first, last);
            beyond_.lower[k] = first ? reach_[k] : 0;
            beyond_.upper[k] = last ? reach_[k] : 0;
        }
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
        const std::vector<Vec4> points = subpatch(local_, box);
        const LeafFrame f = leaf_frame({local_.degree_u, local_.degree_v, points});
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

    void emit(const Box2& share, TrimSide side, const LeafFrame& f) {
        Leaf leaf;
        leaf.patch = index_;
        leaf.degree_u = static_cast<std::uint16_t>(local_.degree_u);
        leaf.degree_v = static_cast<std::uint16_t>(local_.degree_v);
        leaf.near_border = side == TrimSide::mixed;
        leaf.trim = leaf.near_border && is_material(share) ? TrimSide::inside : side;
        leaf.first_point = static_cast<std::uint32_t>(set_.points.size());
        leaf.coefficient_error = rounding_error(1);
        const auto slip = [&](double length) {
            return std::min(widest_overlap, overlap + 16 * leaf.coefficient_error / length);
        };
        leaf.slip = share.extent() * Vec2(slip(f.length.x), slip(f.length.y));
        leaf.domain = {share.lower - leaf.slip, share.upper + leaf.slip};
        for (unsigned k = 0; k < 2; ++k) {
            if (share.lower[k] <= 0) leaf.domain.lower[k] -= beyond_.lower[k];
            if (share.upper[k] >= 1) leaf.domain.upper[k] += beyond_.upper[k];
        }
        place_points(leaf);
    }

    void place_points(Leaf& leaf) {
        std::vector<Vec4> points = subpatch(local_, leaf.domain);
        if (!weights_hold(points)) {
            // Past the patch's end the weights run down to zero: there is no surface to go on with.
            leaf.domain = leaf.domain.intersection({Vec2(0) - leaf.slip, Vec2(1) + leaf.slip});
            points = subpatch(local_, leaf.domain);
        }
        leaf.coefficient_error = rounding_error(growth(leaf.domain, weight_range(points).least));
        const Vec3 middle = hull_bounds({local_.degree_u, local_.degree_v, points}).center();
        leaf.center = origin_ + middle;
        leaf.weight = 0;
        for (Vec4& p : points) {
            const Vec3 moved = Vec3(p.x, p.y, p.z) - middle * p.w;
            leaf.radius = std::max(leaf.radius, moved.length() / p.w);
            leaf.weight = std::max(leaf.weight, p.w);
            p = {moved.x, moved.y, moved.z, p.w};
        }
        add_frame(leaf, {local_.degree_u, local_.degree_v, points});
        set_.points.insert(set_.points.end(), points.begin(), points.end());
        set_.leaves.push_back(leaf);
    }

    /// False where going on past the patch has made a weight far smaller than any on it.
    bool weights_hold(const std::vector<Vec4>& points) const {
        return weight_range(points).least > weights_.least / 2;
    }

    /// mm: bound of what the roundings of making a leaf move a control point by. Each of the
    /// 2 (degree_u + degree_v) blends that make it costs 3 unit roundoffs of w (P - origin) and as
    /// much of w; `growth` as below. The rest is taking off the centres.
    double rounding_error(double growth) const {
        const double blends = 6.0 * (local_.degree_u + local_.degree_v);
        return epsilon * (8 * origin_.length() + (blends * growth + 8) * size_ / 2);
    }

    /// How much larger than the leaf's own weight the sum of the |terms| of a weight may be: 1
    /// where each blend is an average, more where the leaf goes on past the patch.
    double growth(const Box2& domain, double least) const {
        double beyond = 0;
        for (unsigned k = 0; k < 2; ++k)
            beyond = std::max({beyond, -domain.lower[k], domain.upper[k] - 1});
        const double terms = std::pow(1 + 2 * beyond, 2 * (local_.degree_u + local_.degree_v));
        return 1 + (terms - 1) * weights_.largest / least;
    }

    void add_frame(Leaf& leaf, const BezierPatchView& points) {
        const LeafFrame frame = leaf_frame(points);
        leaf.seam_reach = leaf.domain.extent() * farthest_apart(frame, reach_in_mm_);
        LeafPolynomial polynomial;
        polynomial.coefficients.resize(points.points.size());
        if (frame.regular) polynomial = leaf_polynomial(points, frame);
        set_.frames.push_back(frame);
        set_.roundings.push_back(polynomial.rounding);
        set_.polynomials.insert(set_.polynomials.end(), polynomial.coefficients.begin(),
                                polynomial.coefficients.end());
    }

    const Patch& patch_;
    std::uint32_t index_;
    const TrimRegion& region_;
    BezierPatchView original_;
    double reach_in_mm_, flat_enough_;
    Vec3 origin_;
    std::vector<Vec4> points_;
    BezierPatchView local_;
    double size_ = 0;
    WeightRange weights_{1, 1};
    Vec2 reach_{0};                 ///< in patch parameters
    Box2 beyond_{Vec2(0), Vec2(0)}; ///< by how much the domain goes on past 0 and past 1
    LeafSet set_;
};

} // namespace

BezierPatchView LeafSet::view(const Leaf& leaf) const {
    const std::size_t count = (leaf.degree_u + std::size_t{1}) * (leaf.degree_v + std::size_t{1});
    return {leaf.degree_u, leaf.degree_v, std::span(points).subspan(leaf.first_point, count)};
}

void append(LeafSet& all, LeafSet more) {
    const auto offset = static_cast<std::uint32_t>(all.points.size());
    for (Leaf& leaf : more.leaves) {
        leaf.first_point += offset;
        all.leaves.push_back(leaf);
    }
    all.points.insert(all.points.end(), more.points.begin(), more.points.end());
    all.frames.insert(all.frames.end(), more.frames.begin(), more.frames.end());
    all.polynomials.insert(all.polynomials.end(), more.polynomials.begin(), more.polynomials.end());
    all.roundings.insert(all.roundings.end(), more.roundings.begin(), more.roundings.end());
    all.trimmed_away += more.trimmed_away;
}

LeafSet make_leaves(const SurfaceModel& model, const Face& face, const TrimRegion& region,
                    double reach, double flat_enough) {
    Box2 domain;
    for (const Patch& patch : model.patches_of(face)) domain.extend(face_box(patch, unit_square));
    LeafSet all;
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
        append(all, PatchSplitter(model, p, region, domain, reach, flat_enough).run());
    return all;
}

} // namespace keiko
