#include "keiko/light/glass/pane.h"
#include "keiko/light/luminance/fresnel.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/render/shading/glass_loss.h"
#include "keiko/render/shading/integrator.h"

#include "tests/support/oracle.h"
#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;
using test::OracleRow;
using test::OracleTable;

/// All of the tree that counts: far more surfaces than any ray's weight lasts for.
const PictureOptions whole_tree{.max_depth = 30, .max_crossings = 30, .min_weight = 0};

Material glass(double n, const Rgb& absorption, double pane = 0) {
    Material material;
    material.diffuse = Rgb(0), material.refractive_index = n;
    material.glass = Glass{absorption, pane};
    return material;
}

/// A closed box of six faces, whose normals may be turned inwards.
SurfaceModel box(const Vec3& lo, const Vec3& hi, bool inwards = false) {
    const Vec3 size = hi - lo, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    test::ShapeBuilder builder;
    const auto side = [&](const Vec3& at, const Vec3& u, const Vec3& v) {
        const Vec3& first = inwards ? v : u;
        const Vec3& second = inwards ? u : v;
        builder.face({test::bilinear(at, at + first, at + second, at + first + second)});
    };
    side(lo, y, x), side(lo + z, x, y);
    side(lo, x, z), side(lo + y, z, x);
    side(lo, z, y), side(lo + x, y, z);
    return builder.model();
}

SurfaceModel ball(const Vec3& center, double radius) {
    test::ShapeBuilder builder;
    return builder.face(test::sphere(center, radius)).model();
}

/// A body all of one material, under lights.
struct Vitrine {
    SurfaceModel model;
    Tracer tracer;
    std::vector<Material> materials;
    LightRig rig{};
    Rgb background{0};

    Vitrine(SurfaceModel body, const Material& material)
        : model(std::move(body)),
          tracer(model, {.second_derivatives = true}),
          materials(model.faces.size(), material) {}

    /// cd/m2 along a camera ray.
    Rgb along(const Vec3& origin, const Vec3& direction,
              const PictureOptions& options = whole_tree) const {
        const PictureScene scene{tracer, materials, rig, background};
        Ray ray;
        ray.origin = origin, ray.direction = direction;
        return Integrator(scene, options).follow(std::span(&ray, 1)).samples[0].luminance;
    }
};

void expect_near(const Rgb& is, const Rgb& wanted, double relative, const std::string& id) {
    const double largest = max_channel(wanted);
    EXPECT_NEAR(is.r, wanted.r, relative * largest) << id;
    EXPECT_NEAR(is.g, wanted.g, relative * largest) << id;
    EXPECT_NEAR(is.b, wanted.b, relative * largest) << id;
}

Rgb rgb(const OracleRow& row, const std::string& name) {
    const Vec3 v = row.vector(name);
    return {v.x, v.y, v.z};
}

/// A panel of all of a half-space's light in effect: 2000 km wide, shining down or up.
PolygonLight wide_panel(double z, const Rgb& luminance) {
    constexpr double far = 1e9;
    return {{{-far, -far, z}, {far, -far, z}, {far, far, z}, {-far, far, z}}, luminance, true};
}

/// A plate from z = 0 down, under one panel and over another.
Vitrine plate_between(const OracleRow& row) {
    Vitrine vitrine(box({-1e5, -1e5, -row.number("in.t")}, {1e5, 1e5, 0}),
                    glass(row.number("in.n"), rgb(row, "in.mu_rgb")));
    vitrine.rig.sources = {wide_panel(3000, rgb(row, "in.La")),
                           wide_panel(-3000, rgb(row, "in.Lb"))};
    return vitrine;
}

Rgb seen_at(const Vitrine& vitrine, double degrees, const PictureOptions& options) {
    const double angle = degrees * pi / 180;
    const Vec3 direction(std::sin(angle), 0, -std::cos(angle));
    return vitrine.along(direction * -1000, direction, options);
}

