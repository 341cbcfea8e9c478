#include "keiko/workflow/zoned_limits.h"

#include "keiko/workflow/visible_shares.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

/// Four sheets of 100 mm side by side along x, with names, layers and colours.
SurfaceModel sheets() {
    test::ModelBuilder builder;
    for (int i = 0; i < 4; ++i) builder.plane({100.0 * i, 0, 0}, {100, 0, 0}, {0, 100, 0});
    SurfaceModel model = builder.build();
    model.faces[0].name = "roof-left", model.faces[1].name = "roof-right";
    model.faces[2].name = "flange", model.faces[0].layer = "SKIN", model.faces[3].layer = "SKIN-2";
    model.faces[1].color = Rgb(1, 0, 0), model.faces[2].color = Rgb(0, 0.5, 1);
    return model;
}

/// A box of 100 mm with a sheet inside; its face 6 is the sheet, face 0 the bottom.
SurfaceModel box_with_sheet() {
    const double a = 100;
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {a, 0, 0}, {0, a, 0});
    builder.plane({0, 0, a}, {a, 0, 0}, {0, a, 0});
    builder.plane({0, 0, 0}, {a, 0, 0}, {0, 0, a});
    builder.plane({0, a, 0}, {a, 0, 0}, {0, 0, a});
    builder.plane({0, 0, 0}, {0, a, 0}, {0, 0, a});
    builder.plane({a, 0, 0}, {0, a, 0}, {0, 0, a});
    builder.plane({20, 20, 50}, {60, 0, 0}, {0, 60, 0});
    return builder.build();
}

Zone zone(const std::string& name, const FaceSelection& selection) {
    Zone zone;
    zone.name = name, zone.file = "limits.toml", zone.selection = selection;
    return zone;
}

FaceSelection named(const std::vector<std::string>& faces) {
    FaceSelection selection;
    selection.faces = faces;
    return selection;
}

/// The zones of the faces of a model, by their numbers.
std::vector<std::uint32_t> zones_in(const SurfaceModel& model, const std::vector<Zone>& zones) {
    CriteriaPreset preset;
    preset.zones = zones;
    const FaceLimits limits = zoned_limits({model}, preset, {}, {});
    std::vector<std::uint32_t> found;
    for (const PlacedFace& face : placed_faces(model)) found.push_back(limits.zone_of(face));
    return found;
}

/// The numbers of the faces in a scope, from 0.
std::vector<std::uint32_t> faces_in(const SurfaceModel& model, const Scope& scope,
                                    const CriteriaPreset& preset = {}) {
    const FaceLimits limits = zoned_limits({model}, preset, scope, {});
    std::vector<std::uint32_t> found;
    for (const PlacedFace& face : placed_faces(model))
        if (limits.in_scope(face)) found.push_back(face.face);
    return found;
}

template <class Do>
std::string error_of(const Do& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

using Numbers = std::vector<std::uint32_t>;

TEST(ZonedLimits, AreThoseOfThePresetWithoutZonesAndScope) {
    const SurfaceModel model = sheets();
    EXPECT_FALSE(zoned_limits({model}, {}, {}, {}).has_zones_or_scope());
}

TEST(ZonedLimits, SelectByNameNumberLayerAndColour) {
    const SurfaceModel model = sheets();
    EXPECT_EQ(zones_in(model, {zone("A", named({"roof-*"}))}), (Numbers{0, 0, no_zone, no_zone}));
    EXPECT_EQ(zones_in(model, {zone("A", named({"4", "fl?nge"}))}),
              (Numbers{no_zone, no_zone, 0, 0}));
    FaceSelection layer, color;
    layer.layers = {"SKIN*"};
    EXPECT_EQ(zones_in(model, {zone("A", layer)}), (Numbers{0, no_zone, no_zone, 0}));
    color.colors = {FaceColor::parse("#00bcff")};
    EXPECT_EQ(zones_in(model, {zone("A", color)}), (Numbers{no_zone, no_zone, 0, no_zone}));
    layer.faces = {"roof-*"};
    EXPECT_EQ(zones_in(model, {zone("A", layer)}), (Numbers{0, no_zone, no_zone, no_zone}))
        << "all conditions at once";
}

TEST(ZonedLimits, SelectByABoxWhatLiesWhollyInIt) {
    SurfaceModel model = sheets();
    FaceSelection boxed;
    boxed.box = Box3{Vec3(0, 0, -1), Vec3(250, 100, 1)};
    EXPECT_EQ(zones_in(model, {zone("A", boxed)}), (Numbers{0, 0, no_zone, no_zone}));
    // What trims leave of a face counts, not its control points.
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.polygon({{0.1, 0.1}, {0.3, 0.1}, {0.3, 0.3}, {0.1, 0.3}});
    boxed.box = Box3{Vec3(5, 5, -1), Vec3(35, 35, 1)};
    EXPECT_EQ(zones_in(builder.build(), {zone("A", boxed)}), (Numbers{0}));
    boxed.box = Box3{Vec3(15, 5, -1), Vec3(35, 35, 1)};
    EXPECT_NE(error_of([&] { zones_in(builder.build(), {zone("A", boxed)}); }).find("no face"),
              std::string::npos);
}

TEST(ZonedLimits, SelectByABoxThePlacedFace) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.instance({});
    Affine moved;
    moved.translation = Vec3(1000, 0, 0);
    builder.instance(moved);
    FaceSelection boxed;
    boxed.box = Box3{Vec3(900, -1, -1), Vec3(1200, 200, 1)};
    EXPECT_EQ(zones_in(builder.build(), {zone("A", boxed)}), (Numbers{no_zone, 0}));
}

