#include "keiko/radiosity/element_subdivision.h"

#include "keiko/base/error.h"

#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

namespace keiko {
namespace {

SurfaceModel ball() {
    return test::ShapeBuilder().face(test::sphere({100, 0, 0}, 500)).model();
}

SurfaceModel holed_plate() {
    return test::ShapeBuilder()
        .face({test::rectangle(0, 1000, 0, 1000, 0)},
              {test::polygon({{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}),
               test::circle({500, 500}, 200)})
        .model();
}

double area_of(const ElementMesh& elements) {
    double sum = 0;
    for (std::size_t t = 0; t < elements.size(); ++t) sum += elements.area(t);
    return sum;
}

/// Number of corners that lie inside of a side of a triangle.
int corners_on_sides(const ElementMesh& elements) {
    int found = 0;
    for (std::size_t t = 0; t < elements.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = elements.corner(t, i), way = elements.corner(t, (i + 1) % 3) - a;
            for (const Vec3& p : elements.mesh.positions) {
                const double along = way.dot(p - a) / way.length2();
                const double off = (p - a - way * along).length();
                if (along > 1e-6 && along < 1 - 1e-6 && off < 1e-6 * way.length()) ++found;
            }
        }
    return found;
}

TEST(ElementSubdivision, CutsUntilNoneIsWanted) {
    const SurfaceModel model =
        test::ShapeBuilder().face({test::rectangle(0, 1000, 0, 600, 0)}).model();
    ElementSubdivision elements(model, 1, {false});
    EXPECT_EQ(elements.elements().size(), 2U);
    const auto changed =
        elements.cut([&](std::uint32_t t) { return elements.elements().longest_side(t) > 130; });
    EXPECT_GT(elements.elements().size(), 100U);
    EXPECT_EQ(changed.size(), elements.elements().size());
    EXPECT_NEAR(area_of(elements.elements()), 600e3, 1e-6);
    for (std::size_t t = 0; t < elements.elements().size(); ++t) {
        EXPECT_LE(elements.elements().longest_side(t), 130);
        EXPECT_GT(elements.elements().normal(t).z, 0);
    }
    EXPECT_EQ(corners_on_sides(elements.elements()), 0);
}

TEST(ElementSubdivision, LeavesNoCornerOnASideWhereOnePlaceIsFine) {
    const SurfaceModel model =
        test::ShapeBuilder().face({test::rectangle(0, 1000, 0, 600, 0)}).model();
    ElementSubdivision elements(model, 1, {false});
    elements.cut([&](std::uint32_t t) {
        const double away = (elements.elements().middle(t) - Vec3(310, 270, 0)).length();
        return elements.elements().longest_side(t) > std::max(5.0, away / 2);
    });
    EXPECT_GT(elements.elements().size(), 100U);
    EXPECT_LT(elements.elements().size(), 1500U);
    EXPECT_EQ(corners_on_sides(elements.elements()), 0);
    EXPECT_NEAR(area_of(elements.elements()), 600e3, 1e-6);
}

TEST(ElementSubdivision, PutsNewCornersOnTheExactSurface) {
    const SurfaceModel model = ball();
    ElementSubdivision elements(model, 20, {false});
    const std::size_t before = elements.elements().mesh.positions.size();
    elements.cut([&](std::uint32_t t) { return elements.elements().longest_side(t) > 60; });
    const ElementMesh& mesh = elements.elements();
    EXPECT_GT(mesh.mesh.positions.size(), 2 * before);
    for (const Vec3& p : mesh.mesh.positions)
        EXPECT_NEAR((p - Vec3(100, 0, 0)).length(), 500, 1e-9);
    for (std::size_t t = 0; t < mesh.size(); ++t)
        EXPECT_GT(mesh.normal(t).dot(mesh.middle(t) - Vec3(100, 0, 0)), 0);
    EXPECT_NEAR(area_of(mesh) / (4 * std::numbers::pi * 500 * 500), 1, 7e-3); // chords
}

TEST(ElementSubdivision, KeepsHolesAndPlacesInstances) {
    test::ShapeBuilder builder;
    builder.face({test::rectangle(0, 1000, 0, 1000, 0)},
                 {test::polygon({{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}),
                  test::circle({500, 500}, 200)});
    Affine mirrored = Affine::translate({0, 0, 700});
    mirrored.rows[2] = Vec3(0, 0, -1);
    builder.place({Affine{}, mirrored});
    const SurfaceModel model = builder.model();
    ElementSubdivision elements(model, 1, {false});
    elements.cut([&](std::uint32_t t) { return elements.elements().longest_side(t) > 200; });
    EXPECT_NEAR(area_of(elements.elements()), 2 * (1e6 - std::numbers::pi * 200 * 200), 2000);
    std::map<std::uint32_t, std::set<double>> heights;
    for (std::size_t t = 0; t < elements.elements().size(); ++t) {
        const std::uint32_t instance = elements.elements().instances[t];
        heights[instance].insert(elements.elements().middle(t).z);
        EXPECT_GT(elements.elements().normal(t).z * (instance == 0 ? 1 : -1), 0);
    }
    EXPECT_EQ(heights[0], std::set<double>{0});
    EXPECT_EQ(heights[1], std::set<double>{700});
}

TEST(ElementSubdivision, LeavesOutFacesAndRefusesTooMany) {
    const SurfaceModel model = holed_plate();
    EXPECT_EQ(ElementSubdivision(model, 1, {true}).elements().size(), 0U);
    ElementSubdivision elements(model, 1, {false});
    EXPECT_THROW(elements.cut([](std::uint32_t) { return true; }), FieldError);
}

TEST(ElementSubdivision, KnowsNeighbours) {
    const SurfaceModel model =
        test::ShapeBuilder().face({test::rectangle(0, 100, 0, 100, 0)}).model();
    ElementSubdivision elements(model, 1, {false});
    EXPECT_EQ(elements.neighbours().size(), 1U);
    elements.cut([&](std::uint32_t t) { return elements.elements().longest_side(t) > 110; });
    EXPECT_EQ(elements.elements().size(), 4U);
    EXPECT_EQ(elements.neighbours().size(), 4U);
}

} // namespace
} // namespace keiko
