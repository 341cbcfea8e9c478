#include "keiko/files/photometric/luminaire_file.h"
#include "keiko/light/spotlight/luminaire.h"
#include "keiko/render/shading/integrator.h"

#include "tests/support/analytic_models.h"
#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

/// A matt ball over a black mirror of a floor, z = 0, in fog of three colours: under a road lantern
/// and a tube.
const Vec3 ball_center(300, 100, 1500), lantern(-200, 200, 3000), eye(-2400, -2300, 1300);
constexpr double ball_radius = 450, index = 1.5;
const Rgb ball_paint(0.5, 0.4, 0.3), extinction(0.1, 0.15, 0.25), albedo(0.9, 0.8, 0.7),
    fog(2, 3, 5);
/// A tube along y from this place.
const Vec3 tube_begin(1800, -1000, 2600);
constexpr double tube_length = 2400, tube_radius = 13, spin = 20;
const Rgb tube_luminance(9000, 8000, 7000);

/// Candela of a file of type C whose planes go from 90 to 270 degrees, the other half mirrored
/// [LM-63]: read and looked up here, without the program.
class LanternFile {
public:
    explicit LanternFile(const char* path) {
        std::ifstream in(test::repository(path));
        for (std::string line; std::getline(in, line) && line.rfind("TILT=", 0) != 0;) continue;
        double skipped = 0, verticals = 0, horizontals = 0;
        in >> skipped >> skipped >> skipped >> verticals >> horizontals;
        for (int i = 0; i < 8; ++i) in >> skipped;
        v_.resize(static_cast<std::size_t>(verticals));
        h_.resize(static_cast<std::size_t>(horizontals));
        candela_.resize(v_.size() * h_.size());
        for (auto* list : {&v_, &h_, &candela_})
            for (double& x : *list) in >> x;
        EXPECT_EQ(h_.front(), 90);
        EXPECT_EQ(h_.back(), 270);
    }
    double towards(const Vec3& direction) const {
        const double v = std::acos(-direction.z) * 180 / pi;
        double h = std::fmod(std::atan2(direction.y, direction.x) * 180 / pi - spin + 720, 360);
        if (h < 90 || h > 270) h = std::fmod(540 - h, 360);
        if (v > v_.back()) return 0;
        const auto [i, s] = place(v_, v);
        const auto [j, t] = place(h_, h);
        const auto row = [&](std::size_t k) {
            return candela_[k * v_.size() + i] * (1 - s) + candela_[k * v_.size() + i + 1] * s;
        };
        return row(j) * (1 - t) + row(j + 1) * t;
    }

private:
    static std::pair<std::size_t, double> place(const std::vector<double>& at, double x) {
        std::size_t i = 0;
        while (i + 2 < at.size() && x > at[i + 1]) ++i;
        return {i, (x - at[i]) / (at[i + 1] - at[i])};
    }

    std::vector<double> v_, h_, candela_;
};

Rgb exp_of(const Rgb& x) {
    return {std::exp(x.r), std::exp(x.g), std::exp(x.b)};
}

Rgb left_after(const Vec3& a, const Vec3& b) {
    return exp_of(extinction * (-(b - a).length() / 1000));
}

/// Distance at which a ray enters the ball, in lengths of its direction, or nullopt.
std::optional<double> meets_ball(const Vec3& from, const Vec3& way) {
    const Vec3 off = from - ball_center;
    const double a = way.length2(), b = off.dot(way), c = off.length2() - ball_radius * ball_radius;
    const double root = b * b - a * c;
    if (root <= 0 || (-b - std::sqrt(root)) / a <= 0) return std::nullopt;
    return (-b - std::sqrt(root)) / a;
}

