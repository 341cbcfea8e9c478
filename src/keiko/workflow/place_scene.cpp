#include "keiko/workflow/place_scene.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/compare/shape/symmetry.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/light/rig/body_lamps.h"
#include "keiko/maps/scene_maps.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/report/json/placement_json.h"
#include "keiko/workflow/face_sets.h"
#include "keiko/workflow/version.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

std::vector<std::uint32_t> faces_meant(const SurfaceModel& model,
                                       std::span<const std::string> patterns) {
    std::vector<bool> wanted(model.faces.size(), false);
    for (const std::string& pattern : patterns) {
        bool found = false;
        for (std::size_t i = 0; i < model.faces.size(); ++i) {
            if (!names_face(pattern, model.faces[i])) continue;
            wanted[i] = found = true;
        }
        if (!found)
            throw FieldError("faces", "no face has the number or a name like '" + pattern + "'");
    }
    std::vector<std::uint32_t> faces;
    for (std::uint32_t i = 0; i < wanted.size(); ++i)
        if (wanted[i]) faces.push_back(i);
    return faces;
}

std::vector<ViewSample> looks(const Scene& scene, const PlaceOptions& options,
                              std::span<const NamedView> views, const SamplingOptions& sampling,
                              const Job& job) {
    if (options.hits) return options.hits->chosen(scene.model, scene.tracer.bounds(), sampling);
    return sample_views(scene.tracer, scene.model, cameras_of(views), sampling, job);
}

/// Planes through the camera's eye across each axis, at 0 if they are there to within rounding.
std::vector<MirrorPlane> planes_through(const Camera& camera) {
    const double rounding = 1e-9 * (camera.target - camera.eye).length();
    std::vector<MirrorPlane> planes;
    for (const int axis : {1, 0, 2}) {
        const double offset = camera.eye[axis];
        planes.push_back({axis, std::abs(offset) < rounding ? 0 : offset});
    }
    return planes;
}

bool is_symmetric(std::span<const Camera> cameras, const MirrorPlane& plane) {
    return std::all_of(cameras.begin(), cameras.end(),
                       [&](const Camera& camera) { return is_own_image(camera, plane); });
}

/// True if the image of each direction is among them.
bool is_symmetric(const PlaneChoice& where, const MirrorPlane& plane) {
    const auto has_image = [&](const Vec3& direction) {
        constexpr double same = 1 - 1e-12; // cosine
        const Vec3 image = plane.image_of_direction(direction);
        return std::any_of(where.towards.begin(), where.towards.end(),
                           [&](const Vec3& other) { return other.dot(image) > same; });
    };
    return where.frames.empty() &&
           std::all_of(where.towards.begin(), where.towards.end(), has_image);
}

} // namespace

std::string hits_text(const RegisteredHits& hits) {
    return hits_json(hits, version());
}

RegisteredHits read_hits(const std::filesystem::path& file) {
    return hits_from_json(read_text_file(file), file.string());
}

PlaceResult place_scene(const Scene& scene, const PlaceOptions& options, const Job& job) {
    PlacementOptions placing = options.placement;
    placing.sampling.faces = faces_meant(scene.model, options.faces);
    PlaceResult result;
    result.views = options.hits ? options.hits->views : choose_views(scene, options.views, 1, job);
    std::vector<ViewSample> seen = looks(scene, options, result.views, placing.sampling, job);
    if (!options.rated)
        placing.mirror =
            placement_mirror(scene.model, cameras_of(result.views), placing, options.symmetry, job);
    const int height = result.views.front().camera.height;
    result.placement = options.rated ? rated_rig(std::move(seen), scene.model, height,
                                                 *options.rated, placing.spacing)
                                     : place_lamps(std::move(seen), scene.model,
                                                   scene.tracer.bounds(), height, placing, job);
    return result;
}

std::optional<MirrorPlane> placement_mirror(const SurfaceModel& model,
                                            std::span<const Camera> cameras,
                                            const PlacementOptions& options,
                                            const SymmetryChoice& choice, const Job& job) {
    if (choice.kind == SymmetryChoice::Kind::off || cameras.empty()) return std::nullopt;
    const bool given = choice.kind == SymmetryChoice::Kind::plane;
    for (const MirrorPlane& plane :
         given ? std::vector{choice.plane} : planes_through(cameras.front()))
        if (is_symmetric(cameras, plane) && is_symmetric(options.where, plane) &&
            is_own_image(model, plane, choice.distance, options.sampling.faces, job))
            return plane;
    return std::nullopt;
}

namespace {

/// Throws Error for lamps with a sky in a scene with other surroundings.
void require_no_second_sky(const Scene& scene, const LightRig& rig,
                           const std::filesystem::path& file) {
    if (!scene.maps || !scene.maps->environment()) return;
    for (const LightSource& source : rig.sources)
        if (std::holds_alternative<SkyLight>(source))
            throw Error(file.string(), "sky", "is hidden by the scene's [environment]");
}

/// Throws Error for lamps with fog in a scene with volumes.
void require_no_fog_about_volumes(const Scene& scene, const LightRig& rig,
                                  const std::filesystem::path& file) {
    if (scene.volumes && rig.medium)
        throw Error(file.string(), "fog", "cannot surround the scene's [[volume]]");
}

} // namespace

ChosenLights choose_lights(const Scene& scene, const std::optional<std::filesystem::path>& rig,
                           std::span<const NamedView> views, const PlacementOptions& options,
                           const Job& job) {
    if (rig) {
        LightRig lamps = read_rig(*rig);
        require_no_second_sky(scene, lamps, *rig);
        require_no_fog_about_volumes(scene, lamps, *rig);
        add_body_lamps(scene.rig, lamps);
        return {std::move(lamps)};
    }
    if (scene.rig) return {*scene.rig};
    Placement placement = place_lamps(scene.tracer, scene.model, cameras_of(views), options, job);
    return {placement.rig, std::move(placement)};
}

} // namespace keiko
