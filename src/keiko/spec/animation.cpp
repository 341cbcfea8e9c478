#include "keiko/spec/animation.h"

#include "keiko/base/error.h"
#include "keiko/spec/carried_reference.h"
#include "keiko/spec/scene_spec.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <span>
#include <string_view>

namespace keiko {
namespace {

constexpr double any = std::numeric_limits<double>::infinity();

/// Numbers of a scene, and between what they may lie.
struct Numbers {
    std::vector<double*> places{};
    double low = -any, high = any;
    bool color = false;
};

Numbers of(Vec3& v) {
    return {{&v.x, &v.y, &v.z}};
}
Numbers of(Rgb& c) {
    return {{&c.r, &c.g, &c.b}, 0, any, true};
}
Numbers of(double& number, double low = -any, double high = any) {
    return {{&number}, low, high};
}

Numbers numbers_of(Spotlight& light, std::string_view key) {
    if (key == "position") return of(light.position);
    if (key == "aim") return of(light.aim);
    if (key == "reference") return of(light.reference);
    if (key == "spin") return of(light.spin);
    if (key == "half_angle") return of(light.half_angle, 1e-3, light.half_angle_across ? 89 : 180);
    if (key == "intensity") return of(light.intensity);
    return {};
}

Numbers numbers_of(Luminaire& lamp, std::string_view key) {
    if (key == "position") return of(lamp.position);
    if (key == "aim") return of(lamp.aim);
    if (key == "reference") return of(lamp.reference);
    if (key == "spin") return of(lamp.spin);
    if (key == "dimming") return of(lamp.factor);
    return {};
}

Numbers numbers_of(Sun& sun, std::string_view key) {
    if (key == "direction") return of(sun.direction);
    if (key == "illuminance") return of(sun.illuminance);
    return {};
}

Numbers numbers_of(Medium& medium, std::string_view key) {
    if (key == "extinction") return of(medium.extinction);
    if (key == "ambient") return of(medium.ambient);
    if (auto* layers = std::get_if<LayeredDensity>(&medium.density);
        layers && key == "layer.height")
        return of(layers->border.height);
    return {};
}

Numbers numbers_of(Camera& camera, std::string_view key) {
    if (key == "eye") return of(camera.eye);
    if (key == "target") return of(camera.target);
    if (key == "vertical_fov") return of(camera.vertical_fov, 1e-3, 175);
    return {};
}

Numbers numbers_of(ModelSpec& model, std::string_view key) {
    ModelTransform& t = model.transform;
    if (key == "transform.translate") return of(t.translation);
    if (key == "transform.rotate") return {{&t.axis.x, &t.axis.y, &t.axis.z, &t.angle}};
    if (key == "transform.scale") return of(t.scale, 1e-6);
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
Numbers numbers_in(T* part, std::string_view key) {
    return part ? numbers_of(*part, key) : Numbers();
}

Numbers numbers_of(SceneSpec& scene, const std::string& name) {
    const Target target(name);
    if (target.numbered) {
        if (target.table == "spotlight")
            return numbers_in(source_of<Spotlight>(scene, target.number), target.key);
        if (target.table == "luminaire")
            return numbers_in(source_of<Luminaire>(scene, target.number), target.key);
        const bool model = target.table == "model" && target.number < scene.models.size();
        return model ? numbers_of(scene.models[target.number], target.key) : Numbers();
    }
    if (target.table == "sun") return numbers_in(source_of<Sun>(scene, 0), target.key);
    if (target.table == "camera")
        return numbers_in(scene.camera ? &*scene.camera : nullptr, target.key);
    if (target.table == "fog" && scene.rig && scene.rig->medium)
        return numbers_of(*scene.rig->medium, target.key);
    return {};
}

std::vector<double> blend(const std::vector<double>& a, const std::vector<double>& b, double t) {
    std::vector<double> value;
    for (std::size_t i = 0; i < a.size(); ++i) value.push_back(a[i] + (b[i] - a[i]) * t);
    return value;
}

struct Check {
    void operator()(const CPlane&) const {}
    template <class Lamp>
    void operator()(const Lamp& lamp) const {
        if (lamp.aim == lamp.position) throw Error("", "animation", "a lamp is in its aim");
    }
    void operator()(const Sun& sun) const {
        if (!(sun.direction.length() > 0)) throw Error("", "animation", "the sun has no direction");
    }
};

void require_picture(const SceneSpec& scene) {
    for (const ModelSpec& model : scene.models)
        if (!(model.transform.axis.length() > 0))
            throw Error("", "animation", "a model turns about no axis");
    if (scene.camera && scene.camera->eye == scene.camera->target)
        throw Error("", "animation", "the eye is in its target");
    if (!scene.rig) return;
    for (const LightSource& source : scene.rig->sources) std::visit(Check(), source);
}

const Animation* animation_of(const SceneSpec& scene, const std::string& target) {
    const auto found = std::find_if(scene.animations.begin(), scene.animations.end(),
                                    [&](const Animation& a) { return a.target == target; });
    return found == scene.animations.end() ? nullptr : &*found;
}

/// Carries the reference of a lamp along its axis, which turns in a plane between the keys of its
/// place and of its aim.
template <class Lamp>
void carry_reference(const SceneSpec& scene, const std::string& name, double frame, Lamp& lamp) {
    const Animation* place = animation_of(scene, name + ".position");
    const Animation* aim = animation_of(scene, name + ".aim");
    if ((!place && !aim) || animation_of(scene, name + ".reference")) return;
    std::vector<double> stops{frame};
    for (const Animation* moved : {place, aim})
        if (moved)
            for (const KeyFrame& key : moved->keys)
                if (key.frame < frame) stops.push_back(key.frame);
    std::sort(stops.begin(), stops.end());
    std::vector<Vec3> ways;
    for (const double stop : stops) {
        const auto at = [&](const Animation* moved, const Vec3& rest) {
            if (!moved) return rest;
            const std::vector<double> v = moved->at(stop);
            return Vec3(v[0], v[1], v[2]);
        };
        ways.push_back(at(aim, lamp.aim) - at(place, lamp.position));
        if (!(ways.back().length() > 0)) return;
    }
    lamp.reference = carried_reference(lamp.reference, ways);
}

void carry_references(SceneSpec& scene, double frame) {
    if (!scene.rig) return;
    int spotlights = 0, luminaires = 0;
    for (LightSource& source : scene.rig->sources) {
        if (auto* light = std::get_if<Spotlight>(&source))
            carry_reference(scene, "spotlight." + std::to_string(spotlights++), frame, *light);
        if (auto* lamp = std::get_if<Luminaire>(&source))
            carry_reference(scene, "luminaire." + std::to_string(luminaires++), frame, *lamp);
    }
}

} // namespace

std::vector<double> Animation::at(double frame) const {
    const auto next = std::find_if(keys.begin(), keys.end(),
                                   [frame](const KeyFrame& key) { return key.frame > frame; });
    if (next == keys.begin()) return keys.front().value;
    if (next == keys.end()) return keys.back().value;
    const KeyFrame& last = *(next - 1);
    return blend(last.value, next->value, (frame - last.frame) / (next->frame - last.frame));
}

std::string animation_fault(SceneSpec& scene, const Animation& animation) {
    const Numbers numbers = numbers_of(scene, animation.target);
    if (numbers.places.empty()) return "the scene has no '" + animation.target + "' that moves";
    const std::size_t count = animation.keys.front().value.size();
    for (const KeyFrame& key : animation.keys) {
        const bool fits =
            key.value.size() == numbers.places.size() || (numbers.color && key.value.size() == 1);
        if (!fits || key.value.size() != count)
            return "each value of '" + animation.target + "' needs " +
                   std::to_string(numbers.places.size()) + " number" +
                   (numbers.places.size() > 1 ? "s" : "");
        for (const double value : key.value)
            if (!(value >= numbers.low && value <= numbers.high))
                return "a value of '" + animation.target + "' is out of range";
    }
    return "";
}

SceneSpec at_frame(SceneSpec scene, double frame) {
    for (const Animation& animation : scene.animations) {
        const Numbers numbers = numbers_of(scene, animation.target);
        const std::vector<double> value = animation.at(frame);
        for (std::size_t i = 0; i < numbers.places.size(); ++i)
            *numbers.places[i] = value[value.size() == 1 ? 0 : i];
    }
    require_picture(scene);
    carry_references(scene, frame);
    return scene;
}

} // namespace keiko
