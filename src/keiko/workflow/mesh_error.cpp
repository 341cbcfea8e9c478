#include "keiko/workflow/mesh_error.h"

#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/text.h"
#include "keiko/film/image_file.h"
#include "keiko/raster/mesh_comparison.h"
#include "keiko/raster/mirror_images.h"
#include "keiko/workflow/choose_views.h"
#include "keiko/workflow/version.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace keiko {
namespace {

constexpr int automatic_views = 3;
constexpr int close_up_side = 360; // pixels
constexpr double magnification = 4;

void require_options(const MeshErrorOptions& options) {
    if (options.deviations.empty()) throw FieldError("mesh", "names no deviation");
    for (const double deviation : options.deviations)
        if (!(deviation > 0 && std::isfinite(deviation)))
            throw FieldError("mesh", "must be above 0 mm");
    const std::set<double> each(options.deviations.begin(), options.deviations.end());
    if (each.size() < options.deviations.size())
        throw FieldError("mesh", "names a deviation twice");
}

ChosenLights lights_of(const Scene& scene, const MeshErrorOptions& options,
                       const std::vector<NamedView>& views, const Job& job) {
    ChosenLights lights = choose_lights(scene, options.rig, views, options.placement, job);
    if (RigPlanes(lights.rig).planes().empty())
        throw Error(options.rig ? options.rig->string() : source_of(scene), "rig",
                    "it has no rows of tubes, whose reflections could be compared");
    return lights;
}

std::string source_of(const ChosenLights& lights, const MeshErrorOptions& options) {
    if (options.rig) return "of " + options.rig->string();
    return lights.placement ? "placed on the part" : "of the scene";
}

/// "front-mesh-2-wrong.png" of the second mesh.
std::string png_name(const std::string& view, std::size_t mesh, const std::string& what) {
    return view + "-mesh-" + std::to_string(mesh + 1) + what + ".png";
}

/// Compares the meshes in one view.
class ViewComparison {
public:
    ViewComparison(const Scene& scene, const RigPlanes& lamps,
                   const std::vector<SurfaceMesh>& meshes, const NamedView& view,
                   MeshErrorReport& report)
        : scene_(scene), lamps_(lamps), meshes_(meshes), view_(view), report_(report) {}

    MeshErrorView run(const Job& job) {
        const Camera& camera = view_.camera;
        const MirrorPicture truth =
            mirror_picture(scene_.tracer, scene_.model, camera, lamps_, job);
        MeshErrorView result{view_.name, camera.width, camera.height};
        result.truth = add(view_.name + "-surface.png", mirror_image(truth));
        std::optional<Vec2> place;
        for (std::size_t m = 0; m < meshes_.size(); ++m) {
            const MeshView seen(meshes_[m], camera, job);
            const MirrorPicture mirrored = mirror_picture(seen, lamps_, job);
            if (m == coarsest())
                place = most_wrong_place(truth, mirrored, close_up_side / magnification);
            result.meshes.push_back(
                {mesh_errors(truth, mirrored, camera), facet_bands(seen, truth, mirrored, job)});
            MeshErrorPictures& pictures = result.meshes.back();
            pictures.mirror = add(png_name(view_.name, m, ""), mirror_image(mirrored));
            pictures.wrong = add(png_name(view_.name, m, "-wrong"), wrong_image(truth, mirrored));
        }
        result.close_up_side = close_up_side, result.magnification = magnification;
        if (place) add_close_ups(*place, job, result);
        return result;
    }

private:
    /// The mesh of the largest wanted deviation.
    std::size_t coarsest() const {
        const std::vector<ComparedMesh>& all = report_.meshes;
        const auto largest = std::max_element(
            all.begin(), all.end(),
            [](const ComparedMesh& a, const ComparedMesh& b) { return a.asked < b.asked; });
        return static_cast<std::size_t>(largest - all.begin());
    }

    void add_close_ups(const Vec2& place, const Job& job, MeshErrorView& result) {
        const Camera near = magnified(view_.camera, place, close_up_side, magnification);
        for (std::size_t m = 0; m < meshes_.size(); ++m) {
            const MeshView closer(meshes_[m], near, job);
            result.meshes[m].close_up = add(png_name(view_.name, m, "-close-up"),
                                            mirror_image(mirror_picture(closer, lamps_, job)));
        }
        result.close_up =
            add(view_.name + "-surface-close-up.png",
                mirror_image(mirror_picture(scene_.tracer, scene_.model, near, lamps_, job)));
    }

    std::string add(const std::string& name, const Image& picture) {
        report_.pngs[name] = encode_png(picture);
        return name;
    }

    const Scene& scene_;
    const RigPlanes& lamps_;
    const std::vector<SurfaceMesh>& meshes_;
    const NamedView& view_;
    MeshErrorReport& report_;
};

/// The meshes, each a step of a weight, and what the report says of them.
std::vector<SurfaceMesh> make_meshes(const Scene& scene, const MeshErrorOptions& options,
                                     JobSteps& steps, double weight,
                                     std::vector<ComparedMesh>& told) {
    std::vector<SurfaceMesh> meshes;
    TriangleLimit limit{options.most_triangles};
    for (const double deviation : options.deviations) {
        meshes.push_back(surface_mesh(scene,
                                      {.deviation = deviation,
                                       .load = options.load,
                                       .mesher = options.mesher,
                                       .normals = options.normals,
                                       .limit = limit},
                                      steps.next(weight)));
        const SurfaceMesh& mesh = meshes.back();
        limit.beside += mesh.triangles.size();
        told.push_back({deviation, mesh.deviation, mesh.triangles.size(), mesh.lost_faces});
    }
    return meshes;
}

} // namespace

MeshErrorReport mesh_error(const Scene& scene, const MeshErrorOptions& options, const Job& job) {
    require_options(options);
    constexpr double placing = 4, meshing = 4, comparing = 2;
    const auto meshes = static_cast<double>(options.deviations.size());
    JobSteps steps(job, placing + meshing * meshes + comparing * automatic_views);
    const Job to_place = steps.next_of_steps(placing);
    const std::vector<NamedView> views =
        choose_views(scene, options.views, automatic_views, to_place);
    require_different_names(views);
    const ChosenLights lights = lights_of(scene, options, views, to_place);
    MeshErrorReport report{version(), source_of(scene), source_of(lights, options),
                           options.normals == CornerNormals::averaged,
                           options.mesher == Mesher::spans};
    const std::vector<SurfaceMesh> triangles =
        make_meshes(scene, options, steps, meshing, report.meshes);
    const RigPlanes lamps(lights.rig);
    const double each = comparing * automatic_views / static_cast<double>(views.size());
    for (const NamedView& view : views)
        report.views.push_back(
            ViewComparison(scene, lamps, triangles, view, report).run(steps.next_of_steps(each)));
    return report;
}

FolderContent mesh_error_files(const MeshErrorReport& report) {
    FolderContent files = report.pngs;
    files["mesh-error.json"] = mesh_error_json(report);
    files["mesh-error.html"] = mesh_error_html(report);
    return files;
}

} // namespace keiko
