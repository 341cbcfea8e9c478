#pragma once

#include "keiko/render/paint.h"
#include "keiko/render/picture.h"
#include "keiko/render/shadows.h"
#include "keiko/render/shaft_shadows.h"
#include "keiko/trace/path_counts.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// What one eye ray brings back.
struct EyeSample {
    Rgb luminance;          ///< cd/m2
    std::optional<Hit> hit; ///< the first surface
    /// Where the first mirrored ray meets the nearest C-plane, mm; nothing where the body is in the
    /// way.
    std::optional<Vec2> c_plane;
    /// The face that the first mirrored ray meets, or nothing where it leaves the body.
    std::optional<std::uint32_t> mirrored_face;
    std::uint32_t paint = 0; ///< faces of one paint share this number
    PathCounts paths;        ///< of its hits, the mirrored rays' too
};

/// Follows eye rays over mirror reflections: a smooth coat or metal mirrors lamps, the body itself
/// and, past both, the even light that `ambient` stands for; rough borders and flakes spread the
/// light of lamps, the base is lit directly. Works on many rays at once, a reflection deeper each
/// pass.
class Integrator {
public:
    Integrator(const PictureScene& scene, const PictureOptions& options);

    /// One sample a ray, in order. Neighbouring rays should stand together.
    std::vector<EyeSample> follow(std::span<const Ray> eye_rays) const;

private:
    /// A ray under way and what its light counts in its sample.
    struct Path {
        Ray ray;
        std::size_t sample;
        Rgb weight;
    };

    /// What the lights see of the ways of the paths to what they meet.
    ShaftShadows shaft_shadows(std::span<const Path> paths,
                               std::span<const std::optional<Hit>> hits) const;
    /// Adds what `path` meets to its sample; returns its mirror reflection while that counts.
    std::optional<Path> advance(Path path, const std::optional<Hit>& hit, int depth,
                                const VisibleFrom& shafts, EyeSample& sample) const;
    void note_mirrored(const Ray& ray, const std::optional<Hit>& hit, EyeSample& sample) const;
    void see_lamps(Path& path, double t_max, const VisibleFrom& shafts, EyeSample& sample) const;
    void pass_medium(Path& path, const Vec3& end, const VisibleFrom& shafts,
                     EyeSample& sample) const;
    Rgb base_luminance(const Hit& hit, const Vec3& normal, const Vec3& eye) const;
    const Paint& paint(const Hit& hit) const { return paints_[paint_of_face_[hit.face]]; }

    const PictureScene& scene_;
    const PictureOptions& options_;
    ShadowedRig lights_;
    std::vector<Paint> paints_;
    std::vector<std::uint32_t> paint_of_face_;
};

} // namespace keiko
