#include "keiko/base/text.h"
#include "keiko/scene/animation.h"
#include "keiko/scene/scene_spec.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace keiko {
namespace {

// As files may have them: mm, 1/m, cd and the like, degrees.
constexpr double farthest = 1e9, thickest = 1e6, brightest = 1e15, most_turned = 1e6;

MovingNumbers of(Vec3& v) {
    return {{&v.x, &v.y, &v.z}, -farthest, farthest};
}
MovingNumbers of(Rgb& c, double high = brightest) {
    return {{&c.r, &c.g, &c.b}, 0, high, MovingNumbers::Kind::color};
}
MovingNumbers direction_of(Vec3& v) {
    return {{&v.x, &v.y, &v.z}, -farthest, farthest, MovingNumbers::Kind::direction};
}
MovingNumbers of(double& number, double low, double high) {
    return {{&number}, low, high};
}

MovingNumbers numbers_of(Spotlight& light, std::string_view key) {
    if (key == "position") return of(light.position);
    if (key == "aim") return of(light.aim);
    if (key == "reference") return of(light.reference);
    if (key == "spin") return of(light.spin, -most_turned, most_turned);
    if (key == "half_angle") return of(light.half_angle, 1e-3, light.half_angle_across ? 89 : 180);
    if (key == "intensity") return of(light.intensity);
    return {};
}

MovingNumbers numbers_of(Luminaire& lamp, std::string_view key) {
    if (key == "position") return of(lamp.position);
    if (key == "aim") return of(lamp.aim);
    if (key == "reference") return of(lamp.reference);
    if (key == "spin") return of(lamp.spin, -most_turned, most_turned);
    if (key == "dimming") return of(lamp.factor);
    return {};
}

MovingNumbers numbers_of(Sun& sun, std::string_view key) {
    if (key == "direction") return direction_of(sun.direction);
    if (key == "illuminance") return of(sun.illuminance);
    return {};
}

MovingNumbers numbers_of(SkyLight& sky, std::string_view key) {
    if (key == "luminance") return of(sky.luminance);
    if (key == "ground") return of(sky.ground);
    return {};
}

MovingNumbers numbers_of(Medium& medium, std::string_view key) {
    if (key == "extinction") return of(medium.extinction, thickest);
    if (key == "ambient") return of(medium.ambient);
    if (auto* layers = std::get_if<LayeredDensity>(&medium.density);
        layers && key == "layer.height")
        return of(layers->border.height, -farthest, farthest);
    return {};
}

MovingNumbers numbers_of(Camera& camera, std::string_view key) {
    if (key == "eye") return of(camera.eye);
    if (key == "target") return of(camera.target);
    if (key == "vertical_fov") return of(camera.vertical_fov, 1e-3, 175);
    return {};
}

MovingNumbers numbers_of(ModelSpec& model, std::string_view key) {
    ModelTransform& t = model.transform;
    if (key == "transform.translate") return of(t.translation);
    if (key == "transform.rotate") {
        MovingNumbers turn = direction_of(t.axis);
        turn.places.push_back(&t.angle);
        return turn;
    }
    if (key == "transform.scale") return of(t.scale, 1e-6, 1e6);
    return {};
}

/// The source of a kind with a number, counted among its kind as a file does.
template <class Kind>
Kind* source_of(SceneSpec& scene, std::size_t number) {
    if (!scene.rig) return nullptr;
    for (LightSource& source : scene.rig->sources)
        if (auto* found = std::get_if<Kind>(&source))
            if (number-- == 0) return found;
    return nullptr;
}

/// "spotlight.0.aim" is table, number and key; "camera.eye" table and key.
struct Target {
    std::string_view table, key;
    std::size_t number = 0;
    bool numbered = false;

    explicit Target(std::string_view text) {
        table = text.substr(0, text.find('.'));
        key = text.substr(std::min(table.size() + 1, text.size()));
        const std::string_view digits = key.substr(0, key.find('.'));
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), number);
        numbered = error == std::errc() && end == digits.data() + digits.size();
        if (numbered) key = key.substr(std::min(digits.size() + 1, key.size()));
    }
};

template <class T>
MovingNumbers numbers_in(T* part, std::string_view key) {
    return part ? numbers_of(*part, key) : MovingNumbers();
}

} // namespace

MovingNumbers numbers_of(SceneSpec& scene, const std::string& name) {
    const Target target(name);
    if (target.numbered) {
        if (target.table == "spotlight")
            return numbers_in(source_of<Spotlight>(scene, target.number), target.key);
        if (target.table == "luminaire")
            return numbers_in(source_of<Luminaire>(scene, target.number), target.key);
        const bool model = target.table == "model" && target.number < scene.models.size();
        return model ? numbers_of(scene.models[target.number], target.key) : MovingNumbers();
    }
    if (target.table == "sun") return numbers_in(source_of<Sun>(scene, 0), target.key);
    if (target.table == "sky") return numbers_in(source_of<SkyLight>(scene, 0), target.key);
    if (target.table == "camera")
        return numbers_in(scene.camera ? &*scene.camera : nullptr, target.key);
    if (target.table == "fog" && scene.rig && scene.rig->medium)
        return numbers_of(*scene.rig->medium, target.key);
    return {};
}

namespace {

/// All parts of a scene that may have something that moves, as a file names them.
std::vector<std::string> parts_of(const SceneSpec& scene) {
    std::vector<std::string> parts{"camera", "fog", "sky", "sun"};
    const auto add = [&](const std::string& table, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) parts.push_back(table + "." + std::to_string(i));
    };
    const std::size_t sources = scene.rig ? scene.rig->sources.size() : 0;
    add("model", scene.models.size());
    add("spotlight", sources);
    add("luminaire", sources);
    return parts;
}

/// Keys of what moves in a part of the scene.
std::vector<std::string> moving_keys(SceneSpec& scene, const std::string& part) {
    constexpr std::array all{"position",
                             "aim",
                             "reference",
                             "spin",
                             "half_angle",
                             "intensity",
                             "dimming",
                             "direction",
                             "illuminance",
                             "extinction",
                             "ambient",
                             "layer.height",
                             "eye",
                             "target",
                             "vertical_fov",
                             "transform.translate",
                             "transform.rotate",
                             "transform.scale"};
    std::vector<std::string> keys;
    for (const char* key : all)
        if (!numbers_of(scene, part + "." + key).places.empty()) keys.emplace_back(key);
    return keys;
}

} // namespace

std::string suggested_target(SceneSpec& scene, const std::string& name) {
    std::vector<std::string> parts = parts_of(scene);
    std::erase_if(parts, [&](const std::string& p) { return moving_keys(scene, p).empty(); });
    for (const std::string& part : parts) {
        if (name == part) return "";
        if (name.starts_with(part + "."))
            return did_you_mean(name.substr(part.size() + 1), moving_keys(scene, part));
    }
    const Target target(name);
    std::string part(target.table);
    if (target.numbered) part += "." + std::to_string(target.number);
    return did_you_mean(part, parts);
}

} // namespace keiko
