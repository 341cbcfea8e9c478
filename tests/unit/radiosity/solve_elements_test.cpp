#include "keiko/radiosity/solve_elements.h"

#include "keiko/radiosity/bounced_light.h"
#include "keiko/radiosity/element_rows.h"
#include "keiko/radiosity/exchange_areas.h"
#include "keiko/radiosity/gauss_seidel.h"
#include "keiko/radiosity/hemicube.h"
#include "keiko/radiosity/solution_file.h"

#include "tests/support/model_builder.h"
#include "tests/support/shapes.h"
#include "tests/unit/radiosity/box_room.h"
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

namespace keiko {
namespace {

const Vec3 room_size(2000, 3000, 1500);

SurfaceModel room_model(const Vec3& size, bool all_walls = true) {
    test::ModelBuilder builder;
    for (const auto& c : test::box_room(size))
        if (all_walls || c[0].z == 0 || c[1].z == 0 || c[2].z == 0)
            builder.plane(c[0], c[1] - c[0], c[3] - c[0]);
    return builder.build();
}

/// One lamp, alike on all fronts; backs are in the dark.
DirectLightOf on_inner_side(const Vec3& middle, double lx) {
    return [=](const LightPoint& at) {
        return std::vector<Rgb>{Rgb(at.normal.dot(middle - at.position) > 0 ? lx : 0)};
    };
}

const Box3 everywhere{Vec3(-1e9), Vec3(1e9)};
const std::vector<Rgb> level_1{Rgb(1)};

/// Elements of a model under lamps, solved.
struct Solved {
    SurfaceModel model;
    Tracer tracer;
    ElementSubdivision triangles;
    DirectLights direct;
    RadiositySolution solution;

    Solved(const SurfaceModel& of, const RadiositySpec& spec, std::span<const Rgb> rho,
           const DirectLightOf& light, std::span<const Rgb> levels = level_1, const Job& job = {})
        : model(of),
          tracer(model),
          triangles(model, spec.deviation, std::vector<bool>(model.faces.size())),
          direct(divide_and_light(triangles, model, spec, everywhere, levels, light)),
          solution(solve_elements({model, tracer, rho}, triangles.elements(), direct, levels, spec,
                                  job)) {}

