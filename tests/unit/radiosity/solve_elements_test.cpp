#include "keiko/radiosity/solve_elements.h"

#include "keiko/radiosity/exchange_areas.h"
#include "keiko/radiosity/gauss_seidel.h"
#include "keiko/radiosity/solution_file.h"

#include "tests/support/model_builder.h"
#include "tests/support/shapes.h"
#include "tests/unit/radiosity/box_room.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

SurfaceModel room_model(const Vec3& size) {
    test::ModelBuilder builder;
    for (const auto& c : test::box_room(size)) builder.plane(c[0], c[1] - c[0], c[3] - c[0]);
    return builder.build();
}

/// Elements of a model, all fronts under `front` lx, all backs in the dark.
struct Solved {
    ElementSubdivision elements;
    std::vector<std::array<Rgb, 2>> direct;
    RadiositySolution solution;

    Solved(const SurfaceModel& model, const RadiositySpec& spec, std::span<const Rgb> rho,
           const DirectLightOf& light, const Box3& near = {Vec3(-1e9), Vec3(1e9)})
        : elements(model, spec.deviation, std::vector<bool>(model.faces.size())),
          direct(light_elements(elements, spec, near, light)),
          solution(solve_elements(elements.elements(), direct, rho, spec)) {}

    double emitted() const { return solution.balance.emitted.g; }
};

DirectLightOf uniform(double lx) {
    return [lx](const ElementMesh&, std::uint32_t) { return std::array<Rgb, 2>{Rgb(lx), Rgb()}; };
}

// In a closed room of one reflectance under one illuminance, whatever its shape, each reflection
// is rho times the last.
TEST(SolveElements, HasTheClosedFormOfAUniformRoom) {
    const std::vector<Rgb> rho(6, Rgb(0.8, 0.5, 0.1));
    const RadiositySpec spec{.element = 500, .error = 1e-4};
    const Solved room(room_model({2000, 3000, 1500}), spec, rho, uniform(100));
    const double last = 100 * 0.8 / 0.2, middle = 100 * 0.5 / 0.5;
    for (const auto& [front, back] : room.solution.light) {
        EXPECT_NEAR(front.arriving.r, last, 1e-2 * last);
        EXPECT_NEAR(front.arriving.g, middle, 1e-2 * middle);
        EXPECT_LT(back.arriving.r, 1e-3 * last);
    }
    const EnergyBalance& balance = room.solution.balance;
    EXPECT_LE(room.solution.remaining, spec.error);
    EXPECT_NEAR(balance.absorbed.r, balance.emitted.r, 1e-3 * balance.emitted.r);
    EXPECT_LT(std::abs(balance.escaped.r), 1e-4 * balance.emitted.r);
}

// Of a room without a wall, whose light is followed but half of the way, no more is missing.
TEST(SolveElements, MissesNoMoreLightThanRemains) {
    const Solved closed(room_model({2000, 3000, 1500}), {.error = 0.05},
                        std::vector<Rgb>(6, Rgb(0.1)), uniform(100));
    test::ModelBuilder builder;
    for (const auto& c : test::box_room({2000, 3000, 1500}))
        if (c[0].z == 0 || c[1].z == 0 || c[2].z == 0)
            builder.plane(c[0], c[1] - c[0], c[3] - c[0]);
    const Solved open(builder.build(), {.error = 0.05}, std::vector<Rgb>(5, Rgb(0.1)),
                      uniform(100));
    EXPECT_LT(std::abs(closed.solution.balance.escaped.g), 1e-6 * closed.emitted());
    EXPECT_GT(open.solution.balance.escaped.g, 0.2 * open.emitted());
    for (const Solved* room : {&closed, &open}) {
        const EnergyBalance& balance = room->solution.balance;
        const double light = balance.emitted.g + balance.absorbed.g * 0.1 / 0.9;
        const double of_factors = 2e-3 * balance.emitted.g;
        EXPECT_GT(room->solution.remaining, 0.01);
        EXPECT_LE(std::abs(balance.missing().g), room->solution.remaining * light + of_factors);
    }
}

TEST(SolveElements, IsAnIntegratingSphere) {
    const SurfaceModel model = test::ShapeBuilder().face(test::sphere(Vec3(0), 1000)).model();
    const RadiositySpec spec{.element = 600, .deviation = 40, .error = 1e-3};
    const DirectLightOf inside = [](const ElementMesh&, std::uint32_t) {
        return std::array<Rgb, 2>{Rgb(), Rgb(100)};
    };
    const Solved sphere(model, spec, std::vector<Rgb>{Rgb(0.6)}, inside);
    double mean = 0, area = 0;
    for (std::size_t t = 0; t < sphere.elements.elements().size(); ++t) {
        const double size = sphere.elements.elements().area(t);
        mean += size * sphere.solution.light[t][1].arriving.g, area += size;
        EXPECT_LT(sphere.solution.light[t][0].arriving.g, 1);
    }
    EXPECT_NEAR(mean / area, 100 * 0.6 / 0.4, 0.02 * 150);
}

