#pragma once

#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/intersect/hit/refract_ray.h"
#include "keiko/light/rig/rig_areas.h"
#include "keiko/light/rig/rig_sky.h"
#include "keiko/render/caustics/caustics.h"
#include "keiko/render/reflection/lamp_reflections.h"
#include "keiko/render/reflection/reflected_grid.h"
#include "keiko/render/reflection/sample_batch.h"
#include "keiko/render/shading/direct_lighting.h"
#include "keiko/render/shading/glass_loss.h"
#include "keiko/render/shading/mapped_paint.h"
#include "keiko/render/shading/matter_loss.h"
#include "keiko/render/shading/occluded_visibility.h"
#include "keiko/render/shading/paint.h"
#include "keiko/render/shading/picture.h"
#include "keiko/texels/lit_texels.h"
#include "keiko/volumes/lit_volumes.h"

#include <optional>
#include <set>
#include <span>
#include <vector>

namespace keiko {

/// Integrator of camera rays over mirror reflections and glass. A smooth coat or metal reflects
/// lamps, the body itself and, behind both, the uniform light `ambient`. Glass splits a ray in two:
/// what it mirrors and what passes it. A ray that only panes were crossed by sees what the camera
/// sees: no rows of tubes, and the background. Rough interfaces and flakes spread
/// the light of lamps; the base is lit directly. It processes many rays at once, a reflection
/// deeper each pass.
class Integrator {
public:
    /// `eye`: the origin of the rays of a picture, for which light shafts are prepared. Throws
    /// Cancelled.
    Integrator(const PictureScene& scene, const PictureOptions& options,
               const std::optional<Vec3>& eye = {}, const Job& job = {});

    /// One sample a ray, in order, with all its light. Neighbouring rays should be adjacent.
    SampleBatch follow(std::span<const Ray> camera_rays) const;
    /// follow() for rays that see what mirrors see: rows of tubes too, and the surroundings.
    SampleBatch follow_mirrored(Rays rays) const;
    /// Samples of camera rays, one a ray, in order, without the light of the shading points.
    SampleBatch view(Rays camera_rays) const;
    /// Samples of the pixels of a grid, without the light of the shading points. Pixels with a ray
    /// reflect lamps by curved images of the pixel if neighbours determine its curvature; the
    /// others show the background. In a medium or below a sky all have rays. If nothing is refined
    /// and no AOVs are requested, the view has no hits, nor places that reflected rays meet.
    SampleBatch view(const TileRays& grid) const;
    /// Sample of a camera ray that misses the scene, without a medium or a sky.
    PixelSample unseen() const;
    /// Light of all lamps and other sources at a shading point.
    DirectLight direct_light(const ShadingPoint& point) const {
        return direct_light(point, lights());
    }
    /// Light of some of them together.
    DirectLight direct_light(const ShadingPoint& point, std::span<const LightId> lights) const;
    /// Their light past no body; glass and volumes dim it.
    DirectLight unoccluded_light(const ShadingPoint& point, std::span<const LightId> lights) const;
    /// All lights, in the order in which they are queried.
    const std::vector<LightId>& lights() const { return lights_.lights(); }
    /// Lights that are fitted over smooth surfaces. Those of an open sky are, whose shadows have
    /// wide edges, and all are where all are rows of tubes, nothing casts shadows, and there is no
    /// medium.
    const std::vector<LightId>& smooth_lights() const { return smooth_lights_; }
    /// The others, which are interpolated between pixels: numbers in lights(), rising.
    const std::vector<std::size_t>& interpolated_lights() const { return interpolated_lights_; }
    /// See keiko::is_open_sky().
    bool is_open_sky(const LightId& light) const {
        return keiko::is_open_sky(rig_.sources[light.source]);
    }
    /// True if the paint at a shading point has lobes, whose light depends on the eye as well.
    bool has_lobes(const ShadingPoint& point) const {
        const Paint& paint = paint_of(point);
        return paint.gloss() || paint.flakes();
    }
    /// Visibility of some of the lights from a shading point.
    std::vector<LightVisibility> light_visibility(const ShadingPoint& point,
                                                  std::span<const LightId> lights) const;
    /// See DirectLighting::may_occlude(); always true where something may dim light.
    bool may_occlude(std::span<const Vec3> places, const LightId& light,
                     const std::optional<Vec3>& facing) const {
        return dims_light() || lights_.may_occlude(places, light, facing, tubes_);
    }
    /// Light of each of some lights at a shading point, with the visibility `seen` of each.
    std::vector<DirectLight> direct_light(const ShadingPoint& point,
                                          std::span<const LightId> lights,
                                          std::vector<LightVisibility> seen) const;
    /// PictureOptions::white.
    const std::optional<double>& white() const { return options_.white; }
    /// cd/m2 that a shading point's base and lobes reflect of the lamps' light to the viewer.
    Rgb luminance(const ShadingPoint& point, const DirectLight& light) const;
    /// Number of a face's paint, for SurfacePlace::paint.
    std::uint32_t paint_number(std::size_t face) const { return paint_of_face_[face]; }
    /// cd/m2 of a shading point that is no hit of the scene: of a mesh, say. It is the light of
    /// base and lobes, and what the surface reflects of the ray `mirrored` from there. Glass passes
    /// nothing.
    Rgb luminance(const ShadingPoint& point, const Ray& mirrored) const;
    /// Adds the luminance by `light` and by the known light to the sample of a shading point.
    void add_light(const ShadingPoint& point, const DirectLight& light, PixelSample& sample) const;

private:
    /// lx on a shading point from surfaces, or else the rig's ambient light.
    Rgb ambient_illuminance(const ShadingPoint& point) const;
    /// cd/m2 that a shading point's base and lobes reflect of `ambient` lx from all sides and of
    /// the surroundings to the viewer.
    Rgb ambient_luminance(const ShadingPoint& point, const Rgb& ambient) const;

