#pragma once

#include "keiko/light/areas/area_width.h"
#include "keiko/light/areas/contour_light.h"
#include "keiko/light/areas/contour_view.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace keiko {

/// Lines across the outline of a luminous body, on a plane behind it. Those that the body hides are
/// lit by it, whatever part of it is in front: its contour alone counts
/// (docs/theory/areas.md#bodies-by-their-contour). Places are uniform in an angle between two
/// places where the contour turns, where lines end like roots. For one thread; refers to the body.
class ContourWidth final : public AreaWidth {
public:
    /// Widths that together are all of the light; none if the body sends none to the element. They
    /// are cut where the contour turns, as far as that matters by more than the relative `error`,
    /// and everywhere if the body fills less than a tenth of the view.
    static std::vector<ContourWidth> all(const ContourLight& light, const Vec3& point,
                                         const Vec3& normal, double error);
    /// One width of the light, of a near body without a thousandth of the half-space next to the
    /// horizon; nullopt if it sends none.
    static std::optional<ContourWidth> of(const ContourLight& light, const Vec3& point,
                                          const Vec3& normal);
    SubAxis sub_axis(double place) const override;
    std::vector<double> cuts() const override;
    double place_in(const Vec3& way) const override;
    /// Place of the body's front.
    Vec3 place(const SubAxis& axis, double half_tangent) const override;
    /// A box around the body.
    Prism around() const override;

    /// Parts of a line of line_of() where nothing that `others` knows of is before the body.
    /// Chords of its front are queried; beside the body everything counts as visible.
    IntervalSet visible_on(const Segment& line, const Visibility& others) const;

private:
    ContourWidth(const LuminousBody& body, const ContourView& view, const Vec3& normal,
                 double error);
    std::vector<ParameterInterval> chords(double v) const override;
    std::vector<ParameterInterval> chords_at(double wedge_angle) const {
        return chords(distance() * std::tan(wedge_angle));
    }
    void find_turns(double error);
    /// Wedge angles between the limits of the view where the contour turns, with these, rising.
    /// `missed`: as in TurnRule.
    std::vector<double> turning_angles(double missed) const;
    /// The rising wedge angles of these that have light between them; none, or two at least.
    std::vector<double> lit_angles(std::vector<double> angles) const;
    /// True if a part of the body begins or ends at a wedge angle between others.
    bool parts_change(double before, double at, double after) const;
    /// True if none of a few lines between two wedge angles meets the body.
    bool is_dark(double begin, double end) const;
    /// Share of the view that the body fills, estimated from a few lines.
    double share_of_view() const;
    /// Unit direction to a place on the plane.
    Vec3 way_to(double u, double v) const;
    /// Place of the body's front in a direction.
    Vec3 front(const Vec3& way) const;
    /// Place along the lines of the direction to a place.
    double u_of(const Vec3& at) const;
    /// Ends of straight pieces before the body from one place of its front to another.
    void add_pieces(const Vec3& from, const Vec3& to, double v, int depth,
                    std::vector<Segment>& pieces) const;

    const LuminousBody* body_;
    ContourView view_;
    std::unique_ptr<Visibility> outline_;
    std::vector<double> turns_; ///< wedge angles, rising; none without light
    mutable std::vector<std::pair<double, std::vector<ParameterInterval>>>
        known_;                      ///< last chords by v
    mutable std::size_t oldest_ = 0; ///< of these, modulo their number, to be replaced next
};

/// Projected solid angle in sr of the lines of a width above the horizon, to the relative `error`.
double projected_solid_angle(const ContourWidth& width, double error);

/// Visibility of the front of a luminous body past other bodies, on the lines of its width. Keeps
/// references to both.
class VisibleFront final : public Visibility {
public:
    VisibleFront(const ContourWidth& width, const Visibility& others)
        : width_(width), others_(others) {}

    using Visibility::intervals;
    IntervalSet intervals(const Segment& line) const override {
        return width_.visible_on(line, others_);
    }
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const override {
        return others_.classify_prisms(prisms);
    }
    std::vector<CriticalSlice> turns(const Prism& prism, const TurnRule& rule) const override {
        return others_.turns(prism, rule);
    }

private:
    const ContourWidth& width_;
    const Visibility& others_;
};

/// Lines of a light; nullopt if it sends none to the surface element.
inline std::optional<ContourWidth> width_of(const ContourLight& light, const Vec3& point,
                                            const Vec3& normal) {
    return ContourWidth::of(light, point, normal);
}

} // namespace keiko
