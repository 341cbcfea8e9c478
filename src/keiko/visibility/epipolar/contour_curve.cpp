#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bernstein/de_casteljau.h"
#include "keiko/intersect/hit/surface_interaction.h"
#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/epipolar/epipolar_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace keiko {
namespace {

constexpr std::size_t points = BoundaryPiece::points;

/// Follows the outline across one piece.
class OutlineTrace {
public:
    OutlineTrace(const Silhouettes& silhouettes, const SubPatchKernels& kernels,
                 const SilhouetteCandidate& candidate, const Viewpoint& viewpoint)
        : piece_(silhouettes.pieces[candidate.piece]),
          patch_(silhouettes.patches[piece_.patch]),
          kernels_(kernels),
          edge_on_(candidate.edge_on),
          viewpoint_(viewpoint) {
        const double x = std::abs(edge_on_.along_x), y = std::abs(edge_on_.along_y);
        bound_ = x >= y ? 0 : 1;
        free_ = 1 - bound_;
        steep_ = std::max(x, y) > edge_on_.slope;
    }

    bool run(std::vector<ContourCurve>& outlines) {
        if (!steep_) return false;
        const ParameterInterval across = range();
        if (!(across.begin < across.end)) return true;
        if (!cover(across.begin, across.end, 0)) return false;
        outlines.insert(outlines.end(), pieces_.begin(), pieces_.end());
        return true;
    }

private:
    static constexpr double whole = 1 + 1e-5; ///< of a piece's own coordinates, with the overlap
    static constexpr int most_halvings = 4, clipped = most_halvings + 1;

    struct Place {
        Vec2 uv{0};
        SurfaceJet jet;
    };
    using Places = std::array<Place, points>;

    /// The outline's parameter: the piece's own free coordinate, -1 to 1, where the bound one may
    /// be within the piece.
    ParameterInterval range() const {
        constexpr double room = 0.05;
        const double along = slope(free_);
        const double reach = std::abs(slope(bound_)) * (1 + room) + edge_on_.off;
        if (!(std::abs(along) > 0)) return {-whole, whole};
        const double a = (-edge_on_.value - reach) / along, b = (-edge_on_.value + reach) / along;
        return {std::max(-whole, std::min(a, b)), std::min(whole, std::max(a, b))};
    }

    double slope(unsigned axis) const { return axis == 0 ? edge_on_.along_x : edge_on_.along_y; }

    Place place(const Vec2& xy) const {
        const Vec2 uv = piece_.uv.center() + piece_.uv.extent() * 0.5 * xy;
        return {uv, projected(kernels_.evaluate(patch_.points.view(), uv), patch_.rational)};
    }

    /// Newton's step along the bound coordinate towards where the surface is seen edge-on.
    double step(const SurfaceJet& j) const {
        const Vec3 way = viewpoint_.way_to(patch_.center + j.position);
        const Vec3 normal_slope = bound_ == 0 ? j.duu.cross(j.dv) + j.du.cross(j.duv)
                                              : j.duv.cross(j.dv) + j.du.cross(j.dvv);
        return -j.du.cross(j.dv).dot(way) /
               (normal_slope.dot(way) * piece_.uv.extent()[bound_] * 0.5);
    }

    /// The exact place of the outline at a free coordinate, by Newton's method.
    std::optional<Place> at(double s) const {
        constexpr int most_steps = 12;
        constexpr double astray = 1.5, nearly = 1e-8; // the step after is about its square
        Vec2 xy(0);
        xy[free_] = s;
        xy[bound_] = std::clamp(-(edge_on_.value + slope(free_) * s) / slope(bound_), -1.0, 1.0);
        for (int i = 0; i < most_steps; ++i) {
            const double off = step(place(xy).jet);
            xy[bound_] += off;
            if (!(std::abs(off) < astray && std::abs(xy[bound_]) < 1 + astray)) break;
            if (std::abs(off) <= nearly) return place(xy);
        }
        return std::nullopt;
    }

    bool cover(double a, double b, int halvings) {
        Places places;
        for (std::size_t k = 0; k < points; ++k) {
            const auto place = at(a + (b - a) * curve_node(k));
            if (!place) return false;
            places[k] = *place;
        }
        ContourCurve outline = through(places);
        if (check(outline, a, b)) return halvings == clipped ? keep(outline) : clip(outline, a, b);
        const double middle = (a + b) / 2;
        return halvings < most_halvings && cover(a, middle, halvings + 1) &&
               cover(middle, b, halvings + 1);
    }

    bool keep(const ContourCurve& outline) {
        pieces_.push_back(outline);
        return true;
    }

