#include "keiko/trace/outline_piece.h"

#include "keiko/patch/bernstein_roots.h"
#include "keiko/trace/surface_jet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace keiko {
namespace {

constexpr std::size_t points = BorderPiece::points;

/// Where curves are made to meet the outline: Chebyshev's places of [0, 1], ends included.
double node(std::size_t k) {
    return (1 - std::cos(std::numbers::pi * static_cast<double>(k) / (points - 1))) / 2;
}

using Matrix = std::array<std::array<double, points>, points>;

/// What makes values at the nodes the control points of the polynomial through them: the inverse of
/// the Bernstein polynomials there, by Gauss and Jordan.
Matrix control_points_of_values() {
    Matrix values{}, inverse{};
    for (std::size_t k = 0; k < points; ++k) {
        BernsteinRow row{1};
        for (std::size_t n = 1; n < points; ++n) raise_degree(row, n, node(k));
        std::copy_n(row.begin(), points, values[k].begin());
        inverse[k][k] = 1;
    }
    for (std::size_t k = 0; k < points; ++k) {
        const double pivot = values[k][k];
        for (std::size_t j = 0; j < points; ++j) values[k][j] /= pivot, inverse[k][j] /= pivot;
        for (std::size_t i = 0; i < points; ++i) {
            const double share = i == k ? 0 : values[i][k];
            for (std::size_t j = 0; j < points; ++j) {
                values[i][j] -= share * values[k][j];
                inverse[i][j] -= share * inverse[k][j];
            }
        }
    }
    return inverse;
}

template <class T>
std::array<T, points> curve_through(const std::array<T, points>& at_nodes, const T& zero) {
    static const Matrix matrix = control_points_of_values();
    std::array<T, points> curve{zero, zero, zero, zero, zero, zero};
    for (std::size_t i = 0; i < points; ++i)
        for (std::size_t k = 0; k < points; ++k) curve[i] = curve[i] + at_nodes[k] * matrix[i][k];
    return curve;
}

/// Follows the outline across one piece.
class OutlineTrace {
public:
    OutlineTrace(const Silhouettes& silhouettes, const LeafKernels& kernels,
                 const SilhouetteCandidate& candidate, const Apex& apex)
        : piece_(silhouettes.pieces[candidate.piece]),
          patch_(silhouettes.patches[piece_.patch]),
          kernels_(kernels),
          edge_on_(candidate.edge_on),
          apex_(apex) {
        const double x = std::abs(edge_on_.along_x), y = std::abs(edge_on_.along_y);
        bound_ = x >= y ? 0 : 1;
        free_ = 1 - bound_;
        steep_ = std::max(x, y) > edge_on_.slope;
    }

    bool run(std::vector<OutlinePiece>& outlines) {
        if (!steep_) return false;
        const ParameterInterval across = range();
        if (!(across.begin < across.end)) return true;
        if (!cover(across.begin, across.end, 0)) return false;
        outlines.insert(outlines.end(), pieces_.begin(), pieces_.end());
        return true;
    }

private:
    static constexpr double whole = 1 + 1e-5; ///< of a piece's own coordinates, with the overlap
    static constexpr int most_halvings = 4, clipped = most_halvings;

    struct Place {
        Vec2 uv{0};
        SurfaceJet jet;
    };
    using Places = std::array<Place, points>;

    /// The outline's parameter: the piece's own free coordinate, -1 to 1, where the bound one may
    /// be within the piece.
    ParameterInterval range() const {
        constexpr double room = 0.05;
        const double slope = free_ == 0 ? edge_on_.along_x : edge_on_.along_y;
        const double steep = free_ == 0 ? edge_on_.along_y : edge_on_.along_x;
        const double reach = std::abs(steep) * (1 + room) + edge_on_.off;
        if (!(std::abs(slope) > 0)) return {-whole, whole};
        const double a = (-edge_on_.value - reach) / slope, b = (-edge_on_.value + reach) / slope;
        return {std::max(-whole, std::min(a, b)), std::min(whole, std::max(a, b))};
    }

    /// The exact place of the outline at a free coordinate, by Newton's method.
    std::optional<Place> at(double s) const {
        constexpr int most_steps = 12;
        constexpr double settled = 1e-14, astray = 1.5;
        const Vec2 half = piece_.uv.extent() * 0.5;
        const double slope = free_ == 0 ? edge_on_.along_x : edge_on_.along_y;
        const double steep = free_ == 0 ? edge_on_.along_y : edge_on_.along_x;
        Vec2 xy(0);
        xy[free_] = s;
        xy[bound_] = std::clamp(-(edge_on_.value + slope * s) / steep, -1.0, 1.0);
        for (int i = 0; i < most_steps; ++i) {
            Place place{piece_.uv.center() + half * xy, {}};
            place.jet =
                projected(kernels_.evaluate(patch_.points.view(), place.uv), patch_.rational);
            const SurfaceJet& j = place.jet;
            const Vec3 way = apex_.way_to(patch_.center + j.position);
            const Vec3 normal_slope = bound_ == 0 ? j.duu.cross(j.dv) + j.du.cross(j.duv)
                                                  : j.duv.cross(j.dv) + j.du.cross(j.dvv);
            const double step = j.du.cross(j.dv).dot(way) / (normal_slope.dot(way) * half[bound_]);
            if (!(std::abs(step) < astray)) return std::nullopt;
            if (std::abs(step) <= settled) return place;
            xy[bound_] -= step;
            if (std::abs(xy[bound_]) > 1 + astray) return std::nullopt;
            // The next one is about its square.
            constexpr double nearly = 1e-8;
            if (std::abs(step) <= nearly) {
                place.uv = piece_.uv.center() + half * xy;
                place.jet =
                    projected(kernels_.evaluate(patch_.points.view(), place.uv), patch_.rational);
                return place;
            }
        }
        return std::nullopt;
    }

