#include "keiko/inspect/lines/line_sources.h"

#include "keiko/files/scene/rig_file.h"
#include "keiko/inspect/lines/surface_lines.h"
#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/math/axes.h"
#include "keiko/math/polygon.h"
#include "keiko/scene/view.h"

#include "tests/support/analytic_models.h"
#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace keiko {
namespace {

PolygonLight square(double x, double luminance = 100) {
    return {{{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}}, Rgb(luminance)};
}

int lines_in(const std::vector<LineSource>& sources) {
    int lines = 0;
    for (const LineSource& source : sources) lines += source.row.lamps;
    return lines;
}

int visible_from(const Vec3& place, const LightRig& rig) {
    std::vector<LineSource> sources = line_sources(rig);
    std::erase_if(sources, [&](const LineSource& one) { return !one.is_visible_from(place); });
    return lines_in(sources);
}

TEST(LineSources, LongEdgesOfAZebraScreenAreTwoRows) {
    const LightRig rig = read_rig(test::repository("lightrigs/zebra-screen.toml"));
    const std::vector<LineSource> sources = line_sources(rig);
    EXPECT_EQ(lines_in(sources), 80);
    ASSERT_EQ(sources.size(), 42U);
    const auto rows = std::count_if(sources.begin(), sources.end(),
                                    [](const LineSource& one) { return one.row.lamps == 20; });
    EXPECT_EQ(rows, 2);
    std::vector<Segment> sides;
    for (const LightSource& light : rig.sources) {
        const std::vector<Vec3>& corners = std::get<PolygonLight>(light).corners;
        for (std::size_t i = 0; i < 4; ++i) sides.push_back({corners[i], corners[(i + 1) % 4]});
    }
    for (const LineSource& source : sources)
        for (int lamp = 0; lamp < source.row.lamps; ++lamp) {
            const Segment line = source.line(lamp);
            const auto same = [&](const Segment& side) {
                return (side.a - line.a).length() + (side.b - line.b).length() < 1e-9;
            };
            EXPECT_EQ(std::count_if(sides.begin(), sides.end(), same), 1) << line.a << line.b;
        }
}

TEST(LineSources, UnevenEdgesAreSourcesOfTheirOwn) {
    const LightRig rig{"", {square(0), square(3), square(7)}};
    EXPECT_EQ(line_sources(rig).size(), 12U);
}

TEST(LineSources, PanelsAlikeHaveNoEdgeBetweenThem) {
    EXPECT_EQ(lines_in(line_sources({"", {square(0), square(1)}})), 6);
    EXPECT_EQ(lines_in(line_sources({"", {square(0), square(1, 50)}})), 7); // told of once
    EXPECT_EQ(lines_in(line_sources({"", {square(0), square(2)}})), 8);
}

/// The outline of a box in three views: a hexagon, a hexagon, a face.
TEST(LineSources, EdgesOfABoxAreItsOutlineFromEachPlace) {
    const LightRig rig = parse_rig(
        "format = \"keiko-rig/1\"\n[[box]]\norigin = [0, 0, 0]\nu = [3, 0, 0]\nv = [0, 2, 0]\n"
        "w = [0, 0, 1]\n",
        "box.toml");
    EXPECT_EQ(visible_from({9, 8, 7}, rig), 6);
    EXPECT_EQ(visible_from({-9, -8, -7}, rig), 6);
    EXPECT_EQ(visible_from({1, 1, 9}, rig), 4);
}

TEST(LineSources, IsophotesBelongToRowsOfTubesAlone) {
    const LightRig rig{"", {square(0), CPlane{}}};
    EXPECT_EQ(line_sources(rig, LineLook::isophote).size(), 1U);
    EXPECT_FALSE(line_sources(rig).front().of_panels); // whatever the order in the rig
    EXPECT_TRUE(line_sources(rig, LineLook::highlight).back().of_panels);
}

/// A panel in the shape of an L over a sphere, which shines down.
struct PanelOverSphere {
    SurfaceModel model =
        test::sphere_model(Affine::translate({100, 200, 700}) * Affine::scale(400));
    Tracer tracer{model};
    Camera camera = frame_view("high-front", tracer.bounds());
    PolygonLight panel{{{-200, -900, 2200},
                        {-200, 900, 2200},
                        {300, 900, 2200},
                        {300, 100, 2200},
                        {1500, 100, 2200},
                        {1500, -900, 2200}},
                       Rgb(5000)};