    double emitted() const { return solution.balance.emitted.g; }
};

// In a closed room of one reflectance under one illuminance, whatever its shape, each reflection
// is rho times the last.
TEST(SolveElements, HasTheClosedFormOfAUniformRoom) {
    const std::vector<Rgb> rho(6, Rgb(0.8, 0.5, 0.1));
    const RadiositySpec spec{.element = 500, .rays = 256, .error = 1e-5};
    const Solved room(room_model(room_size), spec, rho, on_inner_side(room_size / 2, 100));
    for (const auto& [front, back] : room.solution.lamps[0].arriving) {
        EXPECT_NEAR(front.r, 100 * 0.8 / 0.2, 1e-3 * 400);
        EXPECT_NEAR(front.g, 100 * 0.5 / 0.5, 1e-3 * 100);
        EXPECT_EQ(back, Rgb());
    }
    const EnergyBalance& balance = room.solution.balance;
    EXPECT_LE(room.solution.remaining, spec.error);
    EXPECT_NEAR(balance.absorbed.r, balance.emitted.r, 1e-3 * balance.emitted.r);
    EXPECT_EQ(balance.escaped, Rgb());
}

TEST(SolveElements, MissesNoMoreLightThanRemains) {
    const std::vector<Rgb> rho(6, Rgb(0.3));
    for (const bool all_walls : {true, false}) {
        const Solved room(room_model(room_size, all_walls), {.rays = 1024, .error = 0.05}, rho,
                          on_inner_side(room_size / 2, 100));
        const EnergyBalance& balance = room.solution.balance;
        EXPECT_EQ(balance.escaped.g > 0.2 * room.emitted(), !all_walls);
        const double light = balance.emitted.g + balance.absorbed.g * 0.3 / 0.7;
        const double of_rays = 5e-3 * room.emitted();
        // What the last reflection brought is not absorbed yet; later ones bring 0.3 / 0.7 of it.
        const double last = room.solution.remaining * light * 0.7 / 0.3;
        EXPECT_LE(std::abs(balance.missing().g), last * (1 + 1e-9) + of_rays);
    }
}

TEST(SolveElements, IsAnIntegratingSphere) {
    const SurfaceModel model = test::ShapeBuilder().face(test::sphere(Vec3(0), 1000)).model();
    const RadiositySpec spec{.element = 600, .deviation = 40, .error = 1e-5};
    const Solved sphere(model, spec, std::vector<Rgb>{Rgb(0.6)}, on_inner_side(Vec3(0), 100));
    for (const SolvedTriangle& triangle : sphere.solution.triangles)
        for (const std::uint32_t corner : triangle.corners) {
            const auto& [front, back] = sphere.solution.lamps[0].arriving[corner];
            EXPECT_NEAR(back.g, 150, 1e-3 * 150);
            EXPECT_EQ(front, Rgb());
        }
}

// Triangles of a ball see each other where they are cut without regard to convexity.
TEST(SolveElements, LightsNoConvexBodyByItself) {
    const SurfaceModel model = test::ShapeBuilder().face(test::sphere(Vec3(0), 1000)).model();
    const DirectLightOf above = [](const LightPoint& at) {
        return std::vector<Rgb>{Rgb(at.normal.dot(at.position) > 0 ? 100 : 0)};
    };
    const Solved ball(model, {.element = 300, .deviation = 20}, std::vector<Rgb>{Rgb(0.8)}, above);
    EXPECT_GT(ball.emitted(), 10);
    for (const auto& [front, back] : ball.solution.lamps[0].arriving) EXPECT_EQ(front, Rgb());
    EXPECT_EQ(ball.solution.balance.absorbed, Rgb());
}

/// A room whose walls differ, of large elements without joints.
struct LargeElements {
    std::vector<Rgb> rho{Rgb(0.7), Rgb(0.2), Rgb(0.5), Rgb(0.8), Rgb(0.1), Rgb(0.6)};
    Solved room;

