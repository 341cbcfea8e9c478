#include "keiko/inspect/flaws/face_ripples.h"

#include "keiko/base/job.h"
#include "keiko/inspect/flaws/face_surface.h"
#include "keiko/inspect/flaws/geodesic_trace.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace keiko {
namespace {

/// Number of equal parts of a span, each at most `spacing` long.
double part_count(double length, double spacing) {
    return std::max(std::ceil(length / spacing), 1.0);
}

/// Places in the middles of equal parts of each span, at most `spacing` apart.
std::vector<double> spread(const std::vector<double>& lengths, double spacing) {
    std::vector<double> places;
    for (std::size_t span = 0; span < lengths.size(); ++span) {
        const auto parts = static_cast<std::size_t>(part_count(lengths[span], spacing));
        for (std::size_t k = 0; k < parts; ++k)
            places.push_back(static_cast<double>(span) +
                             (static_cast<double>(k) + 0.5) / static_cast<double>(parts));
    }
    return places;
}

/// Distance between samples as a share of the window's width.
constexpr double sample_share = 1.0 / 20;
/// Share of the limit down to which ripples are searched: planted dents are up to 5.3 times as deep
/// as their ripples may be.
constexpr double ripple_share = 1.0 / 6;
/// Distance to which lines are followed beyond a face: half the widest wave along the line and what
/// it takes to detect that the curvature comes back, as a share of the window's width.
constexpr double follow_share = 1.5;

/// A line over a face and its continuation at either end.
class RippleLine {
public:
    RippleLine(const FaceAdjacency& faces, std::size_t face, bool along_u, double window)
        : faces_(faces), face_(face), along_u_(along_u), window_(window) {}

    /// Adds a place; false if it has no material or no normal.
    bool add(const Vec2& place) {
        const FaceSurface& face = faces_.face(face_);
        const auto s = face.evaluate(place, 2);
        const auto normal = s ? face.normal(*s) : std::nullopt;
        if (!normal) return false;
        own_.push_back({{face_, place},
                        s->position(),
                        0,
                        second_form(*s, *normal, along_u_ ? s->du() : s->dv())});
        return true;
    }
    bool empty() const { return own_.empty(); }
    void clear() { own_.clear(); }

    std::vector<FaceRipple> ripples(double depth) const {
        std::vector<WalkPoint> points;
        const GeodesicTrace before = beyond(own_.front(), -1), behind = beyond(own_.back(), 1);
        points.assign(before.points.rbegin(), before.points.rend());
        const std::size_t begin = points.size(), end = begin + own_.size();
        points.insert(points.end(), own_.begin(), own_.end());
        points.insert(points.end(), behind.points.begin(), behind.points.end());
        std::vector<FaceRipple> found;
        for (const Ripple& r :
             narrow_ripples(measured(points), depth, {before.ended, behind.ended})) {
            // Ripples on the next face are found there.
            if (r.index + 1 < begin || r.index > end) continue;
            const WalkPoint& point = points[r.index];
            const WalkPoint& near = points[std::clamp(r.index, begin, end - 1)];
            found.push_back({point.at, point.position, direction(near, r.slant), r.square_width(),
                             r.depth, r.deepest, r.cut, r.width > widest()});
        }
        return found;
    }

private:
    double spacing() const { return window_ * sample_share; }
    /// The widest wave with the error of its turns, as each is located to the next sample only.
    double widest() const { return widest_share * window_ + 2 * spacing(); }

    /// The ripples that are narrow enough square to their crests. Those that are wider along the
    /// line are searched by themselves, as they bend it less: small turns that are seen then would
    /// divide the others.
    std::vector<Ripple> narrow_ripples(std::span<const BendPoint> line, double depth,
                                       const LineEnds& ends) const {
        std::vector<Ripple> narrow;
        for (const Ripple& r : find_ripples(line, depth, window_, ends))
            if (r.width <= widest()) narrow.push_back(r);
        for (const Ripple& r : find_ripples(line, depth, window_ / std::cos(most_slant), ends))
            if (r.width > widest() && r.square_width() <= widest()) narrow.push_back(r);
        return narrow;
    }