TEST(Glass, PanesMeetTheOracle) {
    test::WorstError mirrored("R_mean"), passed("T_mean");
    for (const OracleRow& row : OracleTable("glass_plate")) {
        const double cosine = std::cos(row.number("in.theta_deg") * pi / 180);
        const PaneShares shares =
            pane_shares(cosine, row.number("in.n"), Rgb(row.number("in.mu")), row.number("in.t"));
        mirrored.compare(row, shares.mirrored.g, row.number("out.R_mean"), 1e-12);
        passed.compare(row, shares.passed.g, row.number("out.T_mean"), 1e-12);
    }
}

TEST(Glass, TreesOfAPlateMeetTheOracle) {
    for (const OracleRow& row : OracleTable("ray_tree_plate")) {
        const Vitrine plate = plate_between(row);
        const double degrees = row.number("in.theta_deg");
        expect_near(seen_at(plate, degrees, whole_tree), rgb(row, "out.L_inf"), 1e-9, row.id());
        PictureOptions cut = whole_tree;
        cut.min_weight = row.number("in.wmin");
        expect_near(seen_at(plate, degrees, cut), rgb(row, "out.L_weight"), 1e-9, row.id());
    }
}

/// Up through the top of a block that the camera is in, under a panel and over a black floor.
TEST(Glass, ACameraInABlockSeesTheSkyInSnellsWindow) {
    const double n = 1.33, depth = 50, mu = 1e-3;
    for (const bool inwards : {false, true}) {
        Vitrine block(box({-1e5, -1e5, -100}, {1e5, 1e5, 0}, inwards), glass(n, Rgb(mu)));
        block.rig.sources = {wide_panel(3000, Rgb(1000))};
        const auto seen = [&](double degrees) {
            const double angle = degrees * pi / 180;
            return block.along({0, 0, -depth}, {std::sin(angle), 0, std::cos(angle)}).g;
        };
        for (const double degrees : {0.0, 30.0, 48.0}) {
            const double cosine = std::cos(degrees * pi / 180);
            const double mirrored = fresnel_dielectric(cosine, 1 / n);
            const double back = std::exp(-mu * 200 / cosine) * mirrored * mirrored; // by the floor
            const double passed = (1 - mirrored) * std::exp(-mu * depth / cosine);
            EXPECT_NEAR(seen(degrees), 1000 * passed / (1 - back), 1e-6) << degrees;
        }
        EXPECT_EQ(seen(49), 0) << "beyond 48.75 degrees all is mirrored, and the floor is dark";
    }
}

TEST(Glass, GlassElsewhereDoesNotDecideWhatTheCameraIsIn) {
    const Vec3 on_a_way = Vec3(0.31, 0.52, 0.8) * 200;
    test::ShapeBuilder builder;
    builder.face(test::sphere(Vec3(0), 100)).face(test::sphere(on_a_way, 40));
    Vitrine balls(builder.model(), glass(1.33, Rgb(0)));
    balls.rig.sources = {wide_panel(3000, Rgb(1000))};
    const double with_one_paint = balls.along(Vec3(0), {0, 0, 1}).g;
    balls.materials.back() = glass(1.5, Rgb(1));
    EXPECT_GT(balls.along(Vec3(0), {0, 0, 1}).g, 900);
    EXPECT_EQ(balls.along(Vec3(0), {0, 0, 1}).g, with_one_paint);
}

TEST(Glass, EachCameraRayStartsInItsOwnMedium) {
    Vitrine glass_ball(ball(Vec3(0), 100), glass(1.5, Rgb(0)));
    glass_ball.rig.sources = {wide_panel(3000, Rgb(1000))};
    const PictureScene scene{glass_ball.tracer, glass_ball.materials, glass_ball.rig, Rgb(0)};
    const Integrator integrator(scene, whole_tree);
    Ray outside, inside;
    outside.origin = Vec3(10, 0, -300), outside.direction = Vec3(0, 0, 1);
    inside.origin = Vec3(0, 0, 0), inside.direction = Vec3(0.1, 0, 1);
    for (const auto& rays : {std::array{outside, inside}, std::array{inside, outside}}) {
        const SampleBatch both = integrator.follow(rays);
        for (std::size_t i = 0; i < 2; ++i) {
            const Rgb alone = integrator.follow(std::span(&rays[i], 1)).samples[0].luminance;
            EXPECT_GT(alone.g, 500);
            EXPECT_EQ(both.samples[i].luminance, alone) << i;
        }
    }
}

