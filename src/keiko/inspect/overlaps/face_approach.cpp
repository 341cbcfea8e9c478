#include "keiko/inspect/overlaps/face_approach.h"

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/geometry/seam/border_run.h"
#include "keiko/inspect/overlaps/face_inside.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// Bounds of the points within a distance of a piece of surface: its box, and, if it has a mean
/// normal, two planes square to that.
class PieceSlab {
public:
    /// `reach` in mm.
    PieceSlab(const BezierPatchView& piece, double reach);

    /// mm: the diagonal of the piece's box.
    double size() const { return size_; }
    /// mm between the planes that hold the piece; its size if it has no mean normal.
    double thickness() const { return thickness_; }
    /// The axis along which the piece is longer, 0 or 1.
    unsigned longer_side() const { return longer_side_; }
    /// The part of a segment, from 0 to 1, that is within the slab; nullopt if there is none.
    std::optional<ParameterInterval> clip(const Vec3& from, const Vec3& to) const;

private:
    Box3 box_;
    Vec3 normal_{0};
    double low_ = 0, high_ = 0; ///< along the normal
    double size_ = 0, thickness_ = 0;
    unsigned longer_side_ = 0;
};

/// Restricts an interval of s to low <= from + s * slope <= high.
void cut(ParameterInterval& part, double from, double slope, double low, double high) {
    if (slope == 0) {
        if (!(low <= from && from <= high)) part = {1, 0};
        return;
    }
    const auto [begin, end] = std::minmax({(low - from) / slope, (high - from) / slope});
    part.begin = std::max(part.begin, begin), part.end = std::min(part.end, end);
}

PieceSlab::PieceSlab(const BezierPatchView& piece, double reach) {
    const Vec3 a = euclidean(piece.point(0, 0)), b = euclidean(piece.point(piece.degree_u, 0));
    const Vec3 c = euclidean(piece.point(0, piece.degree_v));
    const Vec3 d = euclidean(piece.point(piece.degree_u, piece.degree_v));
    longer_side_ =
        (b - a).length() + (d - c).length() >= (c - a).length() + (d - b).length() ? 0 : 1;
    const Box3 hull = hull_bounds(piece);
    size_ = thickness_ = hull.size();
    box_ = hull.padded(reach);
    const Vec3 across = (d - a).cross(c - b);
    if (!(across.length() > 0)) return;
    normal_ = across / across.length();
    low_ = high_ = normal_.dot(a);
    for (const Vec4& point : piece.points) {
        const double height = normal_.dot(euclidean(point));
        low_ = std::min(low_, height), high_ = std::max(high_, height);
    }
    thickness_ = high_ - low_;
    low_ -= reach, high_ += reach;
}

std::optional<ParameterInterval> PieceSlab::clip(const Vec3& from, const Vec3& to) const {
    const Vec3 way = to - from;
    ParameterInterval part{0, 1};
    for (unsigned k = 0; k < 3; ++k) cut(part, from[k], way[k], box_.lower[k], box_.upper[k]);
    if (normal_ != Vec3(0)) cut(part, normal_.dot(from), normal_.dot(way), low_, high_);
    return part.begin <= part.end ? std::optional(part) : std::nullopt;
}

class FaceSearch {
public:
    FaceSearch(const SurfaceModel& model, const PlacedFace& face, const FreeEdgeSamples& samples,
               double join)
        : model_(model),
          own_(face),
          face_(model.faces[face.face]),
          placed_(model.instances[face.instance].transform),
          samples_(samples),
          join_(join),
          inside_(model, face_, join) {}

    std::vector<FaceApproach> run() {
        for (std::uint32_t i = 0; i < face_.patch_count; ++i) search_patch(face_.first_patch + i);
        return nearest_inside();
    }

private:
    using Chords = std::vector<std::uint32_t>;

    struct Candidate {
        FaceApproach approach;
        bool inside = false;
    };

