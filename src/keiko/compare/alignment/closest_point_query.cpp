#include "keiko/compare/alignment/closest_point_query.h"

#include "keiko/compare/alignment/surface_pieces.h"
#include "keiko/geometry/bezier/subpatch.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// How often a piece is halved before its distance stays unproved.
constexpr int most_halvings = 12;
/// Share of its distance below which a piece is not halved either: its own minimum will do.
constexpr double small_piece = 0.01;
/// mm: a piece that is nearer by no more is left out. Roundings are larger where a point lies on
/// the body.
constexpr double least_gain = 1e-9;
/// mm: most of a revision lies as near to the body before. So small a ball holds few pieces, which
/// need few proofs; a larger one is searched only where that finds nothing.
constexpr double first_reach = 1e-3;

/// 0 for a border that is no edge of the file.
double claimed_tolerance(const SurfaceModel& model, const BoundaryInterval& border) {
    if (border.curve >= model.trim_curves.size()) return 0;
    const std::uint32_t edge = model.trim_curves[border.curve].edge;
    return edge == no_index ? 0 : model.edges[edge].tolerance;
}

} // namespace

/// State of the search for the nearest point so far.
class ClosestPointQuery::Search {
public:
    Search(const Pieces& pieces, const Vec3& p, double reach, const FaceFilter& counts)
        : pieces_(pieces), p_(p), counts_(counts), material_(reach) {}

    std::optional<ClosestSurfacePoint> run() {
        pieces_.tree->visit_near(p_, material_, [&](std::uint32_t sub_patch) {
            if (counts_ && !counts_(pieces_.face(sub_patch))) return material_;
            const BezierPatchView view =
                pieces_.sub_patches.view(pieces_.sub_patches.sub_patches[sub_patch]);
            look(sub_patch, view, unit_square, pieces_.convex[sub_patch], 0, 0);
            return material_;
        });
        if (trimmed_ < material_) look_at_borders();
        if (border_) return border_foot();
        if (sub_patch_ != no_index) return inner_foot();
        return std::nullopt;
    }

private:
    /// Tries the piece of a leaf over `box` of the leaf's parameters, a part of what `around` was
    /// made of; `path` has a bit a halving, 1 for the upper half.
    void look(std::uint32_t index, const BezierPatchView& piece, const Box2& box,
              const Convexity& around, int halved, unsigned path) {
        const SubPatch& sub_patch = pieces_.sub_patches.sub_patches[index];
        const Vec3 local = p_ - sub_patch.center;
        const Box3 hull = hull_bounds(piece);
        const double nearest = (hull.nearest(local) - local).length();
        if (nearest + least_gain >= material_) return;
        bool proved = around.holds(piece, local);
        std::optional<Convexity> own; // tighter, but dearer than to halve again
        if (!proved && halved == 2)
            proved = own.emplace(pieces_.quarters[index][path]).holds(piece, local);
        else if (!proved && halved % 3 == 2)
            proved = own.emplace(piece).holds(piece, local);
        const bool small = hull.size() < small_piece * nearest;
        if (proved || small || halved == most_halvings) {
            if (!proved) unproved_ = std::min(unproved_, nearest);
            take(index, piece_projection(piece, local), box);
            return;
        }
        // What is found now spares most of the halves.
        take(index, piece_projection(piece, local), box);
        const unsigned axis = longer_side(piece);
        for (const bool upper : {false, true}) {
            Box2 half = box;
            (upper ? half.lower : half.upper)[axis] = box.center()[axis];
            const std::vector<Vec4> points = subpatch(pieces_.sub_patches.view(sub_patch), half);
            const BezierPatchView view{piece.degree_u, piece.degree_v, points};
            look(index, view, half, own ? *own : around, halved + 1, 2 * path + upper);
        }
    }

    void take(std::uint32_t index, const PieceProjection& foot, const Box2& box) {
        if (foot.distance >= material_) return;
        const SubPatch& sub_patch = pieces_.sub_patches.sub_patches[index];
        const Vec2 uv = box.lower + box.extent() * foot.uv;
        if (!pieces_.is_material(sub_patch, uv)) {
            trimmed_ = std::min(trimmed_, foot.distance);
            return;
        }
        material_ = foot.distance;
        sub_patch_ = index, uv_ = uv;
    }

    void look_at_borders() {
        border_ = pieces_.borders->foot(p_, material_, counts_);
        if (border_) material_ = border_->distance;
    }

    double proved_bound() const { return std::min({material_, trimmed_, unproved_}); }