TEST(Glass, ACameraBeforeOrBehindABlockIsInTheAir) {
    Vitrine block(box({-1e5, -1e5, -100}, {1e5, 1e5, 0}), glass(1.33, Rgb(0)));
    block.rig.sources = {wide_panel(3000, Rgb(1000))};
    const double grazing = std::sin(80 * pi / 180);
    EXPECT_GT(block.along({0, 0, -150}, {grazing, 0, std::sqrt(1 - grazing * grazing)}).g, 100);
    EXPECT_EQ(block.along({0, 0, 50}, {0, 0, 1}).g, 1000);
}

TEST(Glass, APaneIsThePlateThatItStandsFor) {
    for (const OracleRow& row : OracleTable("ray_tree_plate")) {
        const Vitrine plate = plate_between(row);
        test::ShapeBuilder builder;
        Vitrine pane(builder.face({test::rectangle(-1e5, 1e5, -1e5, 1e5, 0)}).model(),
                     glass(row.number("in.n"), rgb(row, "in.mu_rgb"), row.number("in.t")));
        pane.rig = plate.rig;
        const double degrees = row.number("in.theta_deg");
        expect_near(seen_at(pane, degrees, whole_tree), rgb(row, "out.L_inf"), 1e-12, row.id());
    }
}

/// A lamp that only light from a place in a direction meets: a disc's square, 1 m on.
PolygonLight at_the_end(const Vec3& place, const Vec3& direction) {
    const Vec3 u =
        direction.cross(std::abs(direction.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)).normalized();
    const Vec3 v = direction.cross(u), at = place + direction * 1000;
    return {{at - u - v, at + u - v, at + u + v, at - u + v}, Rgb(1), true};
}

TEST(Glass, BallsBendAndDimAsTheOracleSays) {
    for (const OracleRow& row : OracleTable("glass_ball")) {
        Vitrine vitrine(ball(row.vector("in.C"), row.number("in.R")),
                        glass(row.number("in.n"), rgb(row, "in.mu_rgb")));
        vitrine.rig.sources = {at_the_end(row.vector("out.X2"), row.unit("out.d2"))};
        const Vec3 origin = row.vector("in.O"), direction = row.unit("in.dir");
        expect_near(vitrine.along(origin, direction, {.max_depth = 0, .min_weight = 0}),
                    rgb(row, "out.weight"), 1e-9, row.id());
    }
}

TEST(Glass, BlocksMirrorTotallyAsTheOracleSays) {
    for (const OracleRow& row : OracleTable("glass_block"))
        for (const bool inwards : {false, true}) {
            Vitrine vitrine(box(row.vector("in.lo"), row.vector("in.hi"), inwards),
                            glass(row.number("in.n"), rgb(row, "in.mu_rgb")));
            vitrine.rig.sources = {at_the_end(row.vector("out.X_out"), row.unit("out.d_out"))};
            expect_near(vitrine.along(row.vector("in.O"), row.unit("in.dir"),
                                      {.max_depth = 0, .min_weight = 0}),
                        rgb(row, "out.weight"), 1e-9, row.id());
        }
}

TEST(Glass, PrismsDeviateAsTheOracleSays) {
    for (const OracleRow& row : OracleTable("glass_prism")) {
        const double apex = row.number("in.A_deg") * pi / 180, length = 100;
        // The apex is the origin; the first face lies in x = 0, the second leans by the apex'
        // angle.
        const Vec3 down(0, 0, -length), along(0, length, 0);
        const Vec3 second(std::sin(apex) * length, 0, -std::cos(apex) * length);
        test::ShapeBuilder builder;
        builder.face({test::bilinear(-along, along, down - along, down + along)});
        builder.face({test::bilinear(along, -along, second + along, second - along)});
        Vitrine vitrine(builder.model(), glass(row.number("in.n"), Rgb(0)));
        const double i1 = row.number("in.i1_deg") * pi / 180;
        // From the base's side onto the first face: it is bent towards the base.
        const Vec3 direction(std::cos(i1), 0, std::sin(i1)), met = down * 0.3;
        if (row.integer("out.tir") == 1) continue; // blocks mirror totally
        const double turned = i1 - row.number("out.deviation_deg") * pi / 180;
        const Vec3 leaving(std::cos(turned), 0, std::sin(turned));
        // A long bar across covers every place of leaving.
        const Vec3 aside(-leaving.z * 400, 0, leaving.x * 400), far = leaving * 1e6;
        vitrine.rig.sources = {PolygonLight{
            {far - aside - along, far + aside - along, far + aside + along, far - aside + along},
            Rgb(1),
            true}};
        const Rgb seen =
            vitrine.along(met - direction * 500, direction, {.max_depth = 0, .min_weight = 0});
        EXPECT_NEAR(seen.g, row.number("out.T_mean"), 1e-9) << row.id();
    }
}