    /// Unit: that of the line at one of its own points, turned about the normal by `slant`.
    Vec3 direction(const WalkPoint& own, double slant = 0) const {
        const auto s = faces_.evaluate(own.at, 1);
        const Vec3 along = along_u_ ? s->du() : s->dv();
        const auto frame = faces_.frame(own.at, *s, along);
        return frame ? frame->x * std::cos(slant) + frame->y * std::sin(slant) : along.normalized();
    }
    /// The continuation without its first point, which is the line's own.
    GeodesicTrace beyond(const WalkPoint& end, double side) const {
        GeodesicTrace walk = walk_straight(faces_, end.at, direction(end) * side, spacing(),
                                           follow_share * window_, true);
        if (!walk.points.empty()) walk.points.erase(walk.points.begin());
        return walk;
    }
    static std::vector<BendPoint> measured(const std::vector<WalkPoint>& points) {
        std::vector<BendPoint> line;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double step = i == 0 ? 0 : (points[i].position - points[i - 1].position).length();
            line.push_back({i == 0 ? 0 : line.back().length + step, points[i].bend});
        }
        return line;
    }

    const FaceAdjacency& faces_;
    std::size_t face_;
    bool along_u_;
    double window_;
    std::vector<WalkPoint> own_;
};

} // namespace

bool is_searchable(const FaceSurface& face, const WavinessLimit& limit) {
    constexpr double most = 1e7; // some 10 seconds
    const auto parts = [&](const std::vector<double>& lengths) {
        double count = 2 * follow_share / sample_share; // beyond the ends of a line
        for (const double length : lengths)
            count += part_count(length, limit.window * sample_share);
        return count;
    };
    return parts(face.span_lengths_u()) * parts(face.span_lengths_v()) <= most;
}

std::vector<FaceRipple> find_face_ripples(const FaceAdjacency& faces, std::size_t face,
                                          const WavinessLimit& limit) {
    const double spacing = limit.window * sample_share;
    const std::vector<double> u = spread(faces.face(face).span_lengths_u(), spacing);
    const std::vector<double> v = spread(faces.face(face).span_lengths_v(), spacing);
    std::vector<FaceRipple> found;
    const auto search = [&](bool along_u) {
        RippleLine line(faces, face, along_u, limit.window);
        const auto end_line = [&] {
            if (line.empty()) return;
            const std::vector<FaceRipple> more = line.ripples(limit.depth * ripple_share);
            found.insert(found.end(), more.begin(), more.end());
            line.clear();
        };
        for (const double across : along_u ? v : u) {
            for (const double along : along_u ? u : v) {
                check_stop();
                if (!line.add(along_u ? Vec2(along, across) : Vec2(across, along))) end_line();
            }
            end_line();
        }
    };
    search(true), search(false);
    return found;
}

std::vector<std::vector<FaceRipple>> ripple_groups(const FaceAdjacency& faces,
                                                   std::vector<FaceRipple> ripples, double cell) {
    using Cell = std::array<long, 4>; // of a sheet, in space
    const auto number = [cell](double x) { return static_cast<long>(std::floor(x / cell)); };
    std::stable_sort(ripples.begin(), ripples.end(), [](const FaceRipple& a, const FaceRipple& b) {
        return std::abs(a.depth) > std::abs(b.depth);
    });
    DisjointSets sets(ripples.size());
    std::map<Cell, std::size_t> cells;
    for (std::size_t i = 0; i < ripples.size(); ++i) {
        const Vec3& p = ripples[i].position;
        const Cell at{static_cast<long>(faces.sheet(ripples[i].at.face)), number(p.x), number(p.y),
                      number(p.z)};
        cells.try_emplace(at, i);
        for (int k = 0; k < 27; ++k) {
            const auto near =
                cells.find({at[0], at[1] + k % 3 - 1, at[2] + k / 3 % 3 - 1, at[3] + k / 9 - 1});
            if (near != cells.end()) sets.join(i, near->second);
        }
    }
    std::map<std::size_t, std::size_t> group_of;
    std::vector<std::vector<FaceRipple>> groups;
    for (std::size_t i = 0; i < ripples.size(); ++i) {
        const auto [at, fresh] = group_of.try_emplace(sets.root(i), groups.size());
        if (fresh) groups.emplace_back();
        groups[at->second].push_back(ripples[i]);
    }
    return groups;
}

} // namespace keiko
