#include "keiko/geometry/bezier/bezier.h"
#include "keiko/import/subdivision/limit_patches.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keiko::subdivision {
namespace {

/// A net with nothing regular about it.
SplineNet bumpy_net() {
    SplineNet net;
    for (int k = 0; k < 16; ++k)
        net[static_cast<std::size_t>(k)] =
            Vec3(k % 4 + 0.1 * std::sin(k), k / 4 + 0.1 * std::cos(3 * k), std::sin(7 * k));
    return net;
}

Vec3 point(const BezierNet& net, double u, double v) {
    std::vector<Vec4> points;
    for (const Vec3& p : net) points.emplace_back(p.x, p.y, p.z, 1);
    return evaluate({3, 3, points}, {u, v}, 0).position();
}

/// The value of a uniform cubic B-spline with control points c, c + 1, ... at t in [0, 1].
Vec3 spline(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double t) {
    const double s = 1 - t;
    return (a * (s * s * s) + b * (3 * t * t * t - 6 * t * t + 4) +
            c * (3 * s * s * s - 6 * s * s + 4) + d * (t * t * t)) /
           6;
}

TEST(BsplinePieces, TheBezierPatchIsTheSpline) {
    const SplineNet net = bumpy_net();
    const BezierNet bezier = bezier_of_spline(net, 0);
    for (const double u : {0.0, 0.3, 1.0})
        for (const double v : {0.0, 0.6, 1.0}) {
            Vec3 rows[4];
            for (std::size_t r = 0; r < 4; ++r)
                rows[r] = spline(net[4 * r], net[4 * r + 1], net[4 * r + 2], net[4 * r + 3], u);
            const Vec3 expected = spline(rows[0], rows[1], rows[2], rows[3], v);
            EXPECT_LT((point(bezier, u, v) - expected).length(), 1e-14);
        }
}

TEST(BsplinePieces, ABorderIsTheSplineOfItsOwnRow) {
    const SplineNet net = bumpy_net();
    const BezierNet bezier = bezier_of_spline(net, 1);
    for (const double u : {0.0, 0.4, 1.0})
        EXPECT_LT((point(bezier, u, 0) - spline(net[4], net[5], net[6], net[7], u)).length(),
                  1e-14);
}

TEST(BsplinePieces, PiecesBesideACreaseFillThePatchAndJoin) {
    for (const SideMask crease : {1u, 2u, 4u, 8u})
        for (const double sharpness : {0.4, 1.0, 2.0, 3.3}) {
            const auto pieces = pieces_beside_crease(bumpy_net(), crease, sharpness);
            double area = 0;
            for (const SplinePiece& p : pieces) area += p.box.extent().x * p.box.extent().y;
            EXPECT_DOUBLE_EQ(area, 1);
            const std::size_t expected =
                1 + (sharpness >= 1) + (sharpness != std::floor(sharpness));
            EXPECT_EQ(pieces.size(), expected);
            for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
                const unsigned axis = crease == 1 || crease == 4 ? 1 : 0;
                const bool far_first = crease == 1 || crease == 8; // the far piece lies higher
                const auto at = [&](const SplinePiece& p, double x) {
                    return axis == 1 ? point(p.points, 0.3, x) : point(p.points, x, 0.3);
                };
                EXPECT_LT((at(pieces[i], far_first ? 0 : 1) - at(pieces[i + 1], far_first ? 1 : 0))
                              .length(),
                          1e-14);
            }
        }
}

TEST(BsplinePieces, NoSharpnessIsTheSplineItself) {
    const auto pieces = pieces_beside_crease(bumpy_net(), 4, 1e-12);
    const BezierNet smooth = bezier_of_spline(bumpy_net(), 0);
    EXPECT_LT((point(pieces.back().points, 0.3, 1) - point(smooth, 0.3, 1)).length(), 1e-11);
}

} // namespace
} // namespace keiko::subdivision
