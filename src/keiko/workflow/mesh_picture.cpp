#include "keiko/workflow/mesh_picture.h"

#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/parallel.h"
#include "keiko/base/text.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/raster/mesh_shading.h"
#include "keiko/raster/pixel_facets.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/workflow/hidden_faces.h"
#include "keiko/workflow/mesh_light_shares.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

namespace keiko {
namespace {

constexpr std::string_view prefix = "mesh:";

/// The numbers of all faces of a scene's body.
std::vector<std::uint32_t> body_ids(const SurfaceModel& model) {
    std::vector<std::uint32_t> ids;
    for (const Face& face : model.faces) ids.push_back(face.id);
    return ids;
}

/// The light of a scene without its body, on a mesh that stands in the body's place.
class MeshLight {
public:
    MeshLight(const Scene& scene, const LightRig& rig, const SurfaceMesh& mesh)
        : rest_(seen_without(scene, body_ids(scene.model))),
          picture_{rest_, scene.seen_materials(), rig, scene.background, nullptr, scene.maps.get()},
          options_(picture_options(scene)),
          integrator_(picture_, options_) {
        std::map<std::uint32_t, std::uint32_t> paints;
        for (std::size_t f = 0; f < scene.model.faces.size(); ++f)
            paints[scene.model.faces[f].id] = integrator_.paint_number(f);
        for (const std::uint32_t face : mesh.faces) paint_of_triangle_.push_back(paints.at(face));
    }

    /// cd/m2 that a place of the mesh sends to the eye.
    Rgb of(const ShadedPlace& lit) const {
        return integrator_.luminance(shading_point(lit), lit.mirrored);
    }
    /// cd/m2 of it by a source that is one light.
    Rgb of_source(const ShadedPlace& lit, std::size_t source) const {
        return by_source(shading_point(lit), source);
    }
    /// cd/m2 along a camera ray that meets no triangle.
    Rgb beside(const Ray& ray) const {
        return integrator_.follow(std::span(&ray, 1)).samples.front().luminance;
    }
    /// cd/m2 of it by a source that is one light, on the first surface.
    Rgb beside_by_source(const Ray& ray, std::size_t source) const {
        Rgb sum;
        for (const ShadingPoint& point : integrator_.view(Rays{ray}).points)
            if (point.branch == 0) sum += point.weight * by_source(point, source);
        return sum;
    }

private:
    ShadingPoint shading_point(const ShadedPlace& lit) const {
        ShadingPoint point;
        point.place = {lit.place.position, lit.place.normal,
                       paint_of_triangle_[lit.place.triangle]};
        point.eye = lit.eye;
        return point;
    }
    Rgb by_source(const ShadingPoint& point, std::size_t source) const {
        const std::array lights{LightId{source, 0}};
        return integrator_.luminance(
            point,
            integrator_.direct_light(point, lights, integrator_.light_visibility(point, lights))
                .front());
    }

