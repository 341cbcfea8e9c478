#include "keiko/scene/animation.h"

#include "keiko/base/error.h"
#include "keiko/light/spotlight/beam_direction.h"
#include "keiko/scene/scene_spec.h"

#include <algorithm>

namespace keiko {
namespace {

/// Image of a vector across a unit axis under the shortest turn from that axis to another.
Vec3 turned(const Vec3& across, const Vec3& from, const Vec3& to) {
    const double both = 1 + from.dot(to);
    constexpr double opposite = 1e-12;
    return both > opposite ? across - (from + to) * (across.dot(to) / both) : across;
}

} // namespace

Vec3 carried_reference(const Vec3& reference, std::span<const Vec3> ways) {
    Vec3 axis = ways.front().normalized();
    Vec3 across = beam_frame(axis, reference).across;
    for (const Vec3& way : ways.subspan(1)) {
        const Vec3 next = way.normalized();
        across = turned(across, axis, next).normalized();
        axis = next;
    }
    return across;
}

namespace {

bool is_direction(const std::vector<double>& value) {
    return value[0] != 0 || value[1] != 0 || value[2] != 0;
}

/// True if the straight way from one direction to another passes through none.
bool opposite(const std::vector<double>& a, const std::vector<double>& b) {
    const Vec3 from(a[0], a[1], a[2]), to(b[0], b[1], b[2]);
    return from.dot(to) < 0 && from.cross(to).length() <= 1e-12 * from.length() * to.length();
}

/// "" for values that the target may have.
std::string fault_of_keys(const MovingNumbers& numbers, const Animation& animation) {
    const std::string name = "'" + animation.target + "'";
    const std::size_t count = animation.keys.front().value.size();
    const std::vector<double>* last = nullptr;
    for (const KeyFrame& key : animation.keys) {
        const bool one_does = numbers.kind == MovingNumbers::Kind::color && key.value.size() == 1;
        if ((key.value.size() != numbers.places.size() && !one_does) || key.value.size() != count)
            return "each value of " + name + " needs " + std::to_string(numbers.places.size()) +
                   " number" + (numbers.places.size() > 1 ? "s" : "");
        for (const double value : key.value)
            if (!(value >= numbers.low && value <= numbers.high))
                return "a value of " + name + " is out of range";
        if (numbers.kind != MovingNumbers::Kind::direction) continue;
        if (!is_direction(key.value)) return "a value of " + name + " has no direction";
        if (last && opposite(*last, key.value))
            return "between two keys of " + name + " the direction turns into its opposite";
        last = &key.value;
    }
    return "";
}

struct Check {
    void operator()(const CPlane&) const {}
    void operator()(const SkyLight& sky) const {
        if (sky.model == SkyModel::clear && !(sky.sun.z > 0))
            throw Error("", "animation", "the sun of a clear sky is not above the horizon");
    }
    template <ExtendedLight Light>
    void operator()(const Light&) const {}
    void operator()(const PointSource& light) const {
        if (!(light.axis.length() > 0)) throw Error("", "animation", "a point has no axis");
    }
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

/// Keeps the bright part of a clear sky around a sun that moves.
void follow_sun(LightRig& rig) {
    const Sun* sun = nullptr;
    for (const LightSource& source : rig.sources)
        if (const auto* found = std::get_if<Sun>(&source)) sun = found;
    for (LightSource& source : rig.sources)
        if (auto* sky = std::get_if<SkyLight>(&source); sky && sun) sky->sun = sun->towards();
}

} // namespace

std::optional<AnimationFault> animation_fault(SceneSpec& scene, const Animation& animation) {
    const MovingNumbers numbers = numbers_of(scene, animation.target);
    if (numbers.places.empty())
        return AnimationFault{"target", "the scene has no '" + animation.target + "' that moves" +
                                            suggested_target(scene, animation.target)};
    if (const std::string fault = fault_of_keys(numbers, animation); !fault.empty())
        return AnimationFault{"keys", fault};
    return std::nullopt;
}

SceneSpec at_frame(SceneSpec scene, double frame) {
    for (const Animation& animation : scene.animations) {
        const MovingNumbers numbers = numbers_of(scene, animation.target);
        const std::vector<double> value = animation.at(frame);
        for (std::size_t i = 0; i < numbers.places.size(); ++i)
            *numbers.places[i] = value[value.size() == 1 ? 0 : i];
    }
    if (scene.rig && animation_of(scene, "sun.direction")) follow_sun(*scene.rig);
    require_picture(scene);
    carry_references(scene, frame);
    return scene;
}

} // namespace keiko
