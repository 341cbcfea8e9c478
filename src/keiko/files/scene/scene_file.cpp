#include "keiko/files/scene/scene_file.h"

#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/camera_table.h"
#include "keiko/files/scene/environment_table.h"
#include "keiko/files/scene/map_table.h"
#include "keiko/files/scene/material_file.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/scene/transform_table.h"
#include "keiko/files/scene/volume_table.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/light/rig/primitive_lights.h"
#include "keiko/scene/animation.h"
#include "keiko/scene/view.h"

#include <algorithm>

namespace keiko {
namespace fs = std::filesystem;

namespace {

constexpr int most_reflections = 64;
Material material_of(const TomlTable& model, const std::vector<Material>& known) {
    if (model.kind("material") == "table") return material_from(*model.table("material"));
    const auto name = model.text("material");
    if (!name) return known.front();
    try {
        return find_material(*name, known);
    } catch (const Error& error) {
        throw model.error("material", error.reason());
    }
}

PaintOverride override_from(const TomlTable& table, const std::vector<Material>& materials) {
    table.not_yet({"color", "layer"});
    PaintOverride paint;
    paint.faces = table.required("faces", table.texts("faces"));
    if (paint.faces.empty()) throw table.error("faces", "must name at least one face");
    if (!table.has("material")) table.refuse_missing("material");
    paint.material = material_of(table, materials);
    table.finish();
    return paint;
}

ModelSpec model_from(const TomlTable& table, const std::vector<Material>& materials) {
    ModelSpec model;
    model.file = table.required("file", path_from(table, "file"));
    if (const auto transform = table.table("transform"))
        model.transform = transform_from(*transform);
    model.material = material_of(table, materials);
    for (const TomlTable& paint : table.tables("override"))
        model.overrides.push_back(override_from(paint, materials));
    table.not_yet({"unit", "axes"});
    table.finish();
    return model;
}

std::optional<LightRig> rig_of(const TomlTable& root) {
    const LightRig inline_rig = rig_from(root);
    const bool lit = !inline_rig.sources.empty() || inline_rig.ambient != Rgb(0) ||
                     inline_rig.medium.has_value();
    const auto table = root.table("rig");
    if (!table) return lit ? std::optional(inline_rig) : std::nullopt;
    if (lit) throw root.error("rig", "give either [rig] or lights in the scene, not both");
    const fs::path path = table->required("file", path_from(*table, "file"));
    table->finish();
    return read_rig(path);
}

/// Picture size, and the camera or the named view.
void take_eye(const TomlTable& root, SceneSpec& scene) {
    if (const auto size = picture_size_from(root))
        scene.width = size->width, scene.height = size->height;
    scene.view = root.text("view");
    const auto& names = view_names();
    if (scene.view && std::find(names.begin(), names.end(), *scene.view) == names.end())
        throw root.error("view", "unknown view '" + shortened(*scene.view) + "'" +
                                     did_you_mean(*scene.view, names) + "; views are " +
                                     comma_list(names));
    const auto camera = root.table("camera");
    if (!camera) return;
    if (scene.view) throw root.error("view", "give either view or [camera], not both");
    if (root.has("size")) throw root.error("size", "stands in [camera] where there is one");
    scene.camera = camera_from(*camera);
    scene.width = scene.camera->width;
    scene.height = scene.camera->height;
}

/// A scene whose surroundings light it needs no lamps.
void take_environment(const TomlTable& root, SceneSpec& scene) {
    const auto table = root.table("environment");
    if (!table) return;
    scene.environment = environment_from(*table);
    if (!scene.rig) scene.rig.emplace();
    const std::vector<LightSource>& sources = scene.rig->sources;
    if (std::any_of(sources.begin(), sources.end(), [](const LightSource& source) {
            return std::holds_alternative<SkyLight>(source);
        }))
        throw root.error("environment", "hides the sky: give either [environment] or [sky]");
}

/// A [[primitive]] with a material: a lamp of the scene's rig if that emits even light, else a
/// body, which may be one too.
void take_primitive(const TomlTable& table, const std::vector<Material>& materials,
                    SceneSpec& scene) {
    PrimitiveSpec primitive;
    primitive.shape = primitive_shape_from(table);
    primitive.material = material_of(table, materials);
    if (table.has("luminance") || table.has("luminous_flux") || table.has("color"))
        throw table.error("material", "give either a material, which may emit, or a luminance");
    primitive.name =
        table.text("name").value_or("primitive." + std::to_string(scene.primitives.size()));
    table.finish();
    if (primitive.material.emits == Rgb(0) || has_emission_map(primitive.material)) {
        scene.primitives.push_back(std::move(primitive));
        return;
    }
    if (!scene.rig) scene.rig.emplace();
    for (LightSource& light : lights_of(primitive.shape, primitive.material.emits))
        scene.rig->sources.push_back(std::move(light));
}

/// A [[polygon]] with maps: a flat body that reflects nothing, and emits what they vary.
PrimitiveSpec mapped_polygon_from(const TomlTable& table, std::size_t number) {
    const PolygonLight light = polygon_keys_from(table);
    PrimitiveSpec panel;
    panel.shape = PolygonShape{light.corners};
    panel.name = "polygon." + std::to_string(number);
    panel.material.diffuse = Rgb(0);
    panel.material.refractive_index = 1;
    panel.material.emits = light.luminance;
    panel.material.emits_both_ways = light.two_sided;
    panel.material.maps = luminance_maps_from(table);
    table.finish();
    return panel;
}

/// Panels with maps, named by their number among all panels.
void take_mapped_polygons(const TomlTable& root, SceneSpec& scene) {
    std::size_t number = 0;
    for (const TomlTable& table : root.tables("polygon")) {
        if (table.has("map")) scene.primitives.push_back(mapped_polygon_from(table, number));
        ++number;
    }
}

void take_volumes(const TomlTable& root, SceneSpec& scene) {
    for (const TomlTable& table : root.tables("volume"))
        scene.volumes.push_back(volume_from(table));
    if (!scene.volumes.empty() && scene.rig && scene.rig->medium)
        throw root.error("volume", "stands in no fog: give either [[volume]] or [fog]");
}

CausticSpec caustics_from(const TomlTable& table) {
    CausticSpec caustics;
    caustics.detail = table.integer("detail", 8, 2048).value_or(caustics.detail);
    caustics.interfaces = table.integer("interfaces", 1, 12).value_or(caustics.interfaces);
    caustics.min_weight =
        table.number("min_weight", {.low = 0.001, .high = 1}).value_or(caustics.min_weight);
    table.finish();
    return caustics;
}

RadiositySpec radiosity_from(const TomlTable& table) {
    RadiositySpec spec;
    spec.element = table.number("element", TomlLimits::length()).value_or(spec.element);
    spec.smallest = table.number("smallest", TomlLimits::length()).value_or(spec.smallest);
    spec.contrast = table.number("contrast", {.low = 0.001, .high = 1}).value_or(spec.contrast);
    spec.deviation = table.number("deviation", TomlLimits::length()).value_or(spec.deviation);
    spec.rays = table.integer("rays", 64, 65536).value_or(spec.rays);
    spec.error = table.number("error", {.low = 1e-6, .high = 0.5}).value_or(spec.error);
    table.finish();
    return spec;
}

GroundSpec ground_from(const TomlTable& table, const std::vector<Material>& materials) {
    GroundSpec ground;
    ground.z = table.number("z", TomlLimits::place()).value_or(ground.z);
    ground.material =
        table.has("material") ? material_of(table, materials) : named_material("concrete");
    if (ground.material.emits != Rgb(0))
        throw table.error("material", "a ground cannot emit light: lay a [[polygon]] on it");
    table.finish();
    if (ground.material.texels)
        throw table.error("material", "a ground has no texels: lay a [[polygon]] or a body on it");
    return ground;
}

Animation animation_from(const TomlTable& table, SceneSpec& scene) {
    Animation animation;
    animation.target = table.required("target", table.text("target"));
    for (auto& [frame, value] : table.required("keys", table.keyed_lists("keys"))) {
        if (!animation.keys.empty() && frame <= animation.keys.back().frame)
            throw table.error("keys", "frames must ascend");
        animation.keys.push_back({frame, std::move(value)});
    }
    table.finish();
    if (const auto fault = animation_fault(scene, animation))
        throw table.error(fault->key, shortened(fault->what));
    return animation;
}

} // namespace

SceneSpec parse_scene(std::string_view text, const std::string& source) {
    const TomlTable root = TomlTable::parse(text, source);
    root.require_format("keiko-scene/1");
    SceneSpec scene;
    const auto own_materials = path_from(root, "materials");
    const std::vector<Material> materials =
        own_materials ? read_materials(*own_materials) : standard_materials();
    for (const TomlTable& table : root.tables("model"))
        scene.models.push_back(model_from(table, materials));
    take_eye(root, scene);
    scene.rig = rig_of(root);
    scene.background = root.rgb("background", TomlLimits::light()).value_or(scene.background);
    take_environment(root, scene);
    for (const TomlTable& table : root.tables("primitive"))
        if (table.has("material")) take_primitive(table, materials, scene);
    take_mapped_polygons(root, scene);
    if (const auto ground = root.table("ground")) scene.ground = ground_from(*ground, materials);
    if (const auto caustics = root.table("caustics")) scene.caustics = caustics_from(*caustics);
    if (const auto table = root.table("radiosity")) scene.radiosity = radiosity_from(*table);
    scene.max_depth = root.integer("max_depth", 0, most_reflections);
    scene.min_weight = root.number("min_weight", TomlLimits::share());
    take_volumes(root, scene);
    for (const TomlTable& table : root.tables("animation"))
        scene.animations.push_back(animation_from(table, scene));
    root.finish();
    if (scene.models.empty() && scene.primitives.empty())
        throw root.error(
            "",
            "the scene has no body: neither a [[model]] nor a [[primitive]] that is one nor a "
            "[[polygon]] with a map");
    return scene;
}

SceneSpec read_scene(const fs::path& path) {
    return parse_scene(read_text_file(path), path.string());
}

} // namespace keiko
