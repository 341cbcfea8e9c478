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

    /// Begins where the search for another place has ended.
    std::optional<ClosestSurfacePoint> run_from(std::uint32_t sub_patch, const Vec2& uv) {
        first_ = sub_patch;
        first_foot_ = project(sub_patch, view(sub_patch), unit_square, uv);
        return run();
    }

    std::optional<ClosestSurfacePoint> run() {
        pieces_.tree->visit_near(p_, material_, [&](std::uint32_t sub_patch) {
            if (counts_ && !counts_(pieces_.face(sub_patch))) return material_;
            const std::optional<Foot> known =
                sub_patch == first_ ? std::optional(first_foot_) : std::nullopt;
            const double size = pieces_.sub_patches.sub_patches[sub_patch].radius * 2;
            look({sub_patch, view(sub_patch), unit_square, pieces_.bounds[sub_patch], 0, size, 0},
                 known);
            return material_;
        });
        if (trimmed_ < material_) look_at_borders();
        if (border_) return border_foot();
        if (sub_patch_ != no_index) return inner_foot();
        return std::nullopt;
    }

private:
    /// A critical point of the distance to a piece.
    struct Foot {
        Vec2 uv;  ///< of the sub-patch
        Vec3 off; ///< from it to the place
        bool converged;
    };
    /// A part of a sub-patch.
    struct Part {
        std::uint32_t sub_patch;
        BezierPatchView view;
        Box2 box;                  ///< of the sub-patch's parameters
        const PieceBounds& bounds; ///< of the part
        double nearest;            ///< mm: no point of it is nearer, as far as is known
        double size;               ///< mm, at least that of its box
        int halved;
    };

    BezierPatchView view(std::uint32_t sub_patch) const {
        return pieces_.sub_patches.view(pieces_.sub_patches.sub_patches[sub_patch]);
    }
    /// The place in the coordinates of a sub-patch.
    Vec3 local(std::uint32_t sub_patch) const {
        return p_ - pieces_.sub_patches.sub_patches[sub_patch].center;
    }

    /// Searches a part. `known` is a critical point of something that the part belongs to: it is
    /// one of the part, too, if it lies there.
    void look(const Part& part, std::optional<Foot> known) {
        const Vec3 place = local(part.sub_patch);
        const double nearest = std::max(part.nearest, part.bounds.nearest(place));
        if (nearest + least_gain >= material_) return;
        if (!known || !part.box.contains(known->uv))
            known = project(part.sub_patch, part.view, part.box, Vec2(0.5));
        if (known->converged && part.bounds.proves(known->off)) return;
        if (part.size < small_piece * nearest || part.halved == most_halvings) {
            unproved_ = std::min(unproved_, nearest);
            return;
        }
        look_at_halves(part, place, known);
    }

    void look_at_halves(const Part& part, const Vec3& place, const std::optional<Foot>& known) {
        const unsigned axis = longer_side(part.view);
        for (const bool upper : {false, true}) {
            Box2 half = part.box;
            (upper ? half.lower : half.upper)[axis] = part.box.center()[axis];
            const std::vector<Vec4> points = subpatch(view(part.sub_patch), half);
            const BezierPatchView half_view{part.view.degree_u, part.view.degree_v, points};
            const Box3 hull = hull_bounds(half_view);
            const double away = (hull.nearest(place) - place).length();
            if (away + least_gain >= material_) continue;
            const PieceBounds bounds(sub_patch_frame(half_view)); // dearer than all before
            look({part.sub_patch, half_view, half, bounds, away, hull.size(), part.halved + 1},
                 known);
        }
    }

    /// Finds a local minimum over a part of a sub-patch and takes it if it is the nearest so far.
    Foot project(std::uint32_t index, const BezierPatchView& part, const Box2& box,
                 const Vec2& start) {
        const Vec3 place = local(index);
        const PieceProjection found = piece_projection(part, place, start);
        const Foot foot{box.lower + box.extent() * found.uv, place - found.position,
                        found.converged};
        if (found.distance >= material_) return foot;
        if (pieces_.is_material(pieces_.sub_patches.sub_patches[index], foot.uv))
            material_ = found.distance, sub_patch_ = index, uv_ = foot.uv;
        else
            trimmed_ = std::min(trimmed_, found.distance);
        return foot;
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
                .on_border = false,
                .piece = sub_patch_,
                .uv = uv_};
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
    Vec2 uv_{0};                     ///< of the sub-patch
    std::uint32_t first_ = no_index; ///< sub-patch that was searched before all
    Foot first_foot_{};              ///< of that one
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

std::optional<ClosestSurfacePoint> ClosestPointQuery::foot_from(const ClosestSurfacePoint& start,
                                                                const Vec3& p, double reach) const {
    if (start.on_border) return foot(p, reach);
    return Search(*pieces_, p, reach, {}).run_from(start.piece, start.uv);
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
