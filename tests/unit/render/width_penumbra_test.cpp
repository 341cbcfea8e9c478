#include "keiko/light/rig/light_visibility.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/light/tubes/lamp_width.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/render/shading/direct_lighting.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using namespace test;

constexpr double diameter = 180; // mm
const Vec3 up(0, 0, 1);
const CPlane row{.origin = {-1800, -500, 1600},
                 .u = {3600, 0, 0},
                 .v = {0, 1000, 0},
                 .lamps = 2,
                 .pitch = 500,
                 .diameter = diameter,
                 .luminance = Rgb(5000)};

/// A bar about `center`, from `along` before it to `along` behind, with square ends.
struct Bar {
    Vec3 center, along, half_width, half_height;

    void add_flat(ModelBuilder& builder) const {
        const Vec3 sides[3] = {along, half_width, half_height};
        for (int i = 0; i < 3; ++i) {
            const Vec3 &u = sides[(i + 1) % 3], &v = sides[(i + 2) % 3];
            for (const double side : {-1.0, 1.0})
                builder.plane(center + sides[i] * side - u - v, u * 2, v * 2);
        }
    }
    /// Elliptic, in exact quarters.
    void add_round(ModelBuilder& builder) const {
        const double s = std::numbers::sqrt2 / 2;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const auto at = [&](int turn) {
                const double angle = turn * std::numbers::pi / 2;
                return half_width * std::cos(angle) + half_height * std::sin(angle);
            };
            const Vec3 from = at(quarter), to = at(quarter + 1);
            std::vector<Vec4> points;
            for (const auto& [place, w] : {std::pair{from, 1.0}, {from + to, s}, {to, 1.0}})
                for (const double side : {-1.0, 1.0}) {
                    const Vec3 x = (center + place + along * side) * w;
                    points.emplace_back(x.x, x.y, x.z, w);
                }
            builder.rational_patch(2, 1, points);
        }
    }
};

/// Bars in a row at one height, by `pitch` from middle to middle, aslant to the lamps by radians.
std::vector<Bar> bars(int count, double pitch, double slant, double height,
                      const Vec2& half_section) {
    const Vec3 x(std::cos(slant), std::sin(slant), 0), y = up.cross(x);
    std::vector<Bar> all;
    for (int i = 0; i < count; ++i)
        all.push_back({Vec3(0, 0, height) + y * ((i - (count - 1) / 2.0) * pitch), x * 2000,
                       y * half_section.x, up * half_section.y});
    return all;
}

/// Visibility of the row from points of the ground, past some model.
struct Under {
    SurfaceModel model;
    CPlane plane = row;
    Tracer tracer{model};
    Occluders occluders{model, tracer};
    PreparedSource source{plane};
    std::vector<int> lamps{0, 1};

    OccludedVisibility past(const Vec3& point) const {
        return {&occluders, tracer, Viewpoint::at(point), light_bounds(source, lamps, point),
                {},         up};
    }
    /// The middles of many strips along a lamp.
    double share_by_lines(const Vec3& point, int lamp, int lines) const {
        const TubeLamp tube = lamp_of(CPlaneFrame(plane), lamp, plane.luminance);
        const LampWidth width(*view_of(tube, point, up), point, TubeShape::cylinder, {});
        std::vector<SubAxis> axes;
        std::vector<Segment> segments;
        for (int i = 0; i < lines; ++i) {
            axes.push_back(width.sub_axis((2 * i + 1.0) / lines - 1));
            segments.push_back(width.line_of(axes.back()));
        }
        const std::vector<IntervalSet> seen = past(point).intervals(segments);
        double all = 0, lit = 0;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            all += axes[i].weight * width.lit(axes[i], 0, 1);
            for (const ParameterInterval& part : seen[i])
                lit += axes[i].weight * width.lit(axes[i], part.begin, part.end);
        }
        return lit / all;
    }
    /// Compares with the shares by lines; returns how many lamps are partly visible, summed over
    /// the points.
    int expect_as_by_lines(const std::vector<Vec3>& points, int lines) const {
        int partly = 0;
        for (const Vec3& point : points) {
            const std::vector<LightVisibility> seen = light_visibilities(
                source, lamps, point, up, past(point), TubeModel::automatic, false);
            for (const int lamp : lamps) {
                const double share = share_by_lines(point, lamp, lines);
                EXPECT_NEAR(seen[static_cast<std::size_t>(lamp)].share, share, 1e-4)
                    << "lamp " << lamp << " from " << point.x << ' ' << point.y;
                partly += share > 0 && share < 1;
            }
        }
        return partly;
    }
};

