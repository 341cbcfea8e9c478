#include "keiko/inspect/flaws/face_ripples.h"

#include "keiko/inspect/flaws/face_grid.h"
#include "keiko/inspect/flaws/geodesic_trace.h"
#include "keiko/inspect/flaws/ripple.h"

#include <algorithm>

namespace keiko {
namespace {

/// Distance between samples as a share of the window's width.
constexpr double sample_share = 1.0 / 20;
/// Share of the limit down to which ripples are searched: planted dents are up to 5.3 times as deep
/// as their ripples may be.
constexpr double ripple_share = 1.0 / 6;
/// Distance to which lines are followed beyond a face: half the widest wave and what it takes to
/// detect that the curvature comes back.
constexpr double follow_share = 0.75;

/// A line over a face and its continuation at either end.
class RippleLine {
public:
    RippleLine(const FaceAdjacency& faces, std::size_t face, bool along_u, double window)
        : faces_(faces), face_(face), along_u_(along_u), window_(window) {}

    void add(const Vec2& place, const FaceSample& sample) {
        own_.push_back(
            {{face_, place}, sample.position, 0, along_u_ ? sample.bend_u : sample.bend_v});
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
             find_ripples(measured(points), depth, window_, {before.ended, behind.ended})) {
            // Ripples on the next face are found there.
            if (r.index + 1 < begin || r.index > end) continue;
            if (r.width > quantised(widest_share * window_)) continue;
            const WalkPoint& point = points[r.index];
            const WalkPoint& near = points[std::clamp(r.index, begin, end - 1)];
            found.push_back(
                {point.at, point.position, direction(near), r.width, r.depth, r.deepest, r.cut});
        }
        return found;
    }

private:
    double spacing() const { return window_ * sample_share; }
    /// Width with the error of its turns, as each is located to the next sample only.
    double quantised(double width) const { return width + 2 * spacing(); }

    Vec3 direction(const WalkPoint& point) const {
        const auto s = faces_.evaluate(point.at, 1);
        return (along_u_ ? s->du() : s->dv()).normalized();
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

std::vector<FaceRipple> find_face_ripples(const FaceAdjacency& faces, std::size_t face,
                                          const WavinessLimit& limit) {
    const FaceGrid grid(faces.face(face), limit.window * sample_share);
    std::vector<FaceRipple> found;
    const auto search = [&](bool along_u) {
        RippleLine line(faces, face, along_u, limit.window);
        const std::size_t lines = along_u ? grid.rows() : grid.columns();
        const std::size_t count = along_u ? grid.columns() : grid.rows();
        for (std::size_t l = 0; l < lines; ++l) {
            line.clear();
            for (std::size_t k = 0; k <= count; ++k) {
                const std::size_t column = along_u ? k : l, row = along_u ? l : k;
                if (k < count && grid.sample(column, row).material) {
                    line.add(grid.place(column, row), grid.sample(column, row));
                    continue;
                }
                if (line.empty()) continue;
                const std::vector<FaceRipple> more = line.ripples(limit.depth * ripple_share);
                found.insert(found.end(), more.begin(), more.end());
                line.clear();
            }
        }
    };
    search(true), search(false);
    return found;
}

} // namespace keiko