    bool cover(double a, double b, int halvings) {
        Places places;
        for (std::size_t k = 0; k < points; ++k) {
            const auto place = at(a + (b - a) * node(k));
            if (!place) return false;
            places[k] = *place;
        }
        OutlinePiece outline = through(places);
        if (check(outline, a, b)) return halvings == clipped ? keep(outline) : clip(outline, a, b);
        const double middle = (a + b) / 2;
        return halvings < most_halvings && cover(a, middle, halvings + 1) &&
               cover(middle, b, halvings + 1);
    }

    bool keep(const OutlinePiece& outline) {
        pieces_.push_back(outline);
        return true;
    }

    /// Keeps the parts within the piece.
    bool clip(const OutlinePiece& outline, double a, double b) {
        std::array<double, points> bound{};
        for (std::size_t i = 0; i < points; ++i)
            bound[i] = (outline.places[i] - piece_.uv.center())[bound_] /
                       (piece_.uv.extent()[bound_] * 0.5);
        const auto inside = [](double x) { return std::abs(x) <= whole; };
        if (std::all_of(bound.begin(), bound.end(), inside)) return keep(outline);
        std::vector<double> ends{0, 1};
        for (const double side : {-whole, whole}) {
            std::array<double, points> off = bound;
            for (double& x : off) x -= side;
            const std::vector<double> roots = bernstein_roots(off, 0);
            ends.insert(ends.end(), roots.begin(), roots.end());
        }
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const Vec2 middle = outline.place_at((ends[i] + ends[i + 1]) / 2);
            if (!inside((middle - piece_.uv.center())[bound_] / (piece_.uv.extent()[bound_] * 0.5)))
                continue;
            if (!cover(a + (b - a) * ends[i], a + (b - a) * ends[i + 1], clipped)) return false;
        }
        return true;
    }

    OutlinePiece through(const Places& places) const {
        std::array<Vec3, points> positions{Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0)};
        std::array<Vec2, points> uv{Vec2(0), Vec2(0), Vec2(0), Vec2(0), Vec2(0), Vec2(0)};
        Box3 box;
        for (const Place& place : places) box.extend(place.jet.position);
        for (std::size_t k = 0; k < points; ++k) {
            positions[k] = places[k].jet.position - box.center();
            uv[k] = places[k].uv;
        }
        OutlinePiece outline;
        outline.patch = piece_.patch;
        outline.trimmed = piece_.trimmed;
        outline.places = curve_through(uv, Vec2(0));
        BorderPiece& line = outline.line;
        line.instance = patch_.instance;
        line.face = patch_.face;
        line.center = patch_.center + box.center();
        line.curve = curve_through(positions, Vec3(0));
        for (const Vec3& p : line.curve) line.radius = std::max(line.radius, p.length());
        return outline;
    }

    /// Holds a curve against the outline between its nodes; tells its error and its inward side.
    bool check(OutlinePiece& outline, double a, double b) const {
        constexpr double safety = 4, on_patch = 1e-6;
        BorderPiece& line = outline.line;
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
            if (line.error > outline_error * (exact - apex_.place()).length()) return false;
            inward[i] = side(place->jet);
        }
        set_inward(inward, line);
        return true;
    }

    /// Unit normal to the side on which the apex sees the surface: the one that it bends to along
    /// the way from the apex. Nothing next to where that changes, a cusp.
    std::optional<Vec3> side(const SurfaceJet& j) const {
        const Vec3 way = apex_.way_to(patch_.center + j.position), n = j.du.cross(j.dv);
        const double e = j.du.dot(j.du), f = j.du.dot(j.dv), g = j.dv.dot(j.dv);
        const double u = j.du.dot(way), v = j.dv.dot(way), d = e * g - f * f;
        const double a = (g * u - f * v) / d, b = (e * v - f * u) / d;
        const Vec3 second = j.duu * (a * a) + j.duv * (2 * a * b) + j.dvv * (b * b);
        constexpr double sure = 1e-5;
        const double bend = n.dot(second) / n.length();
        if (!(std::abs(bend) > sure * second.length())) return std::nullopt;
        return n * ((bend > 0 ? 1 : -1) / n.length());
    }

    static void set_inward(const std::array<std::optional<Vec3>, 5>& inward, BorderPiece& line) {
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
    const LeafKernels& kernels_;
    AffineNet::Weighed edge_on_;
    const Apex& apex_;
    unsigned bound_ = 0, free_ = 1; ///< coordinates of the piece
    bool steep_ = false;
    std::vector<OutlinePiece> pieces_;
};

} // namespace

Vec2 OutlinePiece::place_at(double t) const {
    std::array<Vec2, points> c = places;
    for (std::size_t level = 1; level < points; ++level)
        for (std::size_t i = 0; i + level < points; ++i) c[i] = c[i] * (1 - t) + c[i + 1] * t;
    return c[0];
}

bool append_outline(const Silhouettes& silhouettes, const LeafKernels& kernels,
                    const SilhouetteCandidate& candidate, const Apex& apex,
                    std::vector<OutlinePiece>& outlines) {
    return OutlineTrace(silhouettes, kernels, candidate, apex).run(outlines);
}

} // namespace keiko
