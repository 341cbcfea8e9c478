#include "keiko/workflow/place_scene.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/report/json/placement_json.h"
#include "keiko/workflow/placement_mirror.h"
#include "keiko/workflow/version.h"

#include <fnmatch.h>

#include <algorithm>

namespace keiko {
namespace {

/// True if `pattern` is the number of a face or matches its name.
bool means(const std::string& pattern, const Face& face) {
    return pattern == std::to_string(face.id) ||
           fnmatch(pattern.c_str(), face.name.c_str(), 0) == 0;
}

std::vector<std::uint32_t> faces_meant(const SurfaceModel& model,
                                       std::span<const std::string> patterns) {
    std::vector<bool> wanted(model.faces.size(), false);
    for (const std::string& pattern : patterns) {
        bool found = false;
        for (std::size_t i = 0; i < model.faces.size(); ++i) {
            if (!means(pattern, model.faces[i])) continue;
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

} // namespace keiko
