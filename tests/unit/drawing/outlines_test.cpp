#include "keiko/drawing/curves/outlines.h"

#include "keiko/drawing/hidden/curve_meetings.h"

#include "tests/support/analytic_models.h"
#include "tests/support/drawing_row.h"
#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace keiko {
namespace {

/// A solid of revolution with edges about z, placed: its profile of (radius, z) from the axis back
/// to it, upwards outside.
SurfaceModel turned_solid(const std::vector<Vec2>& profile, const Affine& placed) {
    std::vector<double> knots{0};
    std::vector<Vec4> points;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        knots.push_back(static_cast<double>(i));
        points.emplace_back(profile[i].x, 0, profile[i].y, 1);
    }
    knots.push_back(knots.back());
    test::ModelBuilder builder;
    builder.nurbs(test::revolution(1, knots, points));
    builder.instance(placed);
    return builder.build();
}

SurfaceModel ball(const Vec3& center, double radius) {
    Affine placed = Affine::scale(radius);
    placed.translation = center;
    return test::sphere_model(placed);
}

SurfaceModel body_of(const test::OracleRow& row) {
    const std::vector<double> n = row.list("in.body");
    const Vec3 a(n[0], n[1], n[2]);
    const std::string& kind = row.text("in.kind");
    if (kind == "sphere") return ball(a, n[3]);
    const Vec3 b(n[3], n[4], n[5]), axis = b - a;
    const double length = axis.length();
    if (kind == "cylinder")
        return turned_solid({{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                            test::stretched({n[6], n[6], length}, axis, a));
    if (kind == "cone")
        return turned_solid({{0, 0}, {1, 0}, {0, 1}},
                            test::stretched({n[6], n[6], length}, -axis, b));
    SurfaceModel torus = test::torus_model(n[6], n[7]);
    torus.instances[0].transform = test::stretched({1, 1, 1}, b, a);
    return torus;
}

/// Outward normal of a round body at one of its points, of any length.
std::optional<Vec3> outward(const test::OracleRow& row, const Vec3& x) {
    const std::vector<double> n = row.list("in.body");
    const Vec3 way = x - Vec3(n[0], n[1], n[2]);
    if (row.text("in.kind") == "sphere") return way;
    if (row.text("in.kind") != "torus") return std::nullopt;
    const Vec3 axis = Vec3(n[3], n[4], n[5]).normalized();
    return way - square_to(way, axis).normalized() * n[6];
}

struct NearOutline {
    std::size_t index = 0;
    CurveMeeting at{0, 0, 1e300};
};

NearOutline nearest_outline(const Outlines& outlines, const Vec3& place) {
    NearOutline nearest;
    for (std::size_t i = 0; i < outlines.curves.size(); ++i)
        if (const CurveMeeting at = nearest_on(outlines.curves[i].course, place);
            at.distance < nearest.at.distance)
            nearest = {i, at};
    return nearest;
}

bool is_visible(const CurvePiece& piece) {
    return piece.visible;
}
bool is_visible(const CountedPiece& piece) {
    return piece.sheets == 0;
}

template <class Piece>
bool visible_at(const std::vector<Piece>& pieces, double t) {
    for (const Piece& piece : pieces)
        if (t >= piece.begin && t <= piece.end) return is_visible(piece);
    ADD_FAILURE() << "no piece at " << t;
    return false;
}

TEST(Outlines, PassThroughTheClosedFormsOfRoundBodiesAndAreVisibleThereAsTold) {
    const test::OracleTable rows("outline_points");
    for (const test::OracleRow& row : rows) {
        SCOPED_TRACE(row.id());
        const std::vector<double> other = row.list("in.S2");
        const std::array models{body_of(row), ball({other[0], other[1], other[2]}, other[3])};
        const test::DrawnBody body(merge(models), test::camera_of(row), 1e-3);
        EXPECT_LT((body.projection.axes().right - row.unit("in.Rt")).length(), 1e-12);
        const Vec3 x = row.vector("out.X");
        const NearOutline found = nearest_outline(body.outlines, x);
        const double size = hull_bounds(models[0]).size();
        EXPECT_LT(found.at.distance, 1e-9 * size);
        const ModelCurve& outline = body.outlines.curves[found.index];
        const ImagePoint image = body.projection.image(outline.course.at(found.at.t));
        EXPECT_NEAR(image.at.x, row.number("out.x"),
                    1e-9 * (body.projection.parallel() ? size : 1));
        EXPECT_NEAR(image.at.y, row.number("out.y"),
                    1e-9 * (body.projection.parallel() ? size : 1));
        if (const auto normal = outward(row, x)) {
            const Vec3& bend = body.outlines.occluding[found.index].inward_at(found.at.t);
            EXPECT_EQ(bend.dot(*normal) < 0 ? 1 : -1, row.integer("out.kappa"));
        }
        const bool visible = row.integer("out.visible") == 1;
        EXPECT_EQ(visible, row.text("out.hidden_by") == "none");
        const auto changes = body.image.along(outline);
        EXPECT_EQ(visible_at(pieces_by_rays(outline, changes, body.sight), found.at.t), visible);
        EXPECT_EQ(visible_at(pieces_by_count(outline, changes, body.sight), found.at.t), visible);
    }
}

} // namespace
} // namespace keiko