    void search_patch(std::uint32_t patch) {
        points_.clear();
        for (const Vec4& p : model_.patch(patch).points) points_.push_back(placed_.homogeneous(p));
        const BezierPatchView original = model_.patch(patch);
        patch_ = patch, view_ = {original.degree_u, original.degree_v, points_};
        Chords chords = samples_.chords_in(hull_bounds(view_).padded(join_));
        const auto is_own = [&](std::uint32_t chord) {
            return samples_.edges().all[samples_.chord(chord).edge].face() == own_;
        };
        chords.erase(std::remove_if(chords.begin(), chords.end(), is_own), chords.end());
        if (!chords.empty()) search(unit_square, chords, 0);
    }

    /// Searches the piece over `box` of the patch for the chords that come near it.
    void search(const Box2& box, const Chords& among, int depth) {
        const std::vector<Vec4> points = subpatch(view_, box);
        const BezierPatchView piece{view_.degree_u, view_.degree_v, points};
        const PieceSlab slab(piece, join_);
        Chords near;
        for (const std::uint32_t c : among)
            if (slab.clip(samples_.chord(c).from, samples_.chord(c).to)) near.push_back(c);
        if (near.empty()) return;
        const TrimSide side = inside_.side(patch_, box);
        if (side == TrimSide::outside) return;
        constexpr int most_depth = 40;
        const bool flat = slab.thickness() <= join_ / 2;
        const bool small = slab.size() <= 16 * join_;
        if ((flat && (small || side == TrimSide::inside)) || slab.size() <= join_ ||
            depth == most_depth) {
            for (const std::uint32_t c : near) measure(box, piece, slab, samples_.chord(c));
            return;
        }
        const unsigned axis = slab.longer_side();
        for (const bool upper : {false, true}) {
            Box2 half = box;
            (upper ? half.lower : half.upper)[axis] = box.center()[axis];
            search(half, near, depth + 1);
        }
    }

    void measure(const Box2& box, const BezierPatchView& piece, const PieceSlab& slab,
                 const FreeEdgeSamples::Chord& chord) {
        const ParameterInterval part = *slab.clip(chord.from, chord.to);
        const auto first = static_cast<std::uint32_t>(std::ceil(part.begin * chord.steps));
        const auto last = static_cast<std::uint32_t>(std::floor(part.end * chord.steps));
        for (std::uint32_t step = first; step <= last; ++step) {
            const PieceProjection foot = piece_projection(piece, chord.at(step));
            if (foot.distance > join_) continue;
            const Vec2 uv = box.lower + box.extent() * foot.uv;
            const SurfaceDerivatives s = evaluate(view_, uv, 2);
            const auto normal = unit_normal(s, uv);
            if (!normal) continue;
            const Vec3 off = chord.at(step) - foot.position;
            const Vec3 way = chord.to - chord.from;
            const double sine = std::abs(way.dot(*normal)) / std::max(way.length(), 1e-300);
            const double offset = std::copysign(foot.distance, off.dot(*normal));
            found_.push_back({{chord.first + step, offset, foot.position, *normal,
                               sine <= std::sin(parallel_borders)},
                              inside_.is_inside(patch_, uv, s)});
        }
    }

    /// The nearest candidate of each sample, if it is inside.
    std::vector<FaceApproach> nearest_inside() {
        std::stable_sort(found_.begin(), found_.end(), [](const Candidate& a, const Candidate& b) {
            const FaceApproach &x = a.approach, &y = b.approach;
            return x.sample != y.sample ? x.sample < y.sample
                                        : std::abs(x.offset) < std::abs(y.offset);
        });
        std::vector<FaceApproach> nearest;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            const FaceApproach& approach = found_[i].approach;
            if (i > 0 && found_[i - 1].approach.sample == approach.sample) continue;
            if (found_[i].inside) nearest.push_back(approach);
        }
        return nearest;
    }

    const SurfaceModel& model_;
    PlacedFace own_;
    const Face& face_;
    const Affine& placed_;
    const FreeEdgeSamples& samples_;
    double join_;
    FaceInside inside_;
    std::uint32_t patch_ = 0;
    std::vector<Vec4> points_; ///< of the patch, world
    BezierPatchView view_;
    std::vector<Candidate> found_;
};

} // namespace

std::vector<FaceApproach> approaches_to(const SurfaceModel& model, const PlacedFace& face,
                                        const FreeEdgeSamples& samples, double join) {
    return FaceSearch(model, face, samples, join).run();
}

} // namespace keiko