    /// Sample that the light of a ray goes to, its weight there, and the way of the ray.
    struct PathState {
        std::size_t sample = 0;
        Rgb weight{0};
        std::uint64_t branch = 0;       ///< ShadingPoint::branch of what it meets
        int mirrors = 0, crossings = 0; ///< before, by PictureOptions
        bool straight = true;           ///< neither mirrored nor bent
        const Paint* inside = nullptr;  ///< solid glass that the ray is in
    };

    /// Ways of light from a surface to a ray that met it: those that are followed.
    struct Onward {
        std::optional<PathState> mirrored, passed;
        double eta = 1; ///< of what passes: the index before the surface over that behind it
    };

    /// Rays to trace, of the same depth, each with its path.
    struct RayQueue {
        Rays rays;
        std::vector<PathState> paths;

        void reserve(std::size_t count) { rays.reserve(count), paths.reserve(count); }
        /// A blank ray of a path.
        Ray& add(const PathState& path) {
            paths.push_back(path);
            return rays.emplace_back();
        }
        /// Adds all of another queue.
        void append(const RayQueue& other) {
            rays.insert(rays.end(), other.rays.begin(), other.rays.end());
            paths.insert(paths.end(), other.paths.begin(), other.paths.end());
        }
        /// Adds a path's ray through the surface that `incoming` meets at `hit`; not where the
        /// reflection is total.
        void add_passed(const PathState& path, const Ray& incoming, const Hit& hit, double eta) {
            if (auto ray = refract_ray(incoming, hit, eta)) add(path) = *ray;
        }
    };

    /// Incidence of a ray on a surface.
    struct FresnelTerm {
        double cosine = 0; ///< of the angle to the normal
        Rgb mirrored;      ///< share of the light that is reflected
    };

    /// Surface that a ray hits, and lamps before it.
    struct PathVertex {
        const Ray& ray;
        const Hit* hit;
        const PixelMirror& mirror; ///< of lamps
        const FresnelTerm& incidence;
    };