constexpr int many_lines = 40000; // each edge along a lamp is within 1.3e-5 of its place

/// Expects bars of a twentieth of a lamp's width to be found; lines a ninth of it apart pass on
/// both sides of one.
void expect_thin_bars_found(void (Bar::*add)(ModelBuilder&) const) {
    ModelBuilder builder;
    for (const Bar& bar : bars(9, 213, 0, 1400, {4.5, 4.5})) (bar.*add)(builder);
    const std::vector<Vec3> points{{172, -26.5, 0}, {-333, -134, 0},  {-303, -54, 0},
                                   {402, 44, 0},    {-392, 337.5, 0}, {51, -11.5, 0}};
    EXPECT_GE(Under{builder.build()}.expect_as_by_lines(points, many_lines), 8);
}

} // namespace

TEST(WidthPenumbra, FindsThinBarsAlongALamp) {
    expect_thin_bars_found(&Bar::add_flat);
}

TEST(WidthPenumbra, FindsThinRoundBarsAlongALamp) {
    expect_thin_bars_found(&Bar::add_round);
}

TEST(WidthPenumbra, FindsSlitsBetweenBoards) {
    for (const double slant : {0.0, 0.01}) {
        ModelBuilder builder;
        for (const Bar& bar : bars(17, 155.4, slant, 1000, {75, 6})) bar.add_flat(builder);
        std::vector<Vec3> points;
        for (int i = 0; i < 6; ++i) points.emplace_back(120.0 * i - 350, 74.0 * i - 210, 0);
        EXPECT_GE(Under{builder.build()}.expect_as_by_lines(points, many_lines), 6) << slant;
    }
}

// Across a short lamp; lines that pass on both sides of the bulge know nothing of it.
TEST(WidthPenumbra, FindsABulgeOfABorder) {
    CPlane above = row;
    above.origin = {-100, -500, 800}, above.u = {200, 0, 0};
    constexpr double height = 400, width = 6, bulge = 0.9, end = 20;
    for (int i = 0; i < 22; ++i) {
        const double begin = -170 + 2.7 * i;
        ModelBuilder builder;
        const auto add_strip = [&](double from, double to, double further) {
            std::vector<Vec3> points;
            for (const double y : {from, (from + to) / 2, to}) {
                points.emplace_back(-2000, y, height);
                points.emplace_back(y > from && y < to ? end + further : end, y, height);
            }
            builder.patch(2, 1, points);
        };
        add_strip(-1000, begin, 0);
        add_strip(begin, begin + width, bulge);
        add_strip(begin + width, 1000, 0);
        const Under under{builder.build(), above};
        EXPECT_GE(under.expect_as_by_lines({Vec3(0)}, many_lines), 1);
    }
}

TEST(WidthPenumbra, WeighsAMeshOfRoundBars) {
    ModelBuilder builder;
    for (const double slant : {0.0, std::numbers::pi / 2})
        for (const Bar& bar : bars(4, 90, slant, 1100 + 20 * slant, {8, 8})) bar.add_round(builder);
    const std::vector<Vec3> points{{40, -200, 0}, {15, 160, 0}};
    EXPECT_GE(Under{builder.build()}.expect_as_by_lines(points, many_lines), 4);
}

} // namespace keiko
