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
#include "keiko/radiosity/lamp_levels.h"
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

/// All numbers that the light of a scene depends on, beside its rig and the levels of lamps.
std::vector<double> lighting_numbers(const Scene& scene, const LightRig& rig) {
    std::vector<double> numbers;
    const auto add = [&](const Rgb& c) { numbers.insert(numbers.end(), {c.r, c.g, c.b}); };
    for (const Rgb& reflectance : reflectances_of(scene)) add(reflectance);
    for (const Material& material : scene.seen_materials()) {
        const Glass glass = material.glass.value_or(Glass{});
        add(glass.absorption);
        numbers.insert(
            numbers.end(),
            {material.glass ? 1.0 : 0.0, glass.pane, material.refractive_index,
             material.emits != Rgb(0) ? 1.0 : 0.0, material.emits_both_ways ? 1.0 : 0.0});
    }
    if (const auto& caustics = scene.caustics)
        numbers.insert(numbers.end(),
                       {1.0 * caustics->detail, 1.0 * caustics->interfaces, caustics->min_weight});
    for (const LightSource& source : rig.sources)
        if (const auto* luminaire = std::get_if<Luminaire>(&source))
            add_table(luminaire->web->candela, numbers);
    return numbers;
}

/// The rig with the pitch of each row of lamps, which files may leave to their number.
LightRig with_stated_pitches(LightRig rig) {
    for (LightSource& source : rig.sources)
        if (auto* plane = std::get_if<CPlane>(&source)) plane->pitch = plane->spacing();
    return rig;
}

/// Hash of lamps without their levels, and of reflectances.
std::string lighting_hash(const Scene& scene, const LightRig& rig) {
    std::string text = rig_text(with_stated_pitches(at_unit_levels(rig)));
    for (const double number : lighting_numbers(scene, rig)) text += toml_value(number) + ' ';
    return sha256_hex(text);
}

/// True for faces that light passes: glass and lamps.
std::vector<bool> faces_without_elements(const Scene& scene) {
    return shadowless_faces(scene.seen_materials());
}

/// Tracer of what has elements.
Tracer reflecting(const Scene& scene) {
    return scene.seen().without(faces_without_elements(scene));
}

} // namespace

RadiositySolution solve_radiosity(const Scene& scene, const Job& job) {
    if (!scene.occluders) throw FieldError("shadows", "are needed for light that is reflected");
    const LightRig unit = at_unit_levels(rig_of(scene));
    const std::vector<Rgb> levels = levels_of(rig_of(scene));
    const RadiositySpec spec = scene.radiosity.value_or(RadiositySpec());
    const std::vector<Rgb> reflectances = reflectances_of(scene);
    require_losses(scene, reflectances);
    const SurfaceModel seen = visible_model(scene, scene.model);
    const LitScene lit(scene, unit, TubeModel::picture, job);
    ElementSubdivision triangles(seen, spec.deviation, faces_without_elements(scene), job);
    const auto direct_light = [&](const LightPoint& point) {
        return lit.source_around(point.position) ? std::vector<Rgb>(levels.size())
                                                 : lit.direct(point.position, point.normal);
    };
    const DirectLights direct =
        divide_and_light(triangles, seen, spec, scene.tracer.bounds(), levels, direct_light, job);
    const Tracer tracer = reflecting(scene);
    RadiositySolution solution = solve_elements({seen, tracer, reflectances}, triangles.elements(),
                                                direct, levels, spec, job);
    solution.geometry = geometry_hash(scene);
    solution.lighting = lighting_hash(scene, rig_of(scene));
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

namespace {

/// Throws Error for a solution that was changed by hand, with places that are not in its scene.
void require_places(const RadiositySolution& solution, const SurfaceModel& model,
                    const std::string& source) {
    for (const SolvedTriangle& triangle : solution.triangles)
        if (triangle.face >= model.faces.size() || triangle.instance >= model.instances.size())
            throw Error(source, "triangles", "are of a face that is not in the scene");
}

} // namespace

RadiositySolution read_solution(const std::filesystem::path& path) {
    return parse_solution(read_text_file(path), path.string());
}

std::shared_ptr<const ReflectedLight> reflected_light(const Scene& scene, const LightRig& rig,
                                                      const RadiositySolution& solution,
                                                      const std::string& source) {
    if (solution.geometry != geometry_hash(scene))
        throw Error(source, "geometry", "is of other geometry than " + source_of(scene));
    if (solution.lighting != lighting_hash(scene, rig))
        throw Error(source, "lighting",
                    "is of other lamps, beside their levels, or other reflectances than " +
                        source_of(scene));
    SurfaceModel seen = visible_model(scene, scene.model);
    require_places(solution, seen, source);
    return std::make_shared<const ReflectedLight>(solution, levels_of(rig), reflectances_of(scene),
                                                  std::move(seen), reflecting(scene));
}

void take_solution(Scene& scene, const RadiositySolution& solution, const std::string& source) {
    scene.reflected = reflected_light(scene, rig_of(scene), solution, source);
}

} // namespace keiko