    /// True if glass dims the light of lamps.
    bool glass_dims() const { return (scene_.occluders || scene_.caustics) && glass_.any(); }
    /// True if volumes or texels dim it.
    bool matter_dims() const { return scene_.occluders && matter_.any(); }
    /// True if anything dims it, beside occluders.
    bool dims_light() const { return glass_dims() || matter_dims(); }
    /// Share of each of some lights at a point that reaches it; empty if nothing dims them.
    std::vector<Rgb> left_on_the_way(const ShadingPoint& point,
                                     std::span<const LightId> lights) const;

    /// Paint of a shading point, with its maps.
    const Paint& paint_of(const ShadingPoint& point) const {
        return point.mapped ? point.mapped->paint : paints_[point.place.paint];
    }
    /// Turns the normals of hits on faces with maps. Returns those of all rays' hits before; none
    /// if the scene has no maps.
    std::vector<Vec3> bend(std::span<const Ray> rays, FirstHits& hits) const;

    FresnelTerm incidence(const Ray& ray, const Hit& hit, int depth) const;
    /// Fresnel terms of rays of one depth, computed consecutively, so that the latencies of roots
    /// and divisions overlap.
    std::vector<FresnelTerm> incidences(std::span<const Ray> rays, const FirstHits& hits,
                                        int depth) const;

    /// Segment of a ray up to its hit.
    static Segment leg_of(const Ray& ray, const Hit* hit);
    /// True if occluders between lights and a medium must be found.
    bool casts_shafts() const { return scene_.rig.medium && scene_.occluders; }
    /// Segments of rays up to their hits, if they cast shafts.
    std::vector<Segment> legs_of(std::span<const Ray> rays, const FirstHits& hits) const;
    std::vector<Segment> legs_of(const ReflectionBuffer& mirrors) const;
    /// Shadows of the lights along `legs` after `depth` reflections.
    VolumetricShadows volumetric_shadows(std::span<const Segment> legs, int depth) const;

