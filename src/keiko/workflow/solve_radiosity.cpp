#include "keiko/workflow/solve_radiosity.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/base/sha256.h"
#include "keiko/base/text.h"
#include "keiko/files/model/model_serialization.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/maps/scene_maps.h"
#include "keiko/math/quadrature.h"
#include "keiko/radiosity/reflected_light.h"
#include "keiko/radiosity/solution_file.h"
#include "keiko/radiosity/solve_elements.h"
#include "keiko/render/shading/paint.h"
#include "keiko/workflow/lit_scene.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Share of uniform light that a base reflects through its coat, to all sides.
Rgb diffuse_reflectance(const Material& material) {
    const ClearCoat base = Paint(material).base();
    constexpr int order = 16;
    return integrate([&](double c) { return base.base_reflectance_diffuse(c) * (2 * c); }, 0, 1,
                     order);
}

std::vector<Rgb> reflectances_of(const Scene& scene) {
    std::vector<Rgb> all;
    for (const Material& material : scene.seen_materials())
        all.push_back(diffuse_reflectance(material));
    return all;
}

/// Throws Error for a material that loses too little light: its reflections would never end.
void require_losses(const Scene& scene, std::span<const Rgb> reflectances) {
    constexpr double least = 1e-6;
    for (std::size_t face = 0; face < reflectances.size(); ++face) {
        const Material& material = scene.seen_materials()[face];
        if (material.glass || max_channel(reflectances[face]) < 1 - least) continue;
        const std::string which = material.name.empty()
                                      ? "of face " + std::to_string(scene.face_id(face))
                                      : in_quotes(material.name);
        throw Error(source_of(scene), "material " + which,
                    "reflects all light: radiosity needs less than 1");
    }
}

bool has_reflectance_map(const Material& material) {
    return std::any_of(material.maps.begin(), material.maps.end(), [](const MaterialMap& map) {
        return map.drives == MappedQuantity::diffuse;
    });
}

std::vector<bool> glass_faces(const Scene& scene) {
    std::vector<bool> glass;
    for (const Material& material : scene.seen_materials())
        glass.push_back(material.glass.has_value());
    return glass;
}

const LightRig& rig_of(const Scene& scene) {
    if (!scene.rig || scene.rig->sources.empty())
        throw Error(source_of(scene), "", "has no lamps, whose light could be reflected");
    return *scene.rig;
}

std::string geometry_hash(const Scene& scene) {
    SurfaceModel seen = visible_model(scene, scene.model);
    seen.source.clear(), seen.files.clear(), seen.diagnostics.clear();
    return sha256_hex(serialize(seen));
}

void add_table(const IntensityTable& table, std::vector<double>& numbers) {
    for (const auto* angles : {&table.vertical(), &table.horizontal()})
        numbers.insert(numbers.end(), angles->begin(), angles->end());
    for (std::size_t h = 0; h < table.horizontal().size(); ++h)
        for (std::size_t v = 0; v < table.vertical().size(); ++v)
            numbers.push_back(table.value(h, v));
}

/// All numbers that the light of a scene depends on, beside those of its lamps in the rig.
std::vector<double> lighting_numbers(const Scene& scene) {
    std::vector<double> numbers;
    const auto add = [&](const Rgb& c) { numbers.insert(numbers.end(), {c.r, c.g, c.b}); };
    for (const Rgb& reflectance : reflectances_of(scene)) add(reflectance);
    for (const Material& material : scene.seen_materials()) {
        add(material.emits);
        const Glass glass = material.glass.value_or(Glass{});
        add(glass.absorption);
        numbers.insert(numbers.end(),
                       {material.glass ? 1.0 : 0.0, glass.pane, material.refractive_index,
                        material.emits_both_ways ? 1.0 : 0.0});
    }
    if (const auto& caustics = scene.caustics)
        numbers.insert(numbers.end(),
                       {1.0 * caustics->detail, 1.0 * caustics->interfaces, caustics->min_weight});
    for (const LightSource& source : scene.rig->sources)
        if (const auto* luminaire = std::get_if<Luminaire>(&source))
            add_table(luminaire->web->candela, numbers);
    return numbers;
}

