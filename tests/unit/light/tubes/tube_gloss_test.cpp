#include "keiko/light/tubes/tube_gloss.h"

#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/gloss_kernel.h"

#include "tests/support/lobes.h"
#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

Gloss gloss_in(const test::OracleRow& row) {
    Gloss gloss{.distribution = test::distribution_in(row)};
    gloss.mode = row.text("in.mode") == "brdf" ? GlossMode::brdf : GlossMode::lobe;
    gloss.shadowing = test::shadowing_in(row);
    const double n = row.number("in.F_n"), k = row.number("in.F_k");
    if (row.text("in.F") == "dielectric") gloss.reflectance = Reflectance::dielectric(n);
    if (row.text("in.F") == "conductor") gloss.reflectance = Reflectance::metal({Rgb(n), Rgb(k)});
    return gloss;
}

double seen(const test::OracleRow& row, TubeOutline outline, GlossQuadrature quadrature) {
    const TubeLamp lamp{row.vector("in.A"), row.vector("in.B"), row.number("in.d"), Rgb(1), true};
    const Vec3 normal = row.unit("in.N");
    const Gloss gloss = gloss_in(row);
    const GlossKernel kernel(gloss, normal, row.unit("in.V"));
    const auto view = view_of(lamp, Vec3(0), normal);
    const TubeSlices slices(*view, {view->x_a, view->x_a + view->length, true, true}, outline);
    return row.number("in.Lsrc") * TubeGloss(slices, kernel).integral(quadrature).g;
}

} // namespace

TEST(TubeGloss, AgreesWithOracle) {
    const test::OracleTable table("specular_strip");
    test::WorstError strip("L_rect"), tube("L_cyl"), strip_in_pictures("L_rect picture"),
        in_pictures("L_cyl picture");
    for (const auto& row : table) {
        const double rect = row.number("out.L_rect"), cylinder = row.number("out.L_cyl");
        using enum GlossQuadrature;
        strip.compare(row, seen(row, TubeOutline::rectangle, number), rect, 1e-6);
        tube.compare(row, seen(row, TubeOutline::capped, number), cylinder, 1e-6);
        strip_in_pictures.compare(row, seen(row, TubeOutline::rectangle, picture), rect, 3e-4);
        in_pictures.compare(row, seen(row, TubeOutline::capped, picture), cylinder, 3e-4);
    }
}