    LargeElements()
        : room(room_model(room_size), {.element = 900, .smallest = 900, .contrast = 1, .rays = 64},
               rho, [](const LightPoint& at) {
                   const bool inner = at.normal.dot(room_size / 2 - at.position) > 0;
                   return std::vector<Rgb>{Rgb(!inner                                ? 0
                                               : at.position.z > room_size.z * 0.999 ? 1000
                                                                                     : 50)};
               }) {}
};

// Rays and Gauss-Seidel with boundary integrals on the same elements.
TEST(SolveElements, AgreesWithBoundaryIntegralsAndGaussSeidel) {
    const LargeElements large;
    const ElementMesh& mesh = large.room.triangles.elements();
    const Elements elements(large.room.model, mesh);
    std::vector<std::vector<Vec3>> polygons;
    std::vector<Reflector> reflectors;
    for (std::size_t t = 0; t < mesh.size(); ++t) {
        polygons.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
        const Rgb of_face = large.rho[mesh.mesh.faces[t]];
        const std::size_t e = mesh.elements[t];
        reflectors.push_back({of_face, of_face * large.room.direct.by_lamp[0][e]});
        ASSERT_EQ(elements.triangles(e).size(), 1U);
    }
    const std::vector<SolvedTriangle> triangles = solved_triangles(mesh);
    const ElementLocator locator(large.room.model, mesh.uv, triangles);
    const GatherRays gather(large.room.tracer, locator, triangles, elements.size());
    ElementRows rows(elements, gather, 16384);
    std::vector<double> areas(rows.size());
    std::vector<Rgb> reflectances(rows.size()), exitance(rows.size());
    for (std::size_t t = 0; t < mesh.size(); ++t) {
        const std::size_t e = mesh.elements[t];
        areas[e] = elements.area(e);
        reflectances[e] = reflectors[t].reflectance, exitance[e] = reflectors[t].exitance;
    }
    rows.compute(std::vector<bool>(rows.size(), true), {});
    const BouncedLight bounced = bounced_light(rows, areas, reflectances, exitance, 1e-7);
    const SweptRadiosity exact = solve_by_gauss_seidel(test::open_exchange(polygons), reflectors);
    double worst = 0, mean = 0;
    for (std::size_t t = 0; t < mesh.size(); ++t) {
        const double found = bounced.radiosity[mesh.elements[t]].g;
        const double off = std::abs(found / exact.radiosity[t].g - 1);
        worst = std::max(worst, off), mean += off / static_cast<double>(mesh.size());
    }
    EXPECT_LT(mean, 0.003);
    EXPECT_LT(worst, 0.01);
}

TEST(ElementRows, AgreeWithHemicubes) {
    const SurfaceModel model = room_model(room_size);
    const Tracer tracer(model);
    ElementSubdivision triangles(model, 1, std::vector<bool>(6));
    triangles.cut([&](std::uint32_t t) { return triangles.elements().longest_side(t) > 1500; });
    std::vector<std::uint32_t> own(triangles.elements().size());
    std::iota(own.begin(), own.end(), 0U);
    triangles.join(own);
    const ElementMesh& mesh = triangles.elements();
    const Elements elements(model, mesh);
    const std::vector<SolvedTriangle> solved = solved_triangles(mesh);
    const ElementLocator locator(model, mesh.uv, solved);
    const GatherRays gather(tracer, locator, solved, elements.size());
    ElementRows rows(elements, gather, 65536);
    std::vector<bool> lit(rows.size());
    lit[0] = true;
    rows.compute(lit, {});
    EXPECT_EQ(rows.computed(), elements.size()); // no light reaches the backs
    const Hemicube cube(1024);
    const LightPoint middle = elements.point_of_triangle(0, Vec3(1.0 / 3));
    std::vector<double> by_rays(rows.size()),
        by_cube = cube.form_factors(mesh.mesh, middle.position, middle.normal);
    for (const MetElement& met : gather.met({&middle, 1}, 65536, 7))
        by_rays.at(met.face) += 1.0 / 65536;
    for (std::size_t face = 0; face < by_rays.size(); ++face)
        EXPECT_NEAR(by_rays[face], by_cube[face], 1e-3);
    double sum = 0;
    for (std::size_t to = 0; to < rows.size(); ++to) sum += rows.form_factor(0, to);
    EXPECT_NEAR(sum + rows.leaving(0), 1, 1e-6);
}

// Light is linear in the lamps: their solutions add.
TEST(SolveElements, KeepsEachLampApart) {
    const std::vector<Rgb> rho(6, Rgb(0.5)), levels{Rgb(3), Rgb(0.5)};
    const DirectLightOf two = [](const LightPoint& at) {
        const bool inner = at.normal.dot(room_size / 2 - at.position) > 0;
        return std::vector<Rgb>{Rgb(inner ? 100 : 0), Rgb(inner ? at.position.x : 0)};
    };
    const DirectLightOf sum = [&](const LightPoint& at) {
        const auto lux = two(at);
        return std::vector<Rgb>{lux[0] * levels[0] + lux[1] * levels[1]};
    };
    const RadiositySpec spec{.element = 700, .smallest = 700, .rays = 256, .error = 1e-9};
    const Solved apart(room_model(room_size), spec, rho, two, levels);
    const Solved both(room_model(room_size), spec, rho, sum);
    ASSERT_EQ(apart.solution.lamps.size(), 2U);
    ASSERT_EQ(apart.solution.corners.size(), both.solution.corners.size());
    for (std::size_t c = 0; c < both.solution.corners.size(); ++c) {
        const double whole = both.solution.lamps[0].arriving[c][0].g;
        const double added = apart.solution.lamps[0].arriving[c][0].g * 3 +
                             apart.solution.lamps[1].arriving[c][0].g * 0.5;
        EXPECT_NEAR(added, whole, 1e-6 * whole);
    }
}

TEST(DivideAndLight, CutsWhereLightChanges) {
    const SurfaceModel model =
        test::ShapeBuilder().face({test::rectangle(0, 2000, 0, 2000, 0)}).model();
    ElementSubdivision triangles(model, 1, {false});
    const RadiositySpec spec{.element = 1000, .smallest = 60, .contrast = 0.2};
    divide_and_light(triangles, model, spec, everywhere, level_1, [](const LightPoint& at) {
        return std::vector<Rgb>{Rgb(at.position.x > 700 ? 100 : 10)};
    });
    const Elements elements(model, triangles.elements());
    double near = 0, far = 1e9;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const double away = std::abs(elements.point(e, Vec2(0.5)).position.x - 700);
        if (away < 10) near = std::max(near, elements.extent(e));
        if (away > 900) far = std::min(far, elements.extent(e));
    }
    EXPECT_LE(near, 60);
    EXPECT_GT(far, 200);
    EXPECT_LT(elements.size(), 2000U);
}

TEST(DivideAndLight, TakesLargerElementsFarAway) {
    const SurfaceModel model =
        test::ShapeBuilder().face({test::rectangle(-1e5, 1e5, -1e5, 1e5, 0)}).model();
    ElementSubdivision triangles(model, 1, {false});
    const Box3 body{Vec3(-1000, -1000, 0), Vec3(1000, 1000, 1000)};
    divide_and_light(triangles, model, {.element = 300}, body, level_1,
                     [](const LightPoint&) { return std::vector<Rgb>{Rgb(1)}; });
    const Elements elements(model, triangles.elements());
    EXPECT_LT(elements.size(), 3000U);
    for (std::size_t e = 0; e < elements.size(); ++e)
        if (elements.point(e, Vec2(0.5)).position.length() < 800) {
            EXPECT_LE(elements.extent(e), 430); // of the box; no side is above 300
        }
}

// A thousand triangles of a finely divided ball are few elements.
TEST(DivideAndLight, JoinsTriangles) {
    const SurfaceModel model = test::ShapeBuilder().face(test::sphere(Vec3(0), 1000)).model();
    ElementSubdivision triangles(model, 0.5, {false});
    const std::size_t count = triangles.elements().size();
    divide_and_light(triangles, model, {.element = 500}, everywhere, level_1,
                     [](const LightPoint&) { return std::vector<Rgb>{Rgb(1)}; });
    const Elements elements(model, triangles.elements());
    EXPECT_EQ(triangles.elements().size(), count);
    EXPECT_GT(count, 10 * elements.size());
    double area = 0;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        EXPECT_LE(elements.extent(e), 500);
        area += elements.area(e);
    }
    EXPECT_NEAR(area, 4 * std::numbers::pi * 1e6, 2e-3 * 4 * std::numbers::pi * 1e6);
}

TEST(SolveElements, StopsWithAValidPart) {
    std::stop_source stop;
    Job job{};
    job.stop = stop.get_token();
    job.progress = [&](const Progress& at) {
        if (at.stage == "form factors" && at.fraction > 0.3) stop.request_stop();
    };
    const StopScope scope(job); // as commands have it
    const RadiositySpec spec{.element = 300};
    const Solved part(room_model(room_size), spec, std::vector<Rgb>(6, Rgb(0.5)),
                      on_inner_side(room_size / 2, 100), level_1, job);
    RadiositySolution solution = part.solution;
    EXPECT_GT(solution.factor_rows, 0U);
    EXPECT_LT(solution.factor_rows, solution.elements);
    // The rows that are not done have fewer rays, so that the light is there.
    for (const auto& [front, back] : solution.lamps[0].arriving) EXPECT_NEAR(front.g, 100, 1);
    solution.geometry = std::string(64, 'a'), solution.lighting = std::string(64, 'b');
    EXPECT_EQ(parse_solution(solution_text(solution), "part").factor_rows, solution.factor_rows);
}

} // namespace
} // namespace keiko
