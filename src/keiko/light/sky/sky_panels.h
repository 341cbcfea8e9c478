#pragma once

#include "keiko/light/areas/area_width.h"
#include "keiko/light/penumbra/source_width.h"
#include "keiko/light/sky/sky_light.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Length, mm, of the medium before a sky that no window shows: light from beyond passes 1 km of
/// it.
constexpr double sky_distance = 1e6;

/// A part of the sky or of the ground below it, as a plane panel viewed from a point: a quarter of
/// the hemisphere, or what a window shows.
struct SkyPanel {
    PolygonLight
        outline;         ///< far away, in the same directions from the point; two-sided, of 1 cd/m2
    bool ground = false; ///< a part of the ground, not of the sky
    /// Direction of the lines across it, of any length: up or down a quarter, since what stands on
    /// the ground has outlines along the horizon.
    Vec3 along{0};
    /// Distance of the window, as a share of that of `outline`; nullopt without a window.
    std::optional<double> window{};
    /// Windows before its own, in the sky: what they show is theirs.
    std::span<const Window> others{};
};

/// Number of panels of a sky, counted from 0: those of the sky, then those of a ground that shines.
int panel_count(const SkyLight& sky);

/// A panel as viewed from a point, mm; nullopt if its window shows none of it there. The sky must
/// outlive it.
std::optional<SkyPanel> sky_panel(const SkyLight& sky, int number, const Vec3& point);

/// Lines across a panel of the sky, of the luminance of the sky along them.
class SkyWidth final : public SourceWidth {
public:
    /// nullopt if the panel sends no light to the surface element.
    static std::optional<SkyWidth> of(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                                      const Vec3& normal);

    SubAxis sub_axis(double place) const override { return lines_.sub_axis(place); }
    Segment line_of(const SubAxis& axis) const override { return lines_.line_of(axis); }
    double place_in(const Vec3& way) const override { return lines_.place_in(way); }
    /// Weighted by the luminance, as a share of that at the zenith, or of the ground's.
    double lit(const SubAxis& axis, double begin, double end) const override;
    std::vector<double> cuts() const override;

    /// See AreaWidth.
    Vec3 direction(const SubAxis& axis, double half_tangent) const {
        return lines_.direction(axis, half_tangent);
    }
    /// See AreaWidth.
    const Vec3& along() const { return lines_.along(); }
    /// See AreaWidth.
    std::vector<ParameterInterval> elevations(const SubAxis& axis, double begin = 0,
                                              double end = 1) const {
        return lines_.elevations(axis, begin, end);
    }
    /// See AreaWidth; weighted by the luminance.
    double light_rate(const SubAxis& axis, double half_tangent) const {
        return lines_.light_rate(axis, half_tangent) * luminance(direction(axis, half_tangent));
    }
    /// Place where light from an elevation enters the medium: in the window, or, without one,
    /// sky_distance away.
    Vec3 place(const SubAxis& axis, double half_tangent) const {
        if (!window_) return point_ + direction(axis, half_tangent) * sky_distance;
        return point_ + (lines_.place(axis, half_tangent) - point_) * *window_;
    }
    /// Luminance in a unit direction, as a share of that at the zenith, or of the ground's.
    double luminance(const Vec3& towards) const { return ground_ ? 1 : shares_(towards); }
    /// The largest luminance in any direction, or more, as such a share.
    double brightest() const;

private:
    SkyWidth(const SkyLight& sky, const SkyPanel& panel, const PolygonWidth& lines,
             const Vec3& point, const Vec3& normal)
        : shares_(sky),
          lines_(lines),
          point_(point),
          normal_(normal),
          ground_(panel.ground),
          window_(panel.window) {}

    bool around_sun() const { return !ground_ && !shares_.is_linear(); }
    double lit_linearly(const SubAxis& axis, const ParameterInterval& elevations) const;
    double lit_by_rule(const SubAxis& axis, const ParameterInterval& elevations) const;

    SkyDistribution shares_;
    PolygonWidth lines_;
    Vec3 point_, normal_;
    bool ground_;
    std::optional<double> window_;
};

} // namespace keiko
