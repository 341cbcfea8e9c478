#pragma once

#include "keiko/light/areas/area_lights.h"
#include "keiko/light/penumbra/source_width.h"
#include "keiko/math/interval_set.h"
#include "keiko/math/vec.h"

#include <optional>
#include <vector>

namespace keiko {

/// A flat source, or a flat outline of one, viewed from a surface element, in parallel lines.
/// Places in its plane count in mm from the foot of the point: u along the lines, v across.
class AreaWidth : public SourceWidth {
public:
    Segment line_of(const SubAxis& axis) const override;
    double lit(const SubAxis& axis, double begin, double end) const override;
    /// Unit direction at an elevation, given by its half tangent, in the half-plane of a line.
    Vec3 direction(const SubAxis& axis, double half_tangent) const;
    /// Unit vector along the lines.
    const Vec3& along() const { return along_; }
    /// Elevations, by half tangents, of the parts of the source on a line above the horizon, and
    /// from t = `begin` to `end`, 0 to 1 along line_of().
    std::vector<ParameterInterval> elevations(const SubAxis& axis, double begin = 0,
                                              double end = 1) const;
    /// Projected solid angle, by the wedge angle and the half tangent of an elevation.
    double light_rate(const SubAxis& axis, double half_tangent) const;
    /// Place of the source at an elevation, given by its half tangent, in the half-plane of a line.
    virtual Vec3 place(const SubAxis& axis, double half_tangent) const {
        const double t = half_tangent;
        return point_ + direction(axis, t) * (axis.r * (1 + t * t) / (1 - t * t));
    }

protected:
    /// Frame of a plane: `through` lies in it, its unit normal points to the point, and `along` is
    /// a unit vector in it.
    AreaWidth(const Vec3& through, const Vec3& plane_normal, const Vec3& along, const Vec3& point,
              const Vec3& normal);

    /// Parts of the source on the line at v, rising.
    virtual std::vector<ParameterInterval> chords(double v) const = 0;
    /// Line at v; `weight`: change of the wedge angle by the place.
    SubAxis line_at(double v, double weight) const;
    /// Place in the plane.
    Vec2 place_of(const Vec3& at) const {
        return {along_.dot(at - foot_), across_.dot(at - foot_)};
    }
    /// Height of a place in the plane over the tangent plane of the surface element, mm.
    double elevation(const Vec2& at) const {
        return n_along_ * at.x + n_across_ * at.y + n_ahead_ * distance_;
    }
    /// Wedge angle of a direction from the point.
    double wedge_angle(const Vec3& way) const;
    const Vec3& point() const { return point_; }
    double distance() const { return distance_; }
    double n_across() const { return n_across_; }
    double n_ahead() const { return n_ahead_; }
    const ParameterInterval& extent() const { return extent_; }
    void set_extent(const ParameterInterval& u) { extent_ = u; }

private:
    double level(const SubAxis& axis) const;

    Vec3 point_, ahead_, along_, across_; ///< ahead: from the point to the plane
    double distance_;
    Vec3 foot_;
    double n_ahead_, n_along_, n_across_; ///< components of the surface normal
    ParameterInterval extent_;            ///< of all lines, by u
};

/// Lines of a panel above the horizon, parallel to its longest side and as long as the whole of it.
/// Their places are uniform in the wedge angle.
class PolygonWidth final : public AreaWidth {
public:
    /// nullopt if the panel sends no light to the surface element.
    static std::optional<PolygonWidth> of(const PolygonLight& light, const Vec3& point,
                                          const Vec3& normal);
    /// Lines in a `direction` of any length, not at right angles to the panel; nullopt as above.
    static std::optional<PolygonWidth> of(const PolygonLight& light, const Vec3& direction,
                                          const Vec3& point, const Vec3& normal);
    SubAxis sub_axis(double place) const override;
    std::vector<double> cuts() const override;
    double place_in(const Vec3& way) const override;

private:
    PolygonWidth(const PolygonLight& light, const Vec3& plane_normal, const Vec3& along,
                 const Vec3& point, const Vec3& normal);
    std::vector<ParameterInterval> chords(double v) const override;

    std::vector<Vec2> corners_;    ///< above the horizon
    double middle_ = 0, half_ = 0; ///< wedge angle of place 0, and from there to place 1
};

/// Lines of a light; nullopt if it sends none to the surface element.
inline std::optional<PolygonWidth> width_of(const PolygonLight& light, const Vec3& point,
                                            const Vec3& normal) {
    return PolygonWidth::of(light, point, normal);
}

} // namespace keiko