/// Light that the fog adds between two places: its own light, and the lantern's scattered once.
Rgb of_fog(const LanternFile& file, const Vec3& a, const Vec3& b) {
    constexpr int steps = 20000;
    const Vec3 way = b - a, direction = way.normalized();
    Rgb sum;
    for (int i = 0; i < steps; ++i) {
        const Vec3 x = a + way * ((i + 0.5) / steps), to_lamp = lantern - x;
        const auto hidden = meets_ball(x, to_lamp);
        if (hidden && *hidden < 1) continue;
        const double deviation = direction.dot(to_lamp.normalized());
        const double phase = (1 + 6 * std::pow((1 + deviation) / 2, 8)) / (4 * pi * (1 + 6.0 / 9));
        const double lux = file.towards(-to_lamp.normalized()) / (to_lamp.length2() / 1e6);
        sum += extinction * albedo * left_after(a, x) * left_after(x, lantern) * (lux * phase);
    }
    return sum * (way.length() / 1000 / steps) + fog * (Rgb(1) - left_after(a, b));
}

/// lx of the tube, in small pieces of its mantle, and of the lantern on the ball.
Rgb on_ball(const LanternFile& file, const Vec3& place) {
    const Vec3 normal = (place - ball_center).normalized();
    constexpr int along = 600, around = 120;
    const double area = tube_length / along * 2 * pi * tube_radius / around;
    Rgb sum;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const double angle = 2 * pi * (j + 0.5) / around;
            const Vec3 out(std::cos(angle), 0, std::sin(angle));
            const Vec3 x =
                tube_begin + Vec3(0, tube_length * (i + 0.5) / along, 0) + out * tube_radius;
            const Vec3 way = place - x;
            const double leaving = out.dot(way), arriving = -normal.dot(way);
            if (leaving > 0 && arriving > 0)
                sum += tube_luminance * left_after(x, place) *
                       (leaving * arriving * area / (way.length2() * way.length2()));
        }
    const Vec3 to_lamp = lantern - place;
    const double cosine = std::max(0.0, normal.dot(to_lamp.normalized()));
    return sum + left_after(place, lantern) *
                     (file.towards(-to_lamp.normalized()) * cosine / (to_lamp.length2() / 1e6));
}

double fresnel(double cosine) {
    const double inside = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
    const double s = (cosine - index * inside) / (cosine + index * inside);
    const double p = (index * cosine - inside) / (index * cosine + inside);
    return (s * s + p * p) / 2;
}

enum class Meets { nothing, ball, tube };

/// Along a camera ray to the floor and what its mirror image there meets, term by term.
Rgb by_definition(const LanternFile& file, const Vec3& direction, Meets meets) {
    const Vec3 floor = eye - direction * (eye.z / direction.z);
    const Vec3 up(direction.x, direction.y, -direction.z);
    Vec3 end = floor + up * ((lantern.z + 10) / up.z); // the lantern lights nothing above it
    Rgb shown;
    if (meets == Meets::ball) {
        end = floor + up * meets_ball(floor, up).value();
        shown = ball_paint * on_ball(file, end) * (1 / pi);
    } else if (meets == Meets::tube) {
        end = floor + up * (tube_begin.z / up.z);
        shown = tube_luminance;
    }
    Rgb beyond = of_fog(file, floor, end) + left_after(floor, end) * shown;
    if (meets == Meets::nothing) beyond += left_after(floor, end) * fog;
    return of_fog(file, eye, floor) + left_after(eye, floor) * beyond * fresnel(-direction.z);
}

SurfaceModel ball_over_floor() {
    test::ModelBuilder floor;
    floor.plane({-9000, -9000, 0}, {18000, 0, 0}, {0, 18000, 0});
    const std::vector<SurfaceModel> models{
        floor.build(),
        test::sphere_model(Affine::translate(ball_center) * Affine::scale(ball_radius))};
    return merge(models);
}

LightRig rig() {
    Luminaire lamp{.position = lantern, .spin = spin};
    lamp.web = std::make_shared<const PhotometricWeb>(
        read_luminaire(test::repository("surfaces/road-lantern.ies")));
    lamp.aim = lantern - Vec3(0, 0, 1);
    const CPlane tube{.origin = tube_begin - Vec3(50, 0, 0),
                      .u = {0, tube_length, 0},
                      .v = {100, 0, 0},
                      .lamps = 1,
                      .diameter = 2 * tube_radius,
                      .luminance = tube_luminance};
    return {.name = "",
            .sources = {lamp, tube},
            .ambient = Rgb(0),
            .medium = Medium{
                .extinction = extinction, .albedo = albedo, .ambient = fog, .phase = HazePhase{6}}};
}

