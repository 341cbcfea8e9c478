#pragma once

#include "keiko/intersect/hit/mirror_kernel.h"
#include "keiko/render/reflection/mirrored_stripes.h"
#include "keiko/render/shading/eye_band.h"
#include "keiko/render/shading/paint.h"
#include "keiko/render/shading/picture.h"
#include "keiko/render/shading/shadowed_rig.h"
#include "keiko/render/shading/shaft_shadows.h"

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
    EyeView follow(std::span<const Ray> eye_rays) const;
    /// The same, but for the light of the spots.
    EyeView view(Rays eye_rays) const;
    /// The same of the pixels of a grid: those with a ray see lamps by bent images of the pixel
    /// where neighbours tell how it is bent, the others see the background. In a medium all have
    /// rays. Where nothing is refined, pixels at the grid's border show no reflections; where no
    /// AOVs are asked for either, the view has no hits, nor places that mirrored rays meet.
    EyeView view(const EyeGrid& grid) const;
    /// The same of grids one below the other, where only_mirrors(): `band.view` is that of this
    /// one, of which rows at its border or shared with others show nothing that can be relied on,
    /// but for the second and the last but one.
    void look_down(const EyeGrid& grid, EyeBand& band) const;
    /// Whether each pixel of a picture shows lamps in sharp mirrors and nothing else that takes
    /// long to find, and no pixel is refined.
    bool only_mirrors() const;
    /// What an eye ray brings back that meets nothing where there is no medium.
    EyeSample unseen() const;
    /// What all lamps and other lights bring to a spot.
    SpotLight light_on(const LitSpot& spot) const;
    /// All lights, in the order in which they are asked for.
    const std::vector<RigLight>& lights() const { return lights_.lights(); }
    /// What a spot sees of some of the lights.
    std::vector<SeenLight> seen_from(const LitSpot& spot, std::span<const RigLight> lights) const;
    /// See ShadowedRig::may_come_between().
    bool may_come_between(std::span<const Vec3> places, const RigLight& light,
                          const std::optional<Vec3>& facing) const {
        return lights_.may_come_between(places, light, facing, tubes_);
    }
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
    /// Where the light of a ray goes, and what it counts there.
    struct Path {
        std::size_t sample;
        Rgb weight;
    };

    /// Rays under way, of the same depth, each with its path.
    struct Wave {
        Rays rays;
        std::vector<Path> paths;

        void reserve(std::size_t count) { rays.reserve(count), paths.reserve(count); }
        /// A blank ray of a path.
        Ray& add(const Path& path) {
            paths.push_back(path);
            return rays.emplace_back();
        }
    };

    /// How a ray comes to a surface.
    struct Incidence {
        double cosine = 0; ///< of the angle to the normal
        Rgb mirrored;      ///< share of the light that goes on
    };

    /// What a ray comes to: a surface, and lamps on the way to it.
    struct Met {
        const Ray& ray;
        const Hit* hit;
        const PixelMirror& mirror; ///< of lamps
        const Incidence& incidence;
    };

    Incidence incidence(const Ray& ray, const Hit& hit, int depth) const;
    /// Of rays of one depth, one after the other with nothing in between: each waits for roots and
    /// divisions, which overlap so.
    std::vector<Incidence> incidences(std::span<const Ray> rays, const FirstHits& hits,
                                      int depth) const;

    /// A ray's way to what it meets.
    static Segment leg_of(const Ray& ray, const Hit* hit);
    /// Whether what stands between lights and a medium is to be found.
    bool casts_shafts() const { return scene_.rig.medium && scene_.occluders; }
    /// The ways of rays to what they meet, where they cast shafts.
    std::vector<Segment> legs_of(std::span<const Ray> rays, const FirstHits& hits) const;
    std::vector<Segment> legs_of(const FirstMirrors& mirrors) const;
    /// What the lights see of ways; `depth`: reflections yet.
    ShaftShadows shaft_shadows(std::span<const Segment> legs, int depth) const;

    /// What eye rays meet first through some places of a grid, and their mirrored ones.
    void look(const EyeGrid& grid, std::span<const GridPlace> places, EyeBand& band) const;
    static void set_rays(const Wave& wave, MirroredGrid& grid);
    /// What is asked of the hits of rays mirrored once: no surface where no light on it is seen and
    /// no ray goes on from there.
    HitDetail mirrored_detail() const;
    void find_ways(const Wave& mirrored, FirstMirrors& mirrors) const;
    /// Adds what the first mirrored rays of a grid meet, row by row, as neighbours see lamps side
    /// by side, but for rows whose neighbours are in another grid; what is left to follow.
    Wave meet(const EyeGrid& grid, const FirstMirrors& mirrors, EyeView& view) const;
    Wave mirrored_again(std::span<const Path> paths, const FirstMirrors& mirrors) const;
    /// Follows rays of samples of a view that were mirrored so often.
    void follow(Wave wave, int depth, EyeView& view) const;
    Wave meet(const Wave& wave, const FirstHits& hits, int depth, EyeView& view) const;
    /// Adds what a ray meets to the view; false where its mirror reflection does not count, else
    /// the path is that one's.
    bool advance(Path& path, const Met& met, int depth, const VisibleFrom& shafts,
                 EyeView& view) const;
    void note(Path& path, const Met& met, int depth, const VisibleFrom& shafts,
              EyeSample& sample) const;
    bool takes_light(std::uint32_t paint, int depth) const;
    LitSpot spot_at(const Path& path, const Met& met, int depth) const;
    static void note_mirrored(const Met& met, EyeSample& sample);
    void add_lamps(Path& path, const Met& met, const VisibleFrom& shafts, EyeSample& sample) const;
    void pass_medium(Path& path, const Met& met, const VisibleFrom& shafts,
                     EyeSample& sample) const;

    const PictureScene& scene_;
    const PictureOptions& options_;
    RigPlanes planes_;
    StripeKernels stripe_kernels_ = stripe_kernels();
    MirrorKernel mirror_kernel_ = mirror_kernel();
    ShadowedRig lights_;
    TubeModel tubes_;
    bool tells_illuminance_, refines_, keeps_hits_;
    bool mirrors_alone_ = true; ///< no paint takes light
    std::vector<Paint> paints_;
    std::vector<std::uint32_t> paint_of_face_;
    std::vector<std::optional<ShadowPencil>> pencils_; ///< of rays from the eye
};

} // namespace keiko