TEST(ZonedLimits, GiveAFaceToTheFirstZoneThatSelectsIt) {
    const SurfaceModel model = sheets();
    EXPECT_EQ(zones_in(model, {zone("A", named({"roof-left"})), zone("B", named({"*"}))}),
              (Numbers{0, 1, 1, 1}));
    EXPECT_EQ(error_of([&] {
                  zones_in(model, {zone("B", named({"*"})), zone("A", named({"roof-left"}))});
              }),
              "limits.toml:zone 'A': each of its faces belongs to an earlier zone");
}

TEST(ZonedLimits, RefuseAZoneWithoutFaces) {
    const SurfaceModel model = sheets();
    EXPECT_EQ(error_of([&] {
                  zones_in(model, {zone("A", named({"roof-*", "door"}))});
              }),
              "limits.toml:zone 'A', faces: no face has the number or a name like 'door'");
    FaceSelection layer = named({"flange"});
    layer.layers = {"SKIN"};
    EXPECT_EQ(error_of([&] { zones_in(model, {zone("A", layer)}); }),
              "limits.toml:zone 'A': no face meets all its conditions: faces flange, layers SKIN");
    layer.layers = {"skin"};
    EXPECT_EQ(error_of([&] { zones_in(model, {zone("A", layer)}); }),
              "limits.toml:zone 'A', layers: no face is on a layer like 'skin'; there are SKIN, "
              "SKIN-2");
    FaceSelection color;
    color.colors = {FaceColor::parse("#ff0001")};
    EXPECT_EQ(error_of([&] { zones_in(model, {zone("A", color)}); }),
              "limits.toml:zone 'A', colors: no face has the colour #ff0001; there are #00bcff, "
              "#ff0000");
}

TEST(VisibleShares, AreThoseThatStandingViewsShow) {
    const SurfaceModel model = box_with_sheet();
    const std::vector<double> shares = visible_shares(model, Tracer(model), {}, {});
    ASSERT_EQ(shares.size(), 7u);
    EXPECT_EQ(shares[0], 0) << "nobody sees the bottom";
    for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(shares[i], 1) << i;
    EXPECT_EQ(shares[6], 0) << "nor what is inside";
}

TEST(VisibleShares, AreSharesOfTheArea) {
    // A roof over 60 of the 100 mm of a floor, so low that no eye looks under it.
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {1000, 0, 0}, {0, 100, 0});
    builder.plane({-1, -1, 0.5}, {1002, 0, 0}, {0, 61, 0});
    const SurfaceModel model = builder.build();
    EXPECT_NEAR(visible_shares(model, Tracer(model), {}, {})[0], 0.4, 0.02);
}

TEST(ZonedLimits, FindTheOuterSkin) {
    Scope scope;
    scope.zones = {std::string(outer_skin)};
    EXPECT_EQ(faces_in(box_with_sheet(), scope), (Numbers{1, 2, 3, 4, 5}));
    FaceSelection visible;
    visible.visible = 0.9;
    EXPECT_EQ(zones_in(box_with_sheet(), {zone("A", visible)}),
              (Numbers{no_zone, 0, 0, 0, 0, 0, no_zone}));
}

TEST(Scope, IsWhatItsConditionsAndAnyOfItsZonesHold) {
    const SurfaceModel model = sheets();
    Scope scope;
    scope.selection.faces = {"roof-*"};
    EXPECT_EQ(faces_in(model, scope), (Numbers{0, 1}));
    CriteriaPreset preset;
    preset.zones = {zone("A", named({"roof-left"})), zone("B", named({"flange"}))};
    scope.zones = {"A", "B"};
    EXPECT_EQ(faces_in(model, scope, preset), (Numbers{0}));
    scope.selection = {};
    EXPECT_EQ(faces_in(model, scope, preset), (Numbers{0, 2}));
}

TEST(Scope, RefusesWhatSelectsNothing) {
    const SurfaceModel model = sheets();
    Scope scope;
    scope.selection.faces = {"door"};
    EXPECT_EQ(error_of([&] { faces_in(model, scope); }),
              "faces: no face has the number or a name like 'door'");
    scope.selection = {};
    scope.zones = {"outer-skn"};
    EXPECT_EQ(error_of([&] { faces_in(model, scope); }),
              "zone: preset class-a-outer has no zone 'outer-skn' (did you mean 'outer-skin'?); "
              "there are outer-skin");
    scope.zones = {};
    scope.selection.faces = {"flange"}, scope.selection.layers = {"SKIN"};
    EXPECT_EQ(error_of([&] { faces_in(model, scope); }),
              "scope: no face is left to judge: faces flange, layers SKIN");
}

TEST(ZonedLimits, StopWhenAsked) {
    const SurfaceModel model = box_with_sheet();
    std::stop_source stop;
    stop.request_stop();
    Job job;
    job.stop = stop.get_token();
    Scope scope;
    scope.zones = {std::string(outer_skin)};
    EXPECT_THROW(zoned_limits({model}, {}, scope, job), Cancelled);
}

} // namespace
} // namespace keiko
