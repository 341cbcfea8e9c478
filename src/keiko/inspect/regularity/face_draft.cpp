#include "keiko/inspect/regularity/face_draft.h"

#include "keiko/base/job.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/approximation_error.h"
#include "keiko/inspect/basics/face_box.h"
#include "keiko/inspect/regularity/normal_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double straight = 90; ///< degrees

/// Share of the face's size below which a piece is given up whose normals may vanish.
constexpr double singular_share = 1e-3;

/// A piece of a patch, with a lower bound of its draft angles in degrees.
struct Piece {
    const NormalPatch* patch = nullptr;
    NormalCell cell;
    double low = -straight;
    int depth = 0;
    bool inside = false;    ///< all of it is material
    std::size_t number = 0; ///< in the order of creation, for an order of equal bounds
};

/// Order of a heap whose first piece has the lowest bound.
bool is_higher(const Piece& a, const Piece& b) {
    return a.low != b.low ? a.low > b.low : a.number > b.number;
}

class DraftSearch {
public:
    DraftSearch(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                const Vec3& pull)
        : model_(model), face_(model.faces[face]), trims_(model, face_) {
        const Affine& placed = model.instances[instance].transform;
        // Normals along du x dv point inwards where either turns them, not both.
        axis_ = face_.reversed != placed.mirrored() ? -pull : pull;
        Box3 bounds;
        for (std::uint32_t i = 0; i < face_.patch_count; ++i) {
            patches_.emplace_back(model, face_.first_patch + i, placed, 0);
            bounds.extend(patches_.back().box());
        }
        size_ = bounds.size();
        for (const NormalPatch& patch : patches_)
            add({&patch, NormalCell(patch), -straight, 0, trims_.untrimmed(), 0});
    }

    /// The smallest angle found, and how far the true one may be below; without a limit.
    std::optional<MeasuredValue> run(std::size_t splits) {
        while (!pieces_.empty() && splits > 0 &&
               !(pieces_.front().low >= best_.value - draft_tolerance / 2)) {
            check_stop();
            split(take_lowest());
            --splits;
        }
        if (!std::isfinite(best_.value)) return std::nullopt;
        if (!pieces_.empty()) best_.bound = std::max(0.0, best_.value - pieces_.front().low);
        return best_;
    }

private:
    TrimSide side_of(const Piece& piece) const {
        if (piece.inside) return TrimSide::inside;
        return trims_.classify(face_box(model_, piece.patch->index(), piece.cell.uv()));
    }

    void add(Piece piece) {
        const TrimSide side = side_of(piece);
        if (side == TrimSide::outside) return;
        piece.inside = side == TrimSide::inside;
        sample(piece);
        const auto sine = piece.cell.smallest_sine(axis_);
        if (sine)
            piece.low = std::max(piece.low, radians_to_degrees(std::asin(*sine)));
        else if (piece.cell.size() < singular_share * size_)
            return;
        piece.number = count_++;
        pieces_.push_back(std::move(piece));
        std::push_heap(pieces_.begin(), pieces_.end(), is_higher);
    }

    Piece take_lowest() {
        std::pop_heap(pieces_.begin(), pieces_.end(), is_higher);
        Piece piece = std::move(pieces_.back());
        pieces_.pop_back();
        return piece;
    }

    /// Takes the angles at the middle and near the corners if they are the smallest.
    void sample(const Piece& piece) {
        constexpr double inwards = 1e-7; // trims often run along sides of a patch
        for (const double x : {0.5, inwards, 1 - inwards})
            for (const double y : {0.5, inwards, 1 - inwards})
                if ((x == 0.5) == (y == 0.5)) sample(piece, {x, y});
    }

    void sample(const Piece& piece, const Vec2& share) {
        const NormalPatch& patch = *piece.patch;
        const Box2& box = piece.cell.uv();
        const Vec2 uv = box.lower + share * box.extent();
        if (!piece.inside && !trims_.contains(model_.face_parameters(patch.index(), uv))) return;
        const auto normal = patch.normal(uv);
        if (!normal) return;
        const double angle = draft_angle(*normal, axis_);
        if (angle < best_.value) best_.value = angle, best_.place = patch.position(uv);
    }

    /// Cuts a piece where its normals turn more. Each second cut of one that trims may cross is
    /// across its longer side, so that these are met too.
    void split(const Piece& piece) {
        const std::array<double, 2> turns{piece.cell.turn(true), piece.cell.turn(false)};
        const std::array<double, 2> sides = piece.cell.extents();
        const bool by_turn = turns[0] != turns[1] && (piece.inside || piece.depth % 2 == 0);
        const bool by_u = by_turn ? turns[0] > turns[1] : sides[0] >= sides[1];
        for (NormalCell& half : piece.cell.halves_across(by_u))
            add({piece.patch, std::move(half), piece.low, piece.depth + 1, piece.inside, 0});
    }

    const SurfaceModel& model_;
    const Face& face_;
    TrimRegion trims_;
    Vec3 axis_{0}; ///< the pull as normals along du x dv have it
    double size_ = 0;
    std::size_t count_ = 0;
    std::vector<NormalPatch> patches_;
    std::vector<Piece> pieces_; ///< a heap
    MeasuredValue best_{infinity, 0, 0, Vec3(0), Verdict::pass, true};
};

} // namespace

std::optional<MeasuredValue> smallest_draft(const SurfaceModel& model, std::uint32_t instance,
                                            std::uint32_t face, const DraftLimit& limit,
                                            std::size_t most_splits) {
    auto worst = DraftSearch(model, instance, face, limit.pull.normalized()).run(most_splits);
    if (!worst) return std::nullopt;
    const double off = approximation_error(model, face, scale_of(model.instances[instance])).angle;
    const double allowed = limit.angle - draft_tolerance;
    worst->limit = limit.angle;
    worst->bound += off;
    // A place of the found angle exists; only the bound may be too wide.
    if (worst->value + off < allowed)
        worst->verdict = Verdict::fail;
    else if (!(worst->value - worst->bound >= allowed))
        worst->verdict = Verdict::undecided;
    return worst;
}

} // namespace keiko