// Both factor methods and both solvers on the same elements.
TEST(SolveElements, AgreesWithBoundaryIntegralsAndGaussSeidel) {
    const SurfaceModel model = room_model({2000, 3000, 1500});
    const std::vector<Rgb> rho{Rgb(0.7), Rgb(0.2), Rgb(0.5), Rgb(0.8), Rgb(0.1), Rgb(0.6)};
    const RadiositySpec spec{.element = 900, .smallest = 900, .cells = 128, .error = 1e-5};
    const DirectLightOf light = [](const ElementMesh& mesh, std::uint32_t t) {
        return std::array<Rgb, 2>{Rgb(mesh.mesh.faces[t] == 5 ? 1000 : 50), Rgb()};
    };
    const Solved room(model, spec, rho, light);
    const ElementMesh& mesh = room.elements.elements();
    std::vector<std::vector<Vec3>> polygons;
    std::vector<Reflector> reflectors;
    for (std::size_t t = 0; t < mesh.size(); ++t) {
        polygons.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
        const Rgb of_face = rho[mesh.mesh.faces[t]];
        reflectors.push_back({of_face, of_face * room.direct[t][0]});
    }
    const SweptRadiosity exact = solve_by_gauss_seidel(test::open_exchange(polygons), reflectors);
    double worst = 0, mean = 0;
    for (std::size_t t = 0; t < mesh.size(); ++t) {
        const double off =
            std::abs(room.solution.light[t][0].radiosity.g / exact.radiosity[t].g - 1);
        worst = std::max(worst, off), mean += off / static_cast<double>(mesh.size());
    }
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LT(mean, 0.003);
    EXPECT_LT(worst, 0.01);
}

TEST(SolveElements, CutsWhereLightChanges) {
    const SurfaceModel model =
        test::ShapeBuilder().face({test::rectangle(0, 2000, 0, 2000, 0)}).model();
    const RadiositySpec spec{.element = 1000, .smallest = 60, .contrast = 0.2};
    const DirectLightOf shadow = [](const ElementMesh& mesh, std::uint32_t t) {
        return std::array<Rgb, 2>{Rgb(mesh.middle(t).x > 700 ? 100 : 10), Rgb()};
    };
    const Solved floor(model, spec, std::vector<Rgb>{Rgb(0.5)}, shadow);
    const ElementMesh& mesh = floor.elements.elements();
    double near = 0, far = 1e9;
    for (std::size_t t = 0; t < mesh.size(); ++t) {
        const double away = std::abs(mesh.middle(t).x - 700);
        if (away < 10) near = std::max(near, mesh.longest_side(t));
        if (away > 900) far = std::min(far, mesh.longest_side(t));
    }
    EXPECT_LE(near, 60);
    EXPECT_GT(far, 200);
    EXPECT_LT(mesh.size(), 2000U);
}

TEST(SolveElements, TakesLargerElementsFarAway) {
    const SurfaceModel model =
        test::ShapeBuilder().face({test::rectangle(-1e5, 1e5, -1e5, 1e5, 0)}).model();
    ElementSubdivision elements(model, 1, {false});
    const RadiositySpec spec{.element = 300};
    const Box3 body{Vec3(-1000, -1000, 0), Vec3(1000, 1000, 1000)};
    light_elements(elements, spec, body, uniform(1));
    EXPECT_LT(elements.elements().size(), 3000U);
    for (std::size_t t = 0; t < elements.elements().size(); ++t)
        if (elements.elements().middle(t).length() < 800) {
            EXPECT_LE(elements.elements().longest_side(t), 300);
        }
}

TEST(SolveElements, StopsWithAValidPart) {
    const SurfaceModel model = room_model({2000, 3000, 1500});
    ElementSubdivision elements(model, 1, std::vector<bool>(6));
    const RadiositySpec spec{.error = 1e-5};
    const auto direct = light_elements(elements, spec, {}, uniform(100));
    std::stop_source stop;
    Job job{};
    job.stop = stop.get_token();
    job.progress = [&](const Progress& at) {
        if (at.fraction > 0.3) stop.request_stop();
    };
    const auto part =
        solve_elements(elements.elements(), direct, std::vector<Rgb>(6, Rgb(0.5)), spec, job);
    EXPECT_GT(part.remaining, 1e-5);
    EXPECT_LT(part.remaining, 1);
    EXPECT_GT(part.light[0][0].arriving.r, 0);
    EXPECT_GT(part.balance.missing().r, 1e-3 * part.balance.emitted.r);
    EXPECT_EQ(
        parse_solution(solution_text({std::string(64, 'a'), std::string(64, 'b'), part.remaining,
                                      part.balance, part.corners, part.triangles, part.light}),
                       "part")
            .remaining,
        part.remaining);
}

} // namespace
} // namespace keiko
