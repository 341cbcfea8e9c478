#include "keiko/inspect/overlaps/face_approach.h"

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/geometry/seam/border_approach.h"
#include "keiko/inspect/overlaps/face_inside.h"
#include "keiko/inspect/overlaps/piece_slab.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

class FaceSearch {
public:
    FaceSearch(const SurfaceModel& model, const PlacedFace& face, const EdgeSamples& samples,
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
                 const EdgeSamples::Chord& chord) {
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
    const EdgeSamples& samples_;
    double join_;
    FaceInside inside_;
    std::uint32_t patch_ = 0;
    std::vector<Vec4> points_; ///< of the patch, world
    BezierPatchView view_;
    std::vector<Candidate> found_;
};

} // namespace

std::vector<FaceApproach> approaches_to(const SurfaceModel& model, const PlacedFace& face,
                                        const EdgeSamples& samples, double join) {
    return FaceSearch(model, face, samples, join).run();
}

} // namespace keiko
