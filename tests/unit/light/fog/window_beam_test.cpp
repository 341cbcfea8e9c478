#include "keiko/light/fog/window_beam.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

PhaseFunction phase_in(const test::OracleRow& row) {
    if (row.text("in.kind") == "hg") return HenyeyGreenstein{row.number("in.par")};
    return HazePhase{row.text("in.kind") == "k16" ? row.number("in.par") : 0};
}

Window square() {
    return {{{0, 0, 0}, {0, 1000, 0}, {0, 1000, 1000}, {0, 0, 1000}}};
}

} // namespace

TEST(WindowBeam, AgreesWithOracle) {
    const test::OracleTable table("window_shaft");
    test::WorstError ends("lit"), light("L_scatter"), quadrature("L_scatter by quadrature");
    for (const auto& row : table) {
        Window window;
        for (const Vec3& corner : row.points("in.window")) window.corners.push_back(corner * 1000);
        const double length = row.number("in.l");
        const Vec3 eye = row.vector("in.O") * 1000, sun = row.unit("in.dir");
        const Segment ray{eye, eye + row.unit("in.w") * (length * 1000)};
        const IntervalSet lit = in_window_beam(window, sun, ray);
        const std::vector<double> expected = row.list("out.lit");
        ASSERT_EQ(2 * lit.size(), expected.size()) << row.id();
        for (std::size_t i = 0; i < lit.size(); ++i) {
            ends.compare(row, lit[i].begin, expected[2 * i] / length, 1e-10);
            ends.compare(row, lit[i].end, expected[2 * i + 1] / length, 1e-10);
        }
        Medium medium{.extinction = Rgb(row.number("in.sigma")),
                      .albedo = Rgb(row.number("in.w0")),
                      .phase = phase_in(row),
                      .dims_light_leg = row.text("in.leg") == "1"};
        const ParallelBeam beam{sun, Rgb(row.number("in.E0")), window};
        light.compare(row, scattered_light({medium, ray}, lit, beam).g, row.number("out.L_scatter"),
                      1e-11);
        // The same medium as two layers that are alike.
        medium.density = LayeredDensity{{.height = 1500}, medium.extinction};
        quadrature.compare(row, scattered_light({medium, ray}, lit, beam).g,
                           row.number("out.L_scatter"), 1e-8);
    }
}

TEST(WindowBeam, FillsTheHolesOfAConcaveWindowNot) {
    // A U: the gap is open at the top.
    const Window u{{{0, 0, 0},
                    {0, 900, 0},
                    {0, 900, 900},
                    {0, 600, 900},
                    {0, 600, 300},
                    {0, 300, 300},
                    {0, 300, 900},
                    {0, 0, 900}}};
    const Segment across{{500, -900, 600}, {500, 1800, 600}};
    const IntervalSet lit = in_window_beam(u, {1, 0, 0}, across);
    ASSERT_EQ(lit.size(), 2u);
    EXPECT_NEAR(lit[0].end, 1200 / 2700.0, 1e-12);
    EXPECT_NEAR(lit[1].begin, 1500 / 2700.0, 1e-12);
}

TEST(WindowBeam, LiesBehindTheWindowAlone) {
    const Vec3 sun = Vec3(1, 0, -1).normalized();
    EXPECT_NEAR(way_from_window(square(), sun, {500, 500, 100}).value(), 500 * std::sqrt(2), 1e-9);
    EXPECT_FALSE(way_from_window(square(), sun, {-500, 500, 900}));
    EXPECT_FALSE(way_from_window(square(), sun, {500, 1100, 100}));
    EXPECT_FALSE(way_from_window(square(), {0, 1, 0}, {0, 500, 100}));
    EXPECT_TRUE(in_window_beam(square(), sun, {{-100, 500, 500}, {-2000, 500, 500}}).empty());
}