    std::vector<SurfaceLine> lines() const {
        return surface_lines(model, tracer, line_sources({"", {panel}}), camera);
    }
    /// True if the ray meets the panel's outline inside, whichever face it is.
    bool shows(const Ray& mirrored) const {
        const Vec3 normal = panel.normal(), u = any_perpendicular(normal), v = normal.cross(u);
        const double reach =
            normal.dot(panel.corners.front() - mirrored.origin) / normal.dot(mirrored.direction);
        const Vec3 at = mirrored.origin + mirrored.direction * reach;
        std::vector<Vec2> flat;
        for (const Vec3& corner : panel.corners) flat.emplace_back(u.dot(corner), v.dot(corner));
        return reach > 0 && holds(flat, {u.dot(at), v.dot(at)});
    }
};

double distance_to(const std::vector<SurfaceLine>& lines, const Vec3& place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const SurfaceLine& line : lines)
        for (std::size_t i = 1; i < line.line.points.size(); ++i) {
            const Vec3 a = line.line.points[i - 1].place, way = line.line.points[i].place - a;
            const double t = std::clamp((place - a).dot(way) / way.length2(), 0.0, 1.0);
            nearest = std::min(nearest, (a + way * t - place).length());
        }
    return nearest;
}

/// Between two neighbouring rays, one to the panel and one past it, there is a line.
TEST(LineSources, LinesOfAPanelAreTheBordersOfItsImage) {
    const PanelOverSphere scene;
    const std::vector<SurfaceLine> lines = scene.lines();
    ASSERT_FALSE(lines.empty());
    const PreparedCamera eye(scene.camera);
    int borders = 0;
    for (int y = 0; y < scene.camera.height; y += 3) {
        std::optional<std::pair<Vec3, bool>> before;
        for (int x = 0; x < scene.camera.width; x += 3) {
            const Ray ray = eye.ray(x + 0.5, y + 0.5);
            const auto hit = scene.tracer.nearest(ray);
            if (!hit) {
                before.reset();
                continue;
            }
            const std::pair now{hit->position, scene.shows(reflect_ray(ray, *hit))};
            if (before && before->second != now.second) {
                const double step = (now.first - before->first).length();
                EXPECT_LT(distance_to(lines, (now.first + before->first) / 2), step)
                    << x << " " << y;
                ++borders;
            }
            before = now;
        }
    }
    EXPECT_GT(borders, 40);
}

TEST(LineSources, PlacesOfLinesMirrorTheOutline) {
    const PanelOverSphere scene;
    const std::vector<LineSource> sources = line_sources({"", {scene.panel}});
    int places = 0;
    for (const SurfaceLine& line : scene.lines())
        for (const LinePoint& point : line.line.points) {
            Ray ray;
            ray.origin = scene.camera.eye;
            ray.direction = (point.place - ray.origin).normalized();
            const auto hit = scene.tracer.nearest(ray);
            if (!hit || (hit->position - point.place).length() > 1e-6) continue;
            const Ray mirrored = reflect_ray(ray, *hit);
            const Segment edge = sources[line.plane].line(static_cast<int>(line.lamp));
            const Vec3 along = (edge.b - edge.a).normalized();
            const Vec3 apart = along.cross(mirrored.direction).normalized();
            EXPECT_NEAR(apart.dot(mirrored.origin - edge.a), 0, 1e-5) << point.place;
            ++places;
        }
    EXPECT_GT(places, 100);
}

TEST(LineSources, DarkFacesHaveNoLines) {
    PanelOverSphere scene;
    const std::size_t lit = scene.lines().size();
    std::reverse(scene.panel.corners.begin(), scene.panel.corners.end());
    EXPECT_TRUE(scene.lines().empty());
    scene.panel.two_sided = true;
    EXPECT_EQ(scene.lines().size(), lit);
}

} // namespace
} // namespace keiko
