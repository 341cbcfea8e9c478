#pragma once

#include "keiko/render/eye_view.h"
#include "keiko/render/mirrored_pixel.h"
#include "keiko/render/paint.h"
#include "keiko/render/picture.h"
#include "keiko/render/shadows.h"
#include "keiko/render/shaft_shadows.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Follows eye rays over mirror reflections: a smooth coat or metal mirrors lamps, the body itself
/// and, past both, the even light that `ambient` stands for; rough borders and flakes spread the
/// light of lamps, the base is lit directly. Works on many rays at once, a reflection deeper each
/// pass.
class Integrator {
public:
    /// `eye`: where the rays of a picture begin, whose light shafts are made ready for it. Throws
    /// Cancelled.
    Integrator(const PictureScene& scene, const PictureOptions& options,
               const std::optional<Vec3>& eye = {}, const Job& job = {});

    /// One sample a ray, in order, with all its light. Neighbouring rays should stand together.
    std::vector<EyeSample> follow(std::span<const Ray> eye_rays) const;
    /// The same, but for the light of the spots. Rays that are the pixels of a grid, row by row,
    /// `grid_width` in each, see lamps by bent images of their pixels where neighbours tell how
    /// they are bent.
    EyeView view(std::span<const Ray> eye_rays, int grid_width = 0) const;
    /// What all lamps and other lights bring to a spot.
    SpotLight light_on(const LitSpot& spot) const;
    /// All lights, in the order in which they are asked for.
    const std::vector<RigLight>& lights() const { return lights_.lights(); }
    /// What a spot sees of some of the lights.
    std::vector<SeenLight> seen_from(const LitSpot& spot, std::span<const RigLight> lights) const;
    /// What each of them brings if that is `seen`.
    std::vector<SpotLight> light_on(const LitSpot& spot, std::span<const RigLight> lights,
                                    std::vector<SeenLight> seen) const;
    /// cd/m2 that the lamps' light makes a spot's base and lobes send to the eye.
    Rgb luminance(const LitSpot& spot, const SpotLight& light) const;
    /// The same of even light from all sides.
    Rgb ambient_luminance(const LitSpot& spot) const;
    /// Adds what `light` brings to the sample of a spot.
    void add_light(const LitSpot& spot, const SpotLight& light, EyeSample& sample) const;

private:
    /// A ray under way and what its light counts in its sample.
    struct Path {
        Ray ray;
        std::size_t sample;
        Rgb weight;
    };

    /// What a path comes to: a surface, and lamps on the way to it.
    struct Met {
        const std::optional<Hit>& hit;
        const PixelMirror& mirror; ///< of lamps
    };

    /// What the lights see of the ways of the paths to what they meet; `depth`: reflections yet.
    ShaftShadows shaft_shadows(std::span<const Path> paths,
                               std::span<const std::optional<Hit>> hits, int depth) const;
    /// The lamps that mirrored paths see. With a `grid_width` they are the pixels of a grid, whose
    /// eye rays met `spots`.
    std::vector<PixelMirror> mirrors_of(std::span<const Path> paths,
                                        std::span<const std::optional<Hit>> hits, int grid_width,
                                        std::span<const LitSpot> spots) const;
    /// Adds what `path` meets to the view; returns its mirror reflection while that counts.
    std::optional<Path> advance(Path path, const Met& met, int depth, const VisibleFrom& shafts,
                                EyeView& view) const;
    void note(Path& path, const Met& met, int depth, const VisibleFrom& shafts,
              EyeSample& sample) const;
    LitSpot spot_at(const Path& path, const Hit& hit, int depth) const;
    void note_mirrored(const Ray& ray, const std::optional<Hit>& hit, EyeSample& sample) const;
    void add_lamps(Path& path, const MirroredLight& lamps, const VisibleFrom& shafts,
                   EyeSample& sample) const;
    void pass_medium(Path& path, const Vec3& end, const VisibleFrom& shafts,
                     EyeSample& sample) const;

    const PictureScene& scene_;
    const PictureOptions& options_;
    RigPlanes planes_;
    ShadowedRig lights_;
    TubeModel tubes_;
    bool tells_illuminance_;
    std::vector<Paint> paints_;
    std::vector<std::uint32_t> paint_of_face_;
    std::vector<std::optional<ShadowPencil>> pencils_; ///< of rays from the eye
};

} // namespace keiko