    Tracer rest_; ///< of the scene
    PictureScene picture_;
    PictureOptions options_;
    Integrator integrator_;
    std::vector<std::uint32_t> paint_of_triangle_;
};

std::array<float, 3> channels_of(const Rgb& color) {
    return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
}

/// Fills the pixels of a film that show no triangle, and its alpha.
void add_surroundings(Film& film, const MeshView& view, const MeshLight& light, const Job& job) {
    const ItemBuffer& items = view.items();
    parallel_for(static_cast<std::size_t>(items.height), job, "", [&](std::size_t row) {
        const auto y = static_cast<int>(row);
        for (int x = 0; x < items.width; ++x) {
            const bool covered = items.at(x, y) != no_index;
            *film.alpha.pixel(x, y) = covered ? 1.0F : 0.0F;
            if (covered) continue;
            const auto seen = channels_of(light.beside(view.camera().ray(x + 0.5, y + 0.5)));
            std::copy(seen.begin(), seen.end(), film.color.pixel(x, y));
        }
    });
}

/// A mesh, and after it the triangles of the scene's ground, of face 0.
SurfaceMesh on_ground(SurfaceMesh mesh, const Scene& scene) {
    if (!scene.ground()) return mesh;
    const SurfaceModel plane = ground_plane(*scene.ground(), scene.tracer.bounds());
    for (std::uint32_t p = 0; p < plane.patches.size(); ++p) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Vec2& uv : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
            mesh.positions.push_back(evaluate(plane.patch(p), uv, 0).position());
            mesh.normals.emplace_back(0, 0, 1);
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
        mesh.faces.insert(mesh.faces.end(), 2, 0);
    }
    return mesh;
}

/// Takes the light from a film that does not reach its pixels.
void take_shaded(Film& film, const MeshView& view, const MeshLight& light, MeshShading shading,
                 const MeshLightShare& shaded, const Job& job) {
    const auto of_source = [&](const ShadedPlace& lit) {
        return light.of_source(lit, shaded.source);
    };
    Image by_source = shaded_mesh(view, shading, of_source, job);
    parallel_for(static_cast<std::size_t>(by_source.height), job, "", [&](std::size_t row) {
        const auto y = static_cast<int>(row);
        for (int x = 0; x < by_source.width; ++x) {
            const float taken = 1 - *shaded.share.pixel(x, y);
            if (!(taken > 0)) continue;
            float* all = film.color.pixel(x, y);
            std::array<float, 3> own{};
            if (view.items().at(x, y) != no_index)
                std::copy_n(by_source.pixel(x, y), 3, own.begin());
            else
                own = channels_of(
                    light.beside_by_source(view.camera().ray(x + 0.5, y + 0.5), shaded.source));
            for (std::size_t i = 0; i < 3; ++i) all[i] = std::max(all[i] - taken * own[i], 0.0F);
        }
    });
}

/// Throws FieldError for a scene that such a picture would show without a part of it.
void require_plain(const Scene& scene, const LightRig& rig) {
    const auto refuse = [](const std::string& what) {
        throw FieldError("look", "a mesh is shown without " + what + ", which the scene has");
    };
    if (rig.medium) refuse("fog");
    if (scene.volumes) refuse("volumes");
    if (scene.caustics) refuse("caustics");
    if (scene.reflected) refuse("light of a solution");
    for (const Material& material : scene.seen_materials()) {
        if (material.emits != Rgb(0)) refuse("bodies that emit light");
        if (!material.maps.empty()) refuse("maps of materials");
        if (material.texels) refuse("texels of materials");
        if (material.roughness && material.roughness->scratches) refuse("brushed metal");
    }
}

/// Throws FieldError for what only a mesh has, not facets of a pixel.
void require_no_mesh_options(const MeshLook& look) {
    if (look.shadows != MeshShadows::none)
        throw FieldError("mesh-shadows", "facets of a pixel are of what is seen, and cast none");
    if (look.hidden_surfaces != HiddenSurfaces::z_buffer)
        throw FieldError("hidden-surfaces",
                         "facets of a pixel are made of what recursive subdivision finds");
}

} // namespace

std::optional<MeshShading> mesh_shading_from(const std::string& look) {
    if (!look.starts_with(prefix)) return std::nullopt;
    std::vector<std::string> known;
    for (const MeshShading shading :
         {MeshShading::constant, MeshShading::gouraud, MeshShading::phong}) {
        known.push_back(std::string(prefix) + std::string(name_of(shading)));
        if (known.back() == look) return shading;
    }
    throw FieldError("look", "no look is called " + in_quotes(look) + "; of meshes there are " +
                                 comma_list(known) + did_you_mean(look, known));
}

namespace {

Film shaded_film(const MeshView& view, const MeshLight& light, MeshShading shading,
                 const Job& job) {
    Film film{shaded_mesh(
                  view, shading, [&](const ShadedPlace& lit) { return light.of(lit); }, job),
              Image(view.items().width, view.items().height, 1),
              {}};
    add_surroundings(film, view, light, job);
    return film;
}

Film pixel_film(const Scene& scene, const LightRig& rig, const Camera& camera, const MeshLook& look,
                JobSteps& steps, double dividing, double shading) {
    const PixelFacets facets = pixel_facets(scene.model, camera, steps.next(dividing, 2));
    const MeshView view(facets.mesh, camera, facets.items);
    return shaded_film(view, MeshLight(scene, rig, facets.mesh), look.shading, steps.next(shading));
}

} // namespace

Film mesh_film(const Scene& scene, const LightRig& rig, const Camera& camera, const MeshLook& look,
               const Job& job) {
    require_plain(scene, rig);
    if (look.by_pixels) require_no_mesh_options(look);
    constexpr double meshing = 3, shading = 2;
    JobSteps steps(job, meshing + shading);
    if (look.by_pixels) return pixel_film(scene, rig, camera, look, steps, meshing, shading);
    const SurfaceMesh triangles = surface_mesh(scene, look.mesh, steps.next(meshing));
    const Job to_shade = steps.next(shading);
    const MeshView view(triangles, camera, to_shade, look.hidden_surfaces);
    const MeshLight light(scene, rig, triangles);
    Film film = shaded_film(view, light, look.shading, to_shade);
    if (look.shadows == MeshShadows::none) return film;
    const SurfaceMesh grounded = on_ground(triangles, scene);
    const MeshView receiving(grounded, camera, to_shade);
    for (const MeshLightShare& shaded :
         mesh_light_shares(rig, receiving, ShadowCasters(triangles), look.shadows, to_shade))
        take_shaded(film, view, light, look.shading, shaded, to_shade);
    return film;
}

} // namespace keiko
