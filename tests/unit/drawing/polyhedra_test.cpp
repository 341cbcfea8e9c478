#include "keiko/drawing/hidden/curve_pieces.h"

#include "tests/support/drawing_row.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// The crease from a to b, and whether it runs that way.
const ModelCurve* crease_between(const test::DrawnBody& body, const Vec3& a, const Vec3& b) {
    constexpr double same = 1e-6; // mm
    for (const ModelCurve& curve : body.pierced) {
        const Vec3 &first = curve.course.points.front(), &last = curve.course.points.back();
        const bool along = (first - a).length() < same && (last - b).length() < same;
        const bool back = (first - b).length() < same && (last - a).length() < same;
        if (curve.kind == CurveKind::crease && (along || back)) return &curve;
    }
    return nullptr;
}

/// Number of convex solids before a piece: each has a front and a back, but its own counts once.
int solids(const CountedPiece& piece) {
    return (piece.sheets + 1) / 2;
}

struct Counted {
    std::vector<double> t; ///< of the edge, from its begin to its end
    std::vector<int> qi;   ///< between them
};

Counted counted_along(const test::DrawnBody& body, const ModelCurve& edge, const Vec3& a,
                      const Vec3& b) {
    const auto share = [&](double t) {
        return (edge.course.at(t) - a).dot(b - a) / (b - a).length2();
    };
    std::vector<CountedPiece> pieces = pieces_by_count(edge, body.image.along(edge), body.sight);
    if (share(0) > 0.5) {
        std::reverse(pieces.begin(), pieces.end());
        for (CountedPiece& piece : pieces) std::swap(piece.begin, piece.end);
    }
    Counted counted{{0}, {}};
    for (const CountedPiece& piece : pieces) {
        if (!counted.qi.empty() && counted.qi.back() == solids(piece)) {
            counted.t.back() = share(piece.end);
            continue;
        }
        counted.qi.push_back(solids(piece));
        counted.t.push_back(share(piece.end));
    }
    return counted;
}

TEST(Polyhedra, EdgesHaveTheQuantitativeInvisibilityOfTheOracle) {
    const test::OracleTable rows("edge_qi");
    for (const test::OracleRow& row : rows) {
        SCOPED_TRACE(row.id());
        const test::DrawnBody body(test::boxes_of(row), test::camera_of(row));
        EXPECT_LT((body.projection.axes().right - row.unit("in.Rt")).length(), 1e-12);
        const Vec3 a = row.vector("in.A"), b = row.vector("in.B");
        const ModelCurve* edge = crease_between(body, a, b);
        ASSERT_NE(edge, nullptr);
        const Counted counted = counted_along(body, *edge, a, b);
        const std::vector<double> t = row.list("out.t"), qi = row.list("out.qi");
        ASSERT_EQ(counted.qi.size(), static_cast<std::size_t>(row.integer("out.n")));
        for (std::size_t i = 0; i < qi.size(); ++i) EXPECT_EQ(counted.qi[i], std::lround(qi[i]));
        for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(counted.t[i], t[i], 1e-10);
        const int least = row.integer("out.own") == 1 ? 1 : 0; // its own box
        for (const int count : counted.qi) EXPECT_GE(count, least);
        std::vector<double> visible;
        for (const CurvePiece& piece : pieces_by_rays(*edge, body.image.along(*edge), body.sight))
            if (piece.visible)
                for (const double end : {piece.begin, piece.end})
                    visible.push_back((edge->course.at(end) - a).dot(b - a) / (b - a).length2());
        std::sort(visible.begin(), visible.end());
        const std::vector<double> expected = row.list("out.visible");
        ASSERT_EQ(visible.size(), expected.size());
        for (std::size_t i = 0; i < visible.size(); ++i)
            EXPECT_NEAR(visible[i], expected[i], 1e-10);
    }
}

/// Corners of the contour edges in the image, counter-clockwise from the one farthest left.
std::vector<Vec2> contour_of(const test::DrawnBody& body) {
    std::vector<Vec2> corners;
    for (const ModelCurve& edge : body.pierced)
        if (edge.is_contour_edge(edge.course.end() / 2, body.projection))
            for (const Vec3& end : {edge.course.points.front(), edge.course.points.back()}) {
                const Vec2 at = body.projection.image(end).at;
                const bool known = std::any_of(corners.begin(), corners.end(), [&](const Vec2& c) {
                    return (c - at).length() < 1e-9 * (1 + at.length());
                });
                if (!known) corners.push_back(at);
            }
    Vec2 middle(0);
    for (const Vec2& corner : corners) middle += corner / static_cast<double>(corners.size());
    std::sort(corners.begin(), corners.end(), [&](const Vec2& a, const Vec2& b) {
        return std::atan2(a.y - middle.y, a.x - middle.x) <
               std::atan2(b.y - middle.y, b.x - middle.x);
    });
    const auto left =
        std::min_element(corners.begin(), corners.end(), [](const Vec2& a, const Vec2& b) {
            constexpr double same = 1e-9; // of two that are as far left, the lower one
            return std::abs(a.x - b.x) > same ? a.x < b.x : a.y < b.y;
        });
    std::rotate(corners.begin(), left, corners.end());
    return corners;
}

TEST(Polyhedra, ContourEdgesOfABoxAreItsConvexHullInTheImage) {
    const test::OracleTable rows("box_contour");
    for (const test::OracleRow& row : rows) {
        SCOPED_TRACE(row.id());
        const test::DrawnBody body(test::boxes_of(row), test::camera_of(row));
        EXPECT_LT((body.projection.axes().right - row.unit("in.Rt")).length(), 1e-12);
        const std::vector<Vec2> corners = contour_of(body);
        const std::vector<double> expected = row.list("out.contour");
        ASSERT_EQ(corners.size(), static_cast<std::size_t>(row.integer("out.nv")));
        const double size = body.projection.parallel() ? body.sight.size() : 1;
        double twice = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            EXPECT_NEAR(a.x, expected[2 * i], 1e-11 * size);
            EXPECT_NEAR(a.y, expected[2 * i + 1], 1e-11 * size);
            twice += a.x * b.y - a.y * b.x;
        }
        EXPECT_NEAR(twice / 2, row.number("out.area"), 1e-11 * size * size);
        const auto contours =
            std::count_if(body.pierced.begin(), body.pierced.end(), [&](const ModelCurve& edge) {
                return edge.is_contour_edge(edge.course.end() / 2, body.projection);
            });
        EXPECT_EQ(contours, row.integer("out.nv"));
    }
}

TEST(Polyhedra, ContourEdgesOfAConvexBodyAreVisible) {
    const test::OracleTable rows("box_contour");
    for (const test::OracleRow& row : rows) {
        const test::DrawnBody body(test::boxes_of(row), test::camera_of(row));
        for (const ModelCurve& edge : body.pierced)
            for (const CurvePiece& piece : pieces_by_rays(edge, body.image.along(edge), body.sight))
                EXPECT_TRUE(piece.visible || !piece.contour) << row.id();
    }
}

} // namespace
} // namespace keiko
