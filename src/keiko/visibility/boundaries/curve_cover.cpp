#include "keiko/base/job.h"
#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/visibility/boundaries/boundary_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

constexpr double accuracy = 1e-9;  ///< of the curve's size
constexpr double rounding = 1e-14; ///< of the coordinates
constexpr int most_halvings = 10;
/// rad: a piece that turns by more is halved, so that its middle speaks for all of it.
constexpr double widest_turn = 0.4;
/// rad: a piece whose inward direction is not known so well is halved, if that helps soon.
constexpr double most_inward_error = 0.03;
constexpr int most_halvings_for_inward = 3;

/// The curve of degree 5 with these ends, over an interval of length h [Farin2002, section 7.6].
std::array<Vec3, BoundaryPiece::points> hermite(const SurfaceCurve::Point& a,
                                                const SurfaceCurve::Point& b, double h) {
    const Vec3 a1 = a.position + a.first * (h / 5), b1 = b.position - b.first * (h / 5);
    return {a.position,
            a1,
            a.position + a.first * (2 * h / 5) + a.second * (h * h / 20),
            b.position - b.first * (2 * h / 5) + b.second * (h * h / 20),
            b1,
            b.position};
}

/// Covers one curve with pieces.
class CurveCover {
public:
    CurveCover(const SurfaceCurve& curve, const Beyond& beyond, const BoundaryPiece& kind)
        : curve_(curve), beyond_(beyond), kind_(kind) {
        Box3 box;
        constexpr int samples = 8;
        for (int i = 0; i <= samples; ++i) box.extend(curve.at(double(i) / samples).position);
        size_ = box.size();
        scale_ = size_ + box.center().length();
        tolerance_ = std::max(accuracy * size_, rounding * scale_);
    }

    std::vector<BoundaryPiece> run() {
        constexpr double collapsed = 1e-11;
        if (size_ > collapsed * scale_) by_patch(0, 1);
        return std::move(pieces_);
    }

private:
    /// Cuts where the curve goes from one patch to the next, where it need not be smooth.
    void by_patch(double a, double b) {
        constexpr double narrowest = 1e-12;
        const double inset = std::min(1e-9 * (b - a), narrowest);
        const std::uint32_t first = curve_.patch_at(a + inset);
        if (b - a <= 4 * narrowest || first == curve_.patch_at(b - inset)) {
            const double middle = (a + b) / 2;
            if (b - a <= 4 * narrowest || first == curve_.patch_at(middle)) return cover(a, b, 0);
            by_patch(a, middle);
            return by_patch(middle, b);
        }
        double low = a + inset, high = b - inset;
        while (high - low > narrowest / 4) {
            const double middle = (low + high) / 2;
            if (!(low < middle && middle < high)) break;
            (curve_.patch_at(middle) == first ? low : high) = middle;
        }
        cover(a, low, 0);
        by_patch(high, b);
    }

    void cover(double a, double b, int halvings) {
        check_stop();
        if (!(a < b)) return;
        BoundaryPiece piece = kind_;
        const auto curve = hermite(curve_.at(a), curve_.at(b), b - a);
        const double error = error_of(curve, a, b);
        piece.error = kind_.error + error;
        find_inward(piece, a, b);
        const bool settled = error <= tolerance_ && !turns(curve);
        const bool steady = piece.inward_error <= most_inward_error;
        if ((!settled && halvings < most_halvings) ||
            (!steady && halvings < most_halvings_for_inward)) {
            cover(a, (a + b) / 2, halvings + 1);
            cover((a + b) / 2, b, halvings + 1);
            return;
        }
        find_normals(piece, a, b);
        place(piece, curve, a, b);
        pieces_.push_back(piece);
    }

    double error_of(const std::array<Vec3, BoundaryPiece::points>& curve, double a,
                    double b) const {
        double most = 0;
        for (const double t : {0.15, 0.3, 0.5, 0.7, 0.85})
            most =
                std::max(most, (point_on(curve, t) - curve_.at(a + t * (b - a)).position).length());
        return most;
    }