std::string lighting_hash(const Scene& scene) {
    std::string text = rig_text(rig_of(scene));
    for (const double number : lighting_numbers(scene)) text += toml_value(number) + ' ';
    return sha256_hex(text);
}

/// Direct light of both faces of an element at its centre, on its own exact surface: beside a thin
/// sheet the other skin may be nearer.
std::array<Rgb, 2> direct_light(const LitScene& lit, const Tracer& surfaces,
                                const ElementMesh& elements, std::uint32_t triangle) {
    Vec3 place = elements.middle(triangle), normal = elements.normal(triangle).normalized();
    constexpr double rounding = 1e-3; // mm
    const double reach = elements.mesh.deviation + rounding;
    const PlacedFace own{elements.instances[triangle], elements.mesh.faces[triangle]};
    if (const auto hit = nearest_along(surfaces, place, normal, reach, own)) {
        place = hit->position;
        normal = hit->normal.dot(normal) < 0 ? -hit->normal : hit->normal;
    }
    std::array<Rgb, 2> light{};
    if (lit.source_around(place)) return light;
    for (const std::size_t side : {0, 1})
        for (const Rgb& lux : lit.direct(place, side == 0 ? normal : -normal)) light[side] += lux;
    return light;
}

} // namespace

RadiositySolution solve_radiosity(const Scene& scene, const Job& job) {
    if (!scene.occluders) throw FieldError("shadows", "are needed for light that is reflected");
    const LightRig& rig = rig_of(scene);
    const RadiositySpec spec = scene.radiosity.value_or(RadiositySpec());
    const std::vector<Rgb> reflectances = reflectances_of(scene);
    require_losses(scene, reflectances);
    const SurfaceModel seen = visible_model(scene, scene.model);
    const LitScene lit(scene, rig, TubeModel::picture, job);
    ElementSubdivision elements(seen, spec.deviation, glass_faces(scene), job);
    const auto direct = light_elements(
        elements, spec, scene.tracer.bounds(),
        [&](const ElementMesh& mesh, std::uint32_t triangle) {
            return direct_light(lit, scene.seen(), mesh, triangle);
        },
        job);
    RadiositySolution solution =
        solve_elements(elements.elements(), direct, reflectances, spec, job);
    solution.geometry = geometry_hash(scene);
    solution.lighting = lighting_hash(scene);
    return solution;
}

Diagnostics radiosity_remarks(const Scene& scene) {
    Diagnostics remarks;
    const auto warn = [&](const std::string& left_out) {
        remarks.push_back({Severity::warning, "radiosity", "leaves out " + left_out});
    };
    const std::vector<Material>& materials = scene.seen_materials();
    if (std::any_of(materials.begin(), materials.end(), has_reflectance_map))
        warn("maps of reflectances: a face has that of its material all over");
    if (scene.maps && scene.maps->environment() && scene.maps->environment()->spec().lights)
        warn("the light of the environment");
    if (scene.texels) warn("texels: faces reflect as without them");
    if (scene.volumes) warn("volumes: they neither take nor scatter its light");
    return remarks;
}

void write_solution(const std::filesystem::path& path, const RadiositySolution& solution) {
    if (!std::isfinite(solution.remaining))
        throw Error(path.string(), "remaining", "is not finite: no light was found");
    write_text_file(path, solution_text(solution));
}

void take_solution(Scene& scene, const std::filesystem::path& path) {
    RadiositySolution solution = parse_solution(read_text_file(path), path.string());
    if (solution.geometry != geometry_hash(scene))
        throw Error(path.string(), "geometry", "is of other geometry than " + source_of(scene));
    if (solution.lighting != lighting_hash(scene))
        throw Error(path.string(), "lighting",
                    "is of other lamps or reflectances than " + source_of(scene));
    scene.reflected = std::make_shared<const ReflectedLight>(std::move(solution));
}

} // namespace keiko
