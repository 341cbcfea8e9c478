#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/axes.h"
#include "keiko/math/bounds.h"
#include "keiko/math/polygon.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Share of a polygon's size by which its corners may miss a plane, and within which parts of its
/// outline touch each other.
constexpr double flat_enough = 1e-6;

double size_of(const std::vector<Vec3>& corners) {
    Box3 box;
    for (const Vec3& corner : corners) box.extend(corner);
    return box.size();
}

double distance_to(const Segment& line, const Vec3& point) {
    const Vec3 way = line.b - line.a;
    const double t = std::clamp((point - line.a).dot(way) / way.length2(), 0.0, 1.0);
    return (line.at(t) - point).length();
}

/// A closed outline of corners, which it keeps a reference to; messages count corners and sides
/// from 1.
class Ring {
public:
    explicit Ring(const std::vector<Vec3>& corners)
        : corners_(corners), touching_(flat_enough * size_of(corners)) {}

    /// True if all of another ring in the plane lies inside, without touching.
    bool holds_all_of(const Ring& other) const {
        return apart_from(other) && contains(other.corners_.front());
    }
    /// True if no side of another ring in the plane comes to one of this ring.
    bool apart_from(const Ring& other) const {
        const Vec3 normal = polygon_normal(corners_);
        for (std::size_t i = 0; i < count(); ++i)
            for (std::size_t k = 0; k < other.count(); ++k) {
                const Segment a = side(i), b = other.side(k);
                if (segments_cross(a.a, a.b, b.a, b.b, normal) ||
                    !(distance_to(b, a.a) > touching_) || !(distance_to(a, b.a) > touching_))
                    return false;
            }
        return true;
    }
    /// True for a point of the plane inside, by the even-odd rule.
    bool contains(const Vec3& point) const {
        const Vec3 normal = polygon_normal(corners_).normalized();
        const Vec3 u = any_perpendicular(normal), v = normal.cross(u);
        std::vector<Vec2> flat;
        for (const Vec3& corner : corners_) flat.emplace_back(u.dot(corner), v.dot(corner));
        return holds(flat, {u.dot(point), v.dot(point)});
    }
    /// True for a point of the ring's plane.
    bool lies_in_plane(const Vec3& point) const {
        const Vec3 normal = polygon_normal(corners_).normalized();
        return std::abs(normal.dot(point - corners_.front())) <= touching_;
    }

    /// Description of a place where the outline meets itself; empty if it does not.
    std::string fault() const {
        for (const auto& find : {&Ring::coinciding, &Ring::touching, &Ring::crossing})
            if (std::string words = (this->*find)(); !words.empty()) return words;
        return {};
    }

private:
    std::size_t count() const { return corners_.size(); }
    Segment side(std::size_t i) const { return {corners_[i], corners_[(i + 1) % count()]}; }
    static std::string number(std::size_t i) { return std::to_string(i + 1); }

    std::string coinciding() const {
        for (std::size_t i = 0; i < count(); ++i)
            for (std::size_t k = i + 1; k < count(); ++k)
                if (!((corners_[k] - corners_[i]).length() > touching_))
                    return "corners " + number(i) + " and " + number(k) + " coincide";
        return {};
    }
    std::string touching() const {
        for (std::size_t i = 0; i < count(); ++i)
            for (std::size_t k = 0; k < count(); ++k)
                if (k != i && (k + 1) % count() != i &&
                    !(distance_to(side(k), corners_[i]) > touching_))
                    return "corner " + number(i) + " lies on side " + number(k);
        return {};
    }
    std::string crossing() const {
        const Vec3 normal = polygon_normal(corners_);
        for (std::size_t i = 0; i < count(); ++i)
            for (std::size_t k = i + 2; k < count(); ++k)
                if (segments_cross(side(i).a, side(i).b, side(k).a, side(k).b, normal))
                    return "sides " + number(i) + " and " + number(k) + " cross each other";
        return {};
    }

    const std::vector<Vec3>& corners_;
    double touching_; ///< mm
};

} // namespace

std::vector<Vec3> corners_from(const TomlTable& table) {
    std::vector<Vec3> corners;
    for (const auto& corner :
         table.required("corners", table.lists("corners", TomlLimits::place()))) {
        if (corner.size() != 3)
            throw table.error("corners", "must be arrays of 3 numbers, corner " +
                                             std::to_string(corners.size() + 1) + " is not");
        corners.emplace_back(corner[0], corner[1], corner[2]);
    }
    return corners;
}

void require_polygon(const TomlTable& table, const std::vector<Vec3>& corners) {
    if (corners.size() < 3) throw table.error("corners", "must be at least 3 corners");
    const double size = size_of(corners);
    const Vec3 normal = polygon_normal(corners);
    if (!(normal.length() > flat_enough * size * size))
        throw table.error("corners", "enclose no area: they lie on a line, or sides cross");
    for (const Vec3& corner : corners)
        if (std::abs(normal.dot(corner - corners.front())) > flat_enough * size * normal.length())
            throw table.error("corners", "must lie in a plane");
}

void require_ring(const TomlTable& table, const std::vector<Vec3>& corners) {
    // A limit that keeps the comparison of all parts with each other short.
    constexpr std::size_t most_corners = 1000;
    if (corners.size() > most_corners)
        throw table.error("corners",
                          "must be at most " + std::to_string(most_corners) + " corners");
    require_polygon(table, corners);
    if (const std::string fault = Ring(corners).fault(); !fault.empty())
        throw table.error("corners", fault);
}

void require_legend(const TomlTable& table, const PolygonLight& part, const LuminousSign& sign) {
    const Ring ring(part.corners), panel(sign.panel.corners);
    for (const Vec3& corner : part.corners)
        if (!panel.lies_in_plane(corner))
            throw table.error("corners", "must lie in the plane of the sign");
    if (!panel.holds_all_of(ring))
        throw table.error("corners", "must lie inside of the sign, apart from its outline");
    for (std::size_t i = 0; i < sign.legend.size(); ++i) {
        const Ring other(sign.legend[i].corners);
        if (!other.apart_from(ring) || other.contains(part.corners.front()) ||
            ring.contains(sign.legend[i].corners.front()))
            throw table.error("corners", "must lie apart from legend " + std::to_string(i + 1));
    }
}

std::string corners_line(const std::vector<Vec3>& corners) {
    std::string list;
    for (const Vec3& corner : corners) list += (list.empty() ? "" : ", ") + toml_value(corner);
    return toml_line("corners", "[" + list + "]", "mm");
}

} // namespace keiko