    /// The direction into the surface at three places, held against two others.
    void find_inward(BoundaryPiece& piece, double a, double b) const {
        const auto inward = [&](double t) -> std::optional<Vec3> {
            const auto frame = curve_.frame(a + (b - a) * t);
            return frame ? std::optional(frame->inward) : std::nullopt;
        };
        piece.inward_error = std::numbers::pi / 2;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = inward(static_cast<double>(i) / 2);
            if (!at) return;
            piece.inward[i] = *at;
        }
        double most = 0;
        for (const double t : {0.25, 0.75}) {
            const auto at = inward(t);
            if (!at) return;
            most = std::max(most, angle_between(*at, piece.inward_at(t)));
        }
        constexpr double safety = 4;
        piece.inward_error = safety * most;
    }

    /// The normals on both sides at five places, with as much room as they turn by from one place
    /// to the next.
    void find_normals(BoundaryPiece& piece, double a, double b) const {
        constexpr std::size_t places = 5;
        std::array<Vec3, 2 * places> normals;
        Vec3 sum(0);
        for (std::size_t i = 0; i < places; ++i) {
            const double t = a + (b - a) * static_cast<double>(i) / (places - 1);
            const auto frame = curve_.frame(t);
            if (!frame) return;
            const auto beyond = beyond_(t, frame->position);
            if (!beyond) return;
            normals[2 * i] = frame->tangent.cross(frame->inward).normalized();
            normals[2 * i + 1] = beyond->cross(frame->tangent).normalized();
            sum += normals[2 * i] + normals[2 * i + 1];
        }
        if (!(sum.length() > 0)) return;
        piece.normal = sum.normalized();
        double farthest = 0, turn = 0;
        for (std::size_t i = 0; i < normals.size(); ++i) {
            farthest = std::max(farthest, angle_between(piece.normal, normals[i]));
            if (i >= 2) turn = std::max(turn, angle_between(normals[i - 2], normals[i]));
        }
        constexpr double rounding_of_normals = 1e-6;
        piece.normal_angle = farthest + turn + rounding_of_normals;
    }

    static bool turns(const std::array<Vec3, BoundaryPiece::points>& curve) {
        const Vec3 chord = curve.back() - curve.front();
        for (std::size_t i = 1; i < curve.size(); ++i)
            if (!(angle_between(chord, curve[i] - curve[i - 1]) < widest_turn)) return true;
        return false;
    }

    void place(BoundaryPiece& piece, const std::array<Vec3, BoundaryPiece::points>& curve, double a,
               double b) const {
        for (const Vec3& p : curve) piece.box.extend(p);
        piece.center = piece.box.center();
        for (std::size_t i = 0; i < curve.size(); ++i) piece.curve[i] = curve[i] - piece.center;
        piece.box = piece.box.padded(piece.error);
        piece.radius = piece.box.size() / 2;
        const Vec2 first = kind_.first, way = kind_.last - kind_.first;
        piece.first = first + way * a;
        piece.last = first + way * b;
    }

    const SurfaceCurve& curve_;
    const Beyond& beyond_;
    const BoundaryPiece& kind_;
    std::vector<BoundaryPiece> pieces_;
    double size_ = 0, scale_ = 0, tolerance_ = 0;
};

} // namespace

std::vector<BoundaryPiece> curve_cover(const SurfaceCurve& curve, const Beyond& beyond,
                                       const BoundaryPiece& kind) {
    return CurveCover(curve, beyond, kind).run();
}

namespace {

constexpr std::size_t points = BoundaryPiece::points;

/// Inverse of the matrix of the Bernstein polynomials' values at the nodes, by Gauss and Jordan.
CurveMatrix inverse() {
    CurveMatrix values{}, inverse{};
    for (std::size_t k = 0; k < points; ++k) {
        BernsteinRow row{1};
        for (std::size_t n = 1; n < points; ++n) raise_degree(row, n, curve_node(k));
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

} // namespace

double curve_node(std::size_t k) {
    return (1 - std::cos(std::numbers::pi * static_cast<double>(k) / (points - 1))) / 2;
}

const CurveMatrix& control_points_of_values() {
    static const CurveMatrix matrix = inverse();
    return matrix;
}

} // namespace keiko