    /// The bound coordinate of the piece.
    double bound_at(const Vec2& place) const {
        return (place - piece_.uv.center())[bound_] / (piece_.uv.extent()[bound_] * 0.5);
    }

    /// Keeps the parts within the piece.
    bool clip(const ContourCurve& outline, double a, double b) {
        const auto inside = [&](const Vec2& place) { return std::abs(bound_at(place)) <= whole; };
        if (std::all_of(outline.places.begin(), outline.places.end(), inside)) return keep(outline);
        std::vector<double> ends{0, 1};
        for (const double side : {-whole, whole}) {
            std::array<double, points> off{};
            for (std::size_t i = 0; i < points; ++i) off[i] = bound_at(outline.places[i]) - side;
            const std::vector<double> roots = bernstein_roots(off, 0);
            ends.insert(ends.end(), roots.begin(), roots.end());
        }
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            if (inside(outline.place_at((ends[i] + ends[i + 1]) / 2)) &&
                !cover(a + (b - a) * ends[i], a + (b - a) * ends[i + 1], clipped))
                return false;
        return true;
    }

    ContourCurve through(const Places& places) const {
        std::array<Vec3, points> positions{Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0)};
        std::array<Vec2, points> uv{Vec2(0), Vec2(0), Vec2(0), Vec2(0), Vec2(0), Vec2(0)};
        Box3 box;
        for (const Place& place : places) box.extend(place.jet.position);
        for (std::size_t k = 0; k < points; ++k) {
            positions[k] = places[k].jet.position - box.center();
            uv[k] = places[k].uv;
        }
        ContourCurve outline;
        outline.patch = piece_.patch;
        outline.trimmed = piece_.trimmed;
        outline.places = curve_through(uv);
        BoundaryPiece& line = outline.line;
        line.instance = patch_.instance;
        line.face = patch_.face;
        line.center = patch_.center + box.center();
        line.curve = curve_through(positions);
        for (const Vec3& p : line.curve) line.radius = std::max(line.radius, p.length());
        return outline;
    }

    /// Holds a curve against the outline between its nodes; tells its error and its inward side.
    bool check(ContourCurve& outline, double a, double b) const {
        constexpr double safety = 4, on_patch = 1e-6;
        BoundaryPiece& line = outline.line;
        std::array<std::optional<Vec3>, 5> inward{};
        for (std::size_t i = 0; i < inward.size(); ++i) {
            const double t = static_cast<double>(i) / 4;
            const auto place = at(a + (b - a) * t);
            if (!place) return false;
            const Vec3 exact = patch_.center + place->jet.position;
            const double off = (line.center + line.at(t) - exact).length();
            const Vec2 aside = (outline.place_at(t) - place->uv) / piece_.uv.extent();
            line.error = std::max(line.error, safety * off);
            if (std::max(std::abs(aside.x), std::abs(aside.y)) > on_patch) return false;
            if (line.error > outline_error * (exact - viewpoint_.place()).length()) return false;
            inward[i] = side(place->jet);
        }
        set_inward(inward, line);
        return true;
    }

    /// On which the viewpoint sees the surface.
    std::optional<Vec3> side(const SurfaceJet& j) const {
        return bending_side(j, viewpoint_.way_to(patch_.center + j.position));
    }

    static void set_inward(const std::array<std::optional<Vec3>, 5>& inward, BoundaryPiece& line) {
        line.inward_error = std::numbers::pi / 2;
        if (!std::all_of(inward.begin(), inward.end(), [](const auto& i) { return i.has_value(); }))
            return;
        line.inward = {*inward[0], *inward[2], *inward[4]};
        constexpr double safety = 4;
        line.inward_error = safety * std::max(angle_between(*inward[1], line.inward_at(0.25)),
                                              angle_between(*inward[3], line.inward_at(0.75)));
    }

    const SilhouettePiece& piece_;
    const OccluderPatch& patch_;
    const SubPatchKernels& kernels_;
    AffineBounds::Weighed edge_on_;
    const Viewpoint& viewpoint_;
    unsigned bound_ = 0, free_ = 1; ///< coordinates of the piece
    bool steep_ = false;
    std::vector<ContourCurve> pieces_;
};

} // namespace

Vec2 ContourCurve::place_at(double t) const {
    return bernstein_value(places, t);
}

bool append_contour(const Silhouettes& silhouettes, const SubPatchKernels& kernels,
                    const SilhouetteCandidate& candidate, const Viewpoint& viewpoint,
                    std::vector<ContourCurve>& outlines) {
    return OutlineTrace(silhouettes, kernels, candidate, viewpoint).run(outlines);
}

} // namespace keiko
