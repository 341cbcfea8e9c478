#include "tests/bench/cut_shaft.h"

#include "keiko/api/scene.h"
#include "keiko/film/image_file.h"
#include "keiko/film/overlay.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/light/rig/luminance_along.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/paths.h"

#include <array>

namespace keiko::bench {
namespace {

/// mm: from right to left below the bodies of the scene.
const Segment camera_ray{Vec3(2450, 0, 1250), Vec3(-2600, 0, 850)};

/// The parts of a ray that the first lamp of a scene lights.
std::vector<Segment> lit_parts(const Scene& scene, const Segment& ray) {
    const std::array rays{ray};
    const VolumetricShadows shadows(*scene.rig, &*scene.occluders, scene.seen(), rays);
    std::vector<Segment> lit;
    for (const ParameterInterval& part : in_light(scene.rig->sources.front(), ray)) {
        const Segment beam{ray.at(part.begin), ray.at(part.end)};
        for (const ParameterInterval& seen : shadows.visible()(0, beam))
            lit.push_back({beam.at(seen.begin), beam.at(seen.end)});
    }
    return lit;
}

class Drawing {
public:
    explicit Drawing(const Camera& camera) : camera_(camera) {}

    void line(const Vec3& a, const Vec3& b, const Rgb& color, double width) {
        overlay_.lines.push_back({.points = {at(a), at(b)}, .color = color, .width = width});
    }
    void label(const Vec3& place, const Vec2& off, const char* text) {
        overlay_.texts.push_back({.at = at(place) + off, .text = text, .color = Rgb(0.9)});
    }
    const Overlay& overlay() const { return overlay_; }

private:
    Vec2 at(const Vec3& place) const { return project(camera_, place).value(); }

    const Camera& camera_;
    Overlay overlay_;
};

} // namespace

void draw_cut_shaft(const std::filesystem::path& output) {
    require_image_extension(output);
    const std::array scene_file{test::repository("surfaces/cut-shaft-scene.toml")};
    SceneOptions options;
    options.shadows = true;
    const Scene scene = open_scene(scene_file, options);
    const Camera& camera = scene.camera.value();
    const Film film = render_view(scene, scene.rig.value(), camera, picture_options(scene));

    const Rgb grey(0.55), yellow(1, 0.85, 0.2), thin(0.95, 0.55, 0.2);
    const Vec3 lamp = std::get<Spotlight>(scene.rig->sources.front()).position;
    Drawing drawing(camera);
    drawing.line(camera_ray.a, camera_ray.b, grey, 2);
    for (const Segment& part : lit_parts(scene, camera_ray)) {
        for (const Vec3& end : {part.a, part.b}) drawing.line(lamp, end, thin, 1);
        drawing.line(part.a, part.b, yellow, 5);
    }
    drawing.label(lamp, Vec2(12, -8), "lamp");
    drawing.label(camera_ray.a, Vec2(8, -8), "eye");
    ToneMapping tone;
    tone.curve = ToneMapping::Curve::reinhard;
    write_png(output, with_overlay(tone_mapped(film, tone), drawing.overlay()));
}

} // namespace keiko::bench