    ClosestSurfacePoint inner_foot() const {
        const SubPatch& sub_patch = pieces_.sub_patches.sub_patches[sub_patch_];
        const SurfaceModel& model = pieces_.body.model;
        const std::uint32_t face = pieces_.face(sub_patch_);
        const SurfaceDerivatives s = evaluate(pieces_.sub_patches.view(sub_patch), uv_, 2);
        return {.face = face,
                .position = s.position() + sub_patch.center,
                .normal = outward_normal(s, uv_, model.faces[face]),
                .distance = material_,
                .nearest = proved_bound(),
                .on_border = false};
    }

    ClosestSurfacePoint border_foot() const {
        const SurfaceModel& model = pieces_.body.model;
        const BoundaryInterval& border = pieces_.borders->borders()[border_->border];
        const auto frame = pieces_.borders->curve(border_->border).frame(border_->t);
        const Vec3 normal = frame ? frame->normal : Vec3(0);
        return {.face = border.face,
                .position = border_->position,
                .normal = model.faces[border.face].reversed ? -normal : normal,
                .distance = material_,
                .nearest = proved_bound(),
                .on_border = true};
    }

    const Pieces& pieces_;
    Vec3 p_;
    const FaceFilter& counts_;
    double material_;            ///< mm, of the nearest place found in the material, or the reach
    double trimmed_ = infinity;  ///< mm, of the nearest place found that is trimmed away
    double unproved_ = infinity; ///< mm, pieces without a proof are not nearer than this
    std::uint32_t sub_patch_ = no_index;
    Vec2 uv_{0}; ///< of the leaf
    std::optional<ProjectedBoundaryPoint> border_;
};

ClosestPointQuery::ClosestPointQuery(PlacedModel body, const Job& job)
    : pieces_(std::make_unique<Pieces>(std::move(body), job)) {}
ClosestPointQuery::~ClosestPointQuery() = default;
ClosestPointQuery::ClosestPointQuery(ClosestPointQuery&&) noexcept = default;

std::optional<ClosestSurfacePoint> ClosestPointQuery::foot(const Vec3& p, double reach,
                                                           const FaceFilter& counts) const {
    if (reach > first_reach)
        if (auto found = Search(*pieces_, p, first_reach, counts).run()) return found;
    return Search(*pieces_, p, reach, counts).run();
}

ClosestSurfacePoint ClosestPointQuery::foot(const Vec3& p) const {
    return *foot(p, infinity);
}

double ClosestPointQuery::border_distance(const Vec3& p, double reach) const {
    const auto found = pieces_->borders->foot(p, reach);
    return found ? found->distance : infinity;
}

std::optional<Vec3> ClosestPointQuery::border_foot(const Vec3& p, double reach,
                                                   const FaceFilter& counts) const {
    const auto found = pieces_->borders->foot(p, reach, counts);
    return found ? std::optional(found->position) : std::nullopt;
}

std::vector<BorderPoint> ClosestPointQuery::border_points() const {
    constexpr int between = 4;
    const BoundaryProjection& borders = *pieces_->borders;
    std::vector<BorderPoint> points;
    for (std::uint32_t i = 0; i < borders.borders().size(); ++i) {
        const SurfaceCurve curve = borders.curve(i);
        const BoundaryInterval& border = borders.borders()[i];
        const double claimed = claimed_tolerance(body().model, border);
        const std::vector<double>& t = borders.polyline(i).t;
        for (std::size_t k = 0; k + 1 < t.size(); ++k)
            for (int j = 0; j < between; ++j) {
                const double at = t[k] + (t[k + 1] - t[k]) * j / between;
                points.push_back({curve.at(at).position, border.face, claimed});
            }
        points.push_back({curve.at(1).position, border.face, claimed});
    }
    return points;
}

std::size_t ClosestPointQuery::piece_count() const {
    return pieces_->sub_patches.sub_patches.size();
}

Vec2 ClosestPointQuery::piece_size(std::size_t piece) const {
    const Vec2& length = pieces_->sub_patches.frames[piece].length;
    const double diameter = 2 * pieces_->sub_patches.sub_patches[piece].radius;
    return {std::min(length.x, diameter), std::min(length.y, diameter)};
}

std::optional<SurfacePoint> ClosestPointQuery::point(std::size_t piece, const Vec2& uv) const {
    return pieces_->point(static_cast<std::uint32_t>(piece), uv);
}

const PlacedModel& ClosestPointQuery::body() const {
    return pieces_->body;
}

} // namespace keiko
