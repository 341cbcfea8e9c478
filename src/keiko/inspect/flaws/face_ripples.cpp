#include "keiko/inspect/flaws/face_ripples.h"

#include "keiko/base/job.h"
#include "keiko/inspect/flaws/face_surface.h"
#include "keiko/inspect/flaws/geodesic_trace.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

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

/// A place of a face as a line through it has it.
struct LinePlace {
    Vec3 position{0};               ///< world, mm
    std::optional<SecondForm> bend; ///< 1/mm, x along the line; nullopt: no material or no normal
};

/// A place as the line along u and the line along v have it.
std::array<LinePlace, 2> crossing(const FaceSurface& face, const Vec2& place) {
    const auto s = face.evaluate(place, 2);
    const auto normal = s ? face.normal(*s) : std::nullopt;
    if (!normal) return {};
    return {{{s->position(), second_form(*s, *normal, s->du())},
             {s->position(), second_form(*s, *normal, s->dv())}}};
}

/// The ripples of lines of one direction over a face, each with its continuation at either end.
class LineRipples {
public:
    /// Ripples are added to `found`.
    LineRipples(const FaceAdjacency& faces, std::size_t face, bool along_u,
                const WavinessLimit& limit, std::vector<FaceRipple>& found)
        : faces_(faces), face_(face), along_u_(along_u), limit_(limit), found_(found) {}

    /// Adds the next place of its line. One without material or normal ends a stretch, as end()
    /// does.
    void add(const Vec2& place, const LinePlace& next) {
        if (!next.bend) return end();
        own_.push_back({{face_, place}, next.position, 0, *next.bend});
    }
    /// Searches the stretch that was added; the next one begins.
    void end() {
        if (own_.empty()) return;
        search();
        own_.clear();
    }

private:
    void search() {
        std::vector<WalkPoint> points;
        const GeodesicTrace before = beyond(own_.front(), -1), behind = beyond(own_.back(), 1);
        points.assign(before.points.rbegin(), before.points.rend());
        const std::size_t begin = points.size(), end = begin + own_.size();
        points.insert(points.end(), own_.begin(), own_.end());
        points.insert(points.end(), behind.points.begin(), behind.points.end());
        for (const Ripple& r : narrow_ripples(measured(points), {before.ended, behind.ended})) {
            // Ripples on the next face are found there.
            if (r.index + 1 < begin || r.index > end) continue;
            const WalkPoint& point = points[r.index];
            const WalkPoint& near = points[std::clamp(r.index, begin, end - 1)];
            found_.push_back({point.at, point.position, direction(near, r.slant), r.square_width(),
                              r.depth, r.deepest, r.cut, r.width > widest()});
        }
    }
    double window() const { return limit_.window; }
    double spacing() const { return window() * sample_share; }
    /// The widest wave with the error of its turns, as each is located to the next sample only.
    double widest() const { return widest_share * window() + 2 * spacing(); }

    /// The ripples that are narrow enough square to their crests. Those that are wider along the
    /// line are searched by themselves, as they bend it less: small turns that are seen then would
    /// divide the others.
    std::vector<Ripple> narrow_ripples(std::span<const BendPoint> line,
                                       const LineEnds& ends) const {
        const double depth = limit_.depth * ripple_share;
        std::vector<Ripple> narrow;
        for (const Ripple& r : find_ripples(line, depth, window(), ends))
            if (r.width <= widest()) narrow.push_back(r);
        for (const Ripple& r : find_ripples(line, depth, window() / std::cos(most_slant), ends))
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
                                           follow_share * window(), true);
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
    const WavinessLimit& limit_;
    std::vector<WalkPoint> own_; ///< of the stretch at hand
    std::vector<FaceRipple>& found_;
};

} // namespace

bool is_searchable(const FaceSurface& face, const WavinessLimit& limit) {
    constexpr double most = 1e7; // some 5 seconds and 600 MB
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
    // Each place is evaluated once, for both of its lines.
    std::vector<LinePlace> along_v(u.size() * v.size());
    std::vector<FaceRipple> found;
    LineRipples rows(faces, face, true, limit, found), columns(faces, face, false, limit, found);
    for (std::size_t j = 0; j < v.size(); ++j, rows.end())
        for (std::size_t i = 0; i < u.size(); ++i) {
            check_stop();
            const Vec2 place(u[i], v[j]);
            auto [of_row, of_column] = crossing(faces.face(face), place);
            rows.add(place, of_row);
            along_v[i * v.size() + j] = of_column;
        }
    for (std::size_t i = 0; i < u.size(); ++i, columns.end()) {
        check_stop();
        for (std::size_t j = 0; j < v.size(); ++j)
            columns.add(Vec2(u[i], v[j]), along_v[i * v.size() + j]);
    }
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
