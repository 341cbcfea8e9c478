#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/math/affine.h"
#include "keiko/render/shading/picture.h"
#include "keiko/scene/analysis.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/material.h"
#include "keiko/scene/radiosity_spec.h"
#include "keiko/visibility/query/occluders.h"
#include "keiko/workflow/followed_analysis.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Options of open_scene.
struct SceneOptions {
    LoadOptions load;                        ///< of the model files
    std::string material = "black-show-car"; ///< of models that no scene file paints
    bool clipping_only = false;              ///< trace by Bezier clipping alone, see TracerOptions
    bool shadows = false;                    ///< bodies cast shadows, in pictures and numbers
    double frame = 0;                        ///< of a scene file with [[animation]]
    std::optional<Analysis> analysis{};      ///< whose views and lamps replace the scene's own
};

/// The body on its ground in pictures: the faces of the body, then that of the ground.
struct Surroundings {
    double ground = 0;               ///< mm, its z
    std::vector<Material> materials; ///< one a face of its tracer
    Tracer tracer;                   ///< of the body and the ground
};

/// A body prepared for rendering.
struct Scene {
    SurfaceModel model;                            ///< the body, all models as one
    std::vector<Material> materials;               ///< one a face of the model
    Tracer tracer;                                 ///< of the body alone
    std::optional<Occluders> occluders;            ///< of the visible geometry, if it casts shadows
    std::optional<Camera> camera;                  ///< of the scene file
    std::optional<std::string> view;               ///< a named view of the scene file
    std::optional<LightRig> rig;                   ///< of the scene file, if it has lamps
    Rgb background{0};                             ///< cd/m2 behind the body
    int width = 960, height = 540;                 ///< pixels of its pictures
    std::optional<Surroundings> surroundings{};    ///< of a scene file with [ground]
    std::optional<int> max_depth{};                ///< of the scene file, else of
    std::optional<double> min_weight{};            ///< PictureOptions
    std::vector<std::filesystem::path> inputs{};   ///< model files, or the scene file
    std::optional<FollowedAnalysis> analysis{};    ///< that it was opened with, on its body
    std::shared_ptr<const SceneMaps> maps{};       ///< of its materials, and its environment
    std::optional<CausticSpec> caustics{};         ///< of the scene file
    std::shared_ptr<const SceneVolumes> volumes{}; ///< of the scene file; null: none
    std::optional<RadiositySpec> radiosity{};      ///< of the scene file
    std::shared_ptr<const ReflectedLight> reflected{}; ///< by take_solution(); null: none
    std::shared_ptr<const SceneTexels> texels{};       ///< of its materials; null: none

    /// Tracer of pictures and rays: the body, and the ground if there is one.
    const Tracer& seen() const { return surroundings ? surroundings->tracer : tracer; }
    /// Materials by face of seen().
    const std::vector<Material>& seen_materials() const {
        return surroundings ? surroundings->materials : materials;
    }
    /// mm, z of the ground; nullopt without one.
    std::optional<double> ground() const {
        return surroundings ? std::optional(surroundings->ground) : std::nullopt;
    }
    /// Scene of pictures under a rig, to which, as to the scene, a reference is kept.
    PictureScene picture(const LightRig& under) const {
        return {seen(),
                seen_materials(),
                under,
                background,
                occluders ? &*occluders : nullptr,
                maps.get(),
                caustics,
                volumes.get(),
                reflected.get(),
                texels.get()};
    }
    /// Sets the size of its pictures, in pixels, and of its camera.
    void set_picture_size(int wide, int high);
    /// The number of a face of the visible geometry in files and reports; 0: the ground.
    std::uint32_t face_id(std::size_t face) const {
        return face < model.faces.size() ? model.faces[face].id : 0;
    }
};

/// Options of a scene's pictures. The limits of reflections in a scene file replace those of
/// `options`.
PictureOptions picture_options(const Scene& scene, PictureOptions options = {});

/// Opens models, which together form one body, or one scene file (.toml). Throws Error for input
/// that cannot be read.
Scene open_scene(std::span<const std::filesystem::path> inputs, const SceneOptions& options = {},
                 const Job& job = {});

/// The scene of a body that has been read, in the named material. `load` of the options is not
/// read. Throws Error for an unknown material, and for an analysis that hides every face.
Scene scene_of_model(SurfaceModel body, const SceneOptions& options = {}, const Job& job = {});

/// The files that a scene was opened from, or else the source of its body.
std::string source_of(const Scene& scene);

/// The scene with its body moved; ground, lamps and camera stay. `options` are those by which it
/// was opened.
Scene moved_scene(Scene scene, const Affine& motion, const SceneOptions& options = {},
                  const Job& job = {});

/// The visible geometry of a scene with another body in place of its own: that body and the ground.
SurfaceModel visible_model(const Scene& scene, SurfaceModel body);

/// Renders one picture of the scene under a rig.
Film render_view(const Scene& scene, const LightRig& rig, const Camera& camera,
                 PictureOptions options = {}, const Job& job = {});

/// Renders one picture of a part of a scene; see seen_without.
Film render_part(const Scene& scene, const PictureScene& part, const Camera& camera,
                 PictureOptions options = {}, const Job& job = {});

/// Renders one picture that tone_mapped() will show: PictureOptions::white is about the film's own
/// white_luminance().
Film render_to_show(const Scene& scene, const LightRig& rig, const Camera& camera,
                    PictureOptions options = {}, const Job& job = {});

/// Largest error of the light of a scene's surroundings by its low orders, relative to the
/// brightest; nullopt without such light.
std::optional<double> low_order_error(const Scene& scene);

/// Mean number of scatterings of light on its way from a lamp of the rig past the middle of the
/// scene's body to the camera. Pictures hold singly scattered light only, and are wrong unless this
/// is well below 1.
double scatterings_past_body(const Scene& scene, const LightRig& rig, const Vec3& eye);

} // namespace keiko