    /// Traces camera rays through some places of a grid to their first hits, and the reflected rays
    /// from there. Those that pass the first surfaces are added to `passed`.
    void trace_primary(const TileRays& grid, std::span<const GridPlace> places, SampleBatch& view,
                       ReflectionBuffer& mirrors, RayQueue& passed) const;
    /// Detail required of the hits of rays mirrored once: no surface if no light on it is visible
    /// and no ray continues from there.
    HitDetail mirrored_detail() const;
    void trace_reflections(const RayQueue& mirrored, ReflectionBuffer& mirrors) const;
    /// Adds the hits of the first reflected rays of a grid, row by row, as neighbours reflect lamps
    /// side by side. Returns the remaining rays.
    RayQueue shade_hits(const ReflectionBuffer& mirrors, SampleBatch& view) const;
    RayQueue mirrored_again(std::span<const PathState> paths,
                            const ReflectionBuffer& mirrors) const;
    /// The path of a ray of `mirrors`.
    static PathState path_of(std::size_t place, const Rgb& weight);
    /// Follows rays of samples of a view after `depth` reflections.
    void follow(RayQueue wave, int depth, SampleBatch& view) const;
    RayQueue shade_hits(const RayQueue& wave, const FirstHits& hits, int depth,
                        SampleBatch& view) const;
    /// Adds the light of a ray's hit to the view.
    Onward shade(PathState path, const PathVertex& met, const VisibleFrom& shafts,
                 SampleBatch& view) const;
    /// Solid glasses whose interfaces a ray crosses an odd number of times.
    std::set<const Paint*> glass_left_by(const Ray& ray) const;
    /// Solid glass around a place, of one paint; null in the air, and in a body that is open to a
    /// side. In glass within glass it is the first paint of both.
    const Paint* glass_around(const Vec3& place) const;
    /// Solid glass around the origin of each ray.
    std::vector<const Paint*> glass_around(std::span<const Ray> rays) const;
    /// The ways on from a hit.
    /// `mapped`: its paint if the face has maps, else null.
    Onward onward(const PathState& path, const PathVertex& met, const MappedPaint* mapped) const;
    Onward through_pane(const PathState& path, const Paint& paint, double cosine) const;
    Onward through_solid(const PathState& path, const Paint& paint, double cosine) const;
    /// The path by mirror reflection of a share of the light, unless it is followed no further.
    std::optional<PathState> mirrored(PathState path, const Rgb& share) const;
    /// The path by total reflection inside glass.
    std::optional<PathState> totally_mirrored(PathState path) const;
    /// The path of a share of the light through an interface of glass.
    std::optional<PathState> passed(PathState path, const Rgb& share) const;
    /// The path with a share of its weight on a child of its branch, if the share counts.
    std::optional<PathState> onto(PathState path, const Rgb& share, std::uint64_t child) const;
    /// The path with a share of its weight, if that counts.
    std::optional<PathState> kept(PathState path, const Rgb& share) const;
    void record_aovs(const PathState& path, const PathVertex& met, PixelSample& sample) const;
    bool takes_light(std::uint32_t paint, std::uint64_t branch) const;
    ShadingPoint shading_point_at(const PathState& path, const PathVertex& met) const;
    /// Light of caustics on the footprint of a ray.
    DirectLight caustic_light(const ShadingPoint& point, const PathVertex& met) const;
    /// Adds the light of all shading points of a view to their samples.
    SampleBatch lit(SampleBatch view) const;
    /// The surroundings; null without any.
    const Environment* environment() const {
        return scene_.maps ? scene_.maps->environment() : nullptr;
    }
    /// True if rays that miss the scene show what depends on their direction.
    bool sees_beyond() const { return !sky_.empty() || environment(); }
    /// cd/m2 of what a ray meets that misses the scene: the sky, and where it has none the
    /// surroundings or else the background or, of a ray that was mirrored or bent, the ambient
    /// light.
    Rgb beyond(const PathState& path, const Ray& ray) const;
    Rgb behind_sky(const PathState& path, const Ray& ray) const;
    static void note_mirrored(const PathVertex& met, PixelSample& sample);
    void note_behind(const PathVertex& met, PixelSample& sample) const;
    void add_lights(PathState& path, const PathVertex& met, const VisibleFrom& shafts,
                    PixelSample& sample) const;
    void add_light_at(double t, const MirroredLight& light, PathState& path, const Ray& ray,
                      const VisibleFrom& shafts, PixelSample& sample) const;
    /// True if there are volumes or texels.
    bool has_matter() const { return volumes_ || texels_; }
    /// Distances at which surfaces stop light; empty if they cast no shadows.
    StopOfLight stops_of_light() const;
    /// Lights that arrive at texels; refers to this.
    LightsAt light_on_texels() const;
    /// Light of volumes and texels along a ray up to a place on it, and their opacity. Within a
    /// layer of texels they count as before any volume.
    FrontToBack matter_before(const Ray& ray, const Vec3& end) const;
    /// Adds the light of volumes and texels before a hit, and dims what is behind.
    void pass_matter(PathState& path, const PathVertex& met, PixelSample& sample) const;
    void pass_medium(PathState& path, const PathVertex& met, const VisibleFrom& shafts,
                     PixelSample& sample) const;

    const PictureScene& scene_;
    const PictureOptions& options_;
    MappedHits maps_;
    RigPlanes planes_;
    RigAreas areas_;
    RigSky sky_;
    LampKernels stripe_kernels_ = lamp_kernels();
    ReflectionKernel mirror_kernel_ = reflection_kernel();
    PreparedRig rig_;
    DirectLighting lights_; ///< refers to rig_
    GlassLoss glass_;
    MatterLoss matter_;
    std::optional<Caustics> caustics_;
    std::optional<LitVolumes> volumes_;
    std::optional<LitTexels> texels_;
    TubeModel tubes_;
    bool tells_illuminance_, refines_, keeps_hits_;
    bool mirrors_alone_ = true; ///< no paint takes light, and there is no glass
    std::vector<Paint> paints_;
    std::vector<std::uint32_t> paint_of_face_;
    std::vector<LightId> smooth_lights_;
    std::vector<std::size_t> interpolated_lights_;
    std::vector<std::optional<EpipolarShadows>> pencils_; ///< of camera rays
};

} // namespace keiko