/// The way from the eye by the floor to a place.
Vec3 by_floor(const Vec3& place) {
    return (Vec3(place.x, place.y, -place.z) - eye).normalized();
}

/// Mirrored legs, a luminaire of an IES file and tubes, seen and shining, all in one fog.
TEST(FoggyScene, MirrorsWhatItsDefinitionComesTo) {
    const SurfaceModel model = ball_over_floor();
    const Tracer tracer(model, {.second_derivatives = true, .clipping_only = false, .join = 0.5});
    const Occluders occluders(model, tracer);
    const LightRig lights = rig();
    std::vector<Material> materials(model.faces.size());
    materials[0] = {.name = "floor", .diffuse = Rgb(0), .refractive_index = index};
    materials[1] = {.name = "ball", .diffuse = ball_paint, .refractive_index = 1};
    const PictureScene scene{tracer, materials, lights, Rgb(0), &occluders};
    const PictureOptions options;
    const LanternFile file("surfaces/road-lantern.ies");

    const std::vector<std::pair<Vec3, Meets>> ways{
        {by_floor(ball_center), Meets::ball},
        {by_floor(ball_center + Vec3(250, 0, -120)), Meets::ball},
        {by_floor(tube_begin + Vec3(0, 700, 0)), Meets::tube},
        {by_floor(tube_begin + Vec3(0, 1500, 0)), Meets::tube},
        {by_floor({2500, 2300, 1900}), Meets::nothing},
        {by_floor({-500, 600, 2400}), Meets::nothing}};
    std::vector<Ray> rays;
    for (const auto& [direction, meets] : ways) {
        rays.emplace_back();
        rays.back().origin = eye;
        rays.back().direction = direction;
    }
    const Integrator plain(scene, options), picture(scene, options, eye);
    const std::vector<PixelSample> found = plain.follow(rays).samples;
    const std::vector<PixelSample> shown = picture.follow(rays).samples;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const Rgb expected = by_definition(file, ways[i].first, ways[i].second);
        for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
            EXPECT_NEAR(found[i].luminance.*channel, expected.*channel, 1e-3 * expected.*channel)
                << "ray " << i;
            EXPECT_NEAR(shown[i].luminance.*channel, found[i].luminance.*channel,
                        1e-5 * expected.*channel)
                << "ray " << i;
        }
    }
}

/// Rays of a parallel picture do not start at one eye, so that planes through a lamp and its rays
/// have no axis in common.
TEST(FoggyScene, ShowsShaftsInParallelPicturesAsItsRaysDo) {
    const SurfaceModel model = ball_over_floor();
    const Tracer tracer(model, {.second_derivatives = true, .clipping_only = false, .join = 0.5});
    const Occluders occluders(model, tracer);
    const LightRig lights = rig();
    const Material matt{.name = "matt", .diffuse = ball_paint, .refractive_index = 1};
    const std::vector<Material> materials(model.faces.size(), matt);
    const PictureScene scene{tracer, materials, lights, Rgb(0), &occluders};
    PictureOptions options;
    options.edge_samples = 1, options.light_error = 0;
    Camera camera;
    camera.eye = eye, camera.target = ball_center;
    camera.projection = Projection::orthographic, camera.orthographic_height = 3000;
    camera.width = 16, camera.height = 12;
    const Film film = render(scene, camera, options);
    const Integrator alone(scene, options);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const std::vector<Ray> ray{camera.ray(x + 0.5, y + 0.5)};
            const double expected = alone.follow(ray).samples[0].luminance.g;
            EXPECT_NEAR(double{film.color.pixel(x, y)[1]}, expected, 1e-4 * expected)
                << x << ' ' << y;
        }
}

} // namespace
} // namespace keiko
