#include "keiko/maps/surface_maps.h"

#include <gtest/gtest.h>

#include <array>

namespace keiko {
namespace {

MaterialMap checkers(MappedQuantity drives) {
    MaterialMap map;
    map.drives = drives;
    map.texture = {.kind = TextureKind::checker, .size = 10};
    return map;
}

/// On a floor, seen from above, without a pixel.
MapPlace place_at(double x, double y) {
    return {.position = {x, y, 1}, .normal = {0, 0, 1}};
}

TEST(SurfaceMaps, MapsOfOneQuantityMultiply) {
    MaterialMap first = checkers(MappedQuantity::diffuse), second = first;
    first.low = Rgb(0.5, 0.2, 1), first.high = Rgb(1);
    second.low = Rgb(0.4), second.high = Rgb(1);
    second.factor = 0.5;
    const std::array maps{first, second, checkers(MappedQuantity::gloss)};
    const MapValues dark = SurfaceMaps(maps).values(place_at(5, 5));
    EXPECT_NEAR(dark.diffuse.r, 0.5 * 0.7, 1e-15);
    EXPECT_NEAR(dark.diffuse.g, 0.2 * 0.7, 1e-15);
    EXPECT_EQ(dark.gloss, Rgb(0));
    EXPECT_EQ(dark.roughness, 1);
    const MapValues light = SurfaceMaps(maps).values(place_at(15, 5));
    EXPECT_EQ(light.diffuse, Rgb(1));
    EXPECT_EQ(light.gloss, Rgb(1));
}

TEST(SurfaceMaps, RegionBoundsTheMap) {
    MaterialMap map = checkers(MappedQuantity::transmission);
    map.high = Rgb(0); // 0 everywhere in the region
    map.region = MapRegion{.projection = {.kind = ProjectionKind::planar},
                           .corners = {{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
    const SurfaceMaps maps(std::array{map});
    EXPECT_EQ(maps.values(place_at(100, 100)).transmission, Rgb(0));
    EXPECT_EQ(maps.values(place_at(600, 100)).transmission, Rgb(1));
    MapPlace border = place_at(500, 100);
    border.dx = Vec3(10, 0, 0), border.dy = Vec3(0, 10, 0);
    EXPECT_NEAR(maps.values(border).transmission.g, 0.5, 1e-12);
}

/// Rounding of a hit does not choose the layer of a face between two: it is the body's own.
TEST(SurfaceMaps, FaceBetweenLayersShowsTheOneBeneath) {
    for (const ProjectionKind kind : {ProjectionKind::solid, ProjectionKind::planar}) {
        MaterialMap map = checkers(MappedQuantity::emission);
        map.projection.kind = kind;
        map.projection.u = Vec3(10, 0, 0), map.projection.v = Vec3(0, 0, 10);
        const SurfaceMaps maps(std::array{map});
        for (const double rounding : {-1e-12, 0.0, 1e-12})
            for (const double up : {1.0, -1.0})
                for (const bool from_inside : {false, true}) {
                    MapPlace place{{5, 5, 20 + rounding}, {0, 0, up}};
                    place.from_inside = from_inside;
                    const bool body_above = (up < 0) != from_inside; // of the layer of 20 to 30
                    EXPECT_EQ(maps.values(place).emission, Rgb(body_above ? 0 : 1))
                        << rounding << up << from_inside;
                }
    }
}

TEST(SurfaceMaps, TexturesGoWithTheModel) {
    MaterialMap map = checkers(MappedQuantity::diffuse);
    map.placement = Affine::translate({10, 0, 0}) * Affine::scale(2);
    const SurfaceMaps maps(std::array{map});
    EXPECT_EQ(maps.values(place_at(20, 10)).diffuse, Rgb(0)); // 5, 5 of the model
    EXPECT_EQ(maps.values(place_at(40, 10)).diffuse, Rgb(1)); // 15, 5
}

TEST(SurfaceMaps, HeightsAddUp) {
    MaterialMap map;
    map.drives = MappedQuantity::bump;
    map.texture = {.kind = TextureKind::noise, .size = 30};
    map.high = Rgb(2);
    const SurfaceMaps one(std::array{map}), both(std::array{map, map});
    const HeightJet a = *one.height(place_at(7, 8)), b = *both.height(place_at(7, 8));
    EXPECT_DOUBLE_EQ(b.value, 2 * a.value);
    EXPECT_LT((b.gradient - a.gradient * 2).length(), 1e-15);
    EXPECT_GT(a.gradient.length(), 0);
    const double after = one.height(place_at(7.1, 8))->value;
    const double before = one.height(place_at(6.9, 8))->value;
    EXPECT_NEAR(a.gradient.x, (after - before) / 0.2, 1e-3 * a.gradient.length());
    EXPECT_NEAR(a.second[0].x, (after - 2 * a.value + before) / 0.01, 0.02 * a.second[0].length());
}

TEST(SurfaceMaps, FlatNormalMapLeavesTheNormal) {
    MaterialMap map = checkers(MappedQuantity::normal);
    map.low = map.high = Rgb(0, 0, 1);
    map.projection.kind = ProjectionKind::planar;
    const SurfaceMaps flat(std::array{map});
    EXPECT_LT((*flat.normal(place_at(5, 5)) - Vec3(0, 0, 1)).length(), 1e-15);
    map.low = map.high = Rgb(1, 0, 1);
    const Vec3 tilted = *SurfaceMaps(std::array{map}).normal(place_at(5, 5));
    EXPECT_LT((tilted - Vec3(1, 0, 1).normalized()).length(), 1e-12); // towards rising u
}

} // namespace
} // namespace keiko