TEST(Glass, NothingIsLostInAWhiteFurnace) {
    for (const Material& material : {glass(1.5, Rgb(0)), glass(2.4, Rgb(0)), glass(1.5, Rgb(0), 4)})
        for (SurfaceModel body : {ball({0, 0, 0}, 100), box(Vec3(-60), Vec3(80))}) {
            Vitrine vitrine(std::move(body), material);
            vitrine.rig.ambient = Rgb(pi), vitrine.background = Rgb(1);
            for (const double y : {-55.0, -7.0, 31.0, 52.0})
                expect_near(vitrine.along({-500, y, 12}, Vec3(1, 0.02, -0.01)), Rgb(1), 1e-6,
                            std::to_string(y));
        }
}

TEST(Glass, PanesShowTheBackgroundStraightOn) {
    Vitrine vitrine(ball({0, 0, 0}, 100), glass(1.5, Rgb(0.01, 0.02, 0.04), 3));
    vitrine.background = Rgb(10);
    const Rgb once = pane_shares(1, 1.5, Rgb(0.01, 0.02, 0.04), 3).passed;
    expect_near(vitrine.along({-500, 0, 0}, Vec3(1, 0, 0), {.max_depth = 0}), once * once * 10,
                1e-12, "two panes");
}

TEST(Glass, RowsOfTubesAreSeenWhereGlassBendsAndNotThroughPanes) {
    CPlane row;
    row.origin = {500, -200, -200}, row.u = {0, 400, 0}, row.v = {0, 0, 400};
    row.luminance = Rgb(100);
    const auto seen = [&](const Material& material) {
        Vitrine vitrine(ball({0, 0, 0}, 100), material);
        vitrine.rig.sources = {row};
        double sum = 0;
        for (int i = 0; i < 40; ++i)
            sum += vitrine.along({-500, 0, -50 + 2.5 * i}, Vec3(1, 0, 0), {.max_depth = 0}).g;
        return sum;
    };
    EXPECT_GT(seen(glass(1.5, Rgb(0))), 100);
    EXPECT_EQ(seen(glass(1.5, Rgb(0), 3)), 0);
}

/// Share of the light of a source's only lamp that the glass of a vitrine leaves.
Rgb left_of(const Vitrine& vitrine, const LightSource& source, const Vec3& point) {
    const PreparedSource prepared =
        std::visit([](const auto& light) { return PreparedSource(light); }, source);
    return GlassLoss(vitrine.tracer, vitrine.materials).left(prepared, 0, point, {});
}

PointSource lamp_at(const Vec3& place) {
    PointSource lamp;
    lamp.position = place;
    return lamp;
}

TEST(GlassLoss, PanesAndBlocksLeaveTheirSharesOnStraightWays) {
    const Rgb absorption(0.01, 0.002, 0);
    const PointSource lamp = lamp_at({500, 0, 40});
    const Vec3 point(-500, 0, 40);
    const Vitrine pane(box(Vec3(-100), Vec3(100)), glass(1.5, absorption, 4));
    const Rgb once = pane_shares(1, 1.5, absorption, 4).passed;
    expect_near(left_of(pane, lamp, point), once * once, 1e-12, "two panes");
    const Vitrine block(box(Vec3(-100), Vec3(100)), glass(1.5, absorption));
    const double face = 1 - 0.04;
    expect_near(left_of(block, lamp, point), Rgb(std::exp(-2.0), std::exp(-0.4), 1) * (face * face),
                1e-9, "block");
    expect_near(left_of(block, lamp, {-50, 0, 40}), Rgb(std::exp(-1.5), std::exp(-0.3), 1) * face,
                1e-9, "inside the block");
    const Vitrine paint(box(Vec3(-100), Vec3(100)), Material());
    EXPECT_FALSE(GlassLoss(paint.tracer, paint.materials).any());
}

