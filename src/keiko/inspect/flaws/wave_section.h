#pragma once

#include "keiko/inspect/flaws/geodesic_trace.h"

#include <optional>
#include <vector>

namespace keiko {

/// Profile of a surface along a geodesic trace, laid out flat. Its height has the surface's
/// curvature as second derivative by the trace's length. A uniform curvature of the form is
/// therefore a parabola, however strong, and the angle of a seam does not count.
class RoughnessProfile {
public:
    /// Two and a half waves of `length` mm to either side of a place. It is shorter where material
    /// ends or the surface has turned by a right angle, as around a tube. nullopt where the surface
    /// has no normal.
    static std::optional<RoughnessProfile> through(const FaceAdjacency& faces, const SheetPoint& at,
                                                   const Vec3& along, double length);

    /// True if the profile reaches `s`: mm from the place, positive along the trace.
    bool holds(double s) const;
    /// True if material ends at both of its ends.
    bool is_between_borders() const { return between_borders_; }
    /// mm, outwards; up to a straight line that is fixed for the whole profile.
    double height(double s) const;
    /// Place of the surface.
    SheetPoint place(const FaceAdjacency& faces, double s) const;

private:
    std::vector<WalkPoint> points_; ///< uniformly spaced by `step_`
    std::vector<double> heights_;
    double begin_ = 0, step_ = 1;
    bool between_borders_ = false;
};

/// A wave on a straight trace over a surface.
struct WaveSection {
    double depth = 0;  ///< mm, from the form to a crest or a trough
    double length = 0; ///< mm, of the wave
    double bound = 0;  ///< mm: change of `depth` with a length that is 5 % shorter
    SheetPoint at;     ///< of the crest or trough
    Vec3 position{0};  ///< of `at`, world, mm
};

/// Measures the wave of about `length` mm whose crest (`crest`) or trough lies at about `at`, along
/// a straight trace in the direction `along`. It uses fourth differences over two waves around the
/// place or, where the surface ends, to one side (docs/theory/inspection.md). nullopt if there are
/// less than two waves.
std::optional<WaveSection> wave_section(const FaceAdjacency& faces, const SheetPoint& at,
                                        const Vec3& along, bool crest, double length);

/// Measures such a wave where the surface is too narrow for two of them, by the third difference
/// over one and a half. The bound includes what the form adds if its bend changes by as much as it
/// is. nullopt if two waves or less than one and a half are.
std::optional<WaveSection> narrow_wave_section(const FaceAdjacency& faces, const SheetPoint& at,
                                               const Vec3& along, bool crest, double length);

} // namespace keiko