TEST(GlassLoss, ATubeIsTheMeanOfEightWays) {
    test::ShapeBuilder builder;
    const Vitrine pane(builder.face({test::rectangle(0, 500, -500, 500, 100)}).model(),
                       glass(1.5, Rgb(0.2), 1));
    CPlane tube; // so short that it is seen upright
    tube.origin = {-2, -0.5, 200}, tube.u = {4, 0, 0}, tube.v = {0, 1, 0};
    tube.lamps = 1, tube.diameter = 0.1;
    const double whole = pane_shares(1, 1.5, Rgb(0.2), 1).passed.g;
    // Through the pane's border go the ways to what is beyond x = 1.
    EXPECT_NEAR(left_of(pane, tube, {-1, 0, 0}).g, (6 + 2 * whole) / 8, 1e-3);
}

TEST(GlassLoss, APanelIsTheMeanOfSixteenWays) {
    test::ShapeBuilder builder;
    const Vitrine pane(builder.face({test::rectangle(-500, 500, 0, 500, 100)}).model(),
                       glass(1.5, Rgb(0.2), 1));
    const PolygonLight light{{{-2, -2, 200}, {-2, 2, 200}, {2, 2, 200}, {2, -2, 200}}, Rgb(1)};
    EXPECT_NEAR(left_of(pane, light, {0, 0, 0}).g,
                (1 + pane_shares(1, 1.5, Rgb(0.2), 1).passed.g) / 2, 1e-3);
}

TEST(GlassLoss, TheSkyIsSeenThroughWhatIsInItsDirections) {
    const SkyLight sky{SkyModel::uniform, Rgb(100)};
    const Vitrine bubble(ball({0, 0, 0}, 100), glass(1.5, Rgb(0.1), 3));
    const double whole = pane_shares(1, 1.5, Rgb(0.1), 3).passed.g;
    EXPECT_NEAR(left_of(bubble, sky, Vec3(0)).g, whole, 1e-12);
    // A black roof, the upper face of a cube about the point, is a third of the hemisphere.
    test::ShapeBuilder roof;
    const Vitrine above(roof.face({test::rectangle(-100, 100, -100, 100, 100)}).model(),
                        glass(1.5, Rgb(50), 3));
    EXPECT_NEAR(left_of(above, sky, Vec3(0)).g, 2 / 3.0, 0.08);
}

TEST(Glass, PicturesAreThoseOfTheirRays) {
    Vitrine vitrine(ball({0, 0, 0}, 100), glass(1.5, Rgb(0.001, 0.003, 0.002)));
    vitrine.rig.sources = {PolygonLight{
        {{-300, -300, 700}, {300, -300, 700}, {300, 300, 700}, {-300, 300, 700}}, Rgb(50), true}};
    vitrine.rig.ambient = Rgb(3);
    Camera camera;
    camera.eye = {-700, 90, 60}, camera.target = {0, 0, 0};
    camera.width = 24, camera.height = 24, camera.vertical_fov = 12;
    const PictureScene scene{vitrine.tracer, vitrine.materials, vitrine.rig};
    const PictureOptions options{.edge_samples = 1};
    const Film film = render(scene, camera, options);
    const Integrator integrator(scene, options);
    int compared = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Ray ray = camera.ray(x + 0.5, y + 0.5);
            const Rgb wanted = integrator.follow(std::span(&ray, 1)).samples[0].luminance;
            EXPECT_NEAR(film.color.pixel(x, y)[1], wanted.g, 1e-5 * (1 + wanted.g))
                << x << ' ' << y;
            compared += wanted.g > 0;
        }
    EXPECT_EQ(compared, camera.width * camera.height);
}

} // namespace
} // namespace keiko
