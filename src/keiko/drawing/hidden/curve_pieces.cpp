#include "keiko/drawing/hidden/curve_pieces.h"

#include <algorithm>

namespace keiko {
namespace {

/// Share of the body's size between places of a curve that lines of sight can tell apart.
constexpr double nearest_places = 4e-6;

/// Stretch of a curve between two changes, and the sum of those at its begin.
struct Stretch {
    double begin = 0, end = 0;
    int change = 0;

    double middle() const { return (begin + end) / 2; }
};

/// mm, of the chords.
double length_of(const CurveCourse& course, double begin, double end) {
    double length = 0;
    Vec3 last = course.at(begin);
    for (double t = std::floor(begin) + 1; t < end; ++t) {
        const Vec3 next = course.at(t);
        length += (next - last).length(), last = next;
    }
    return length + (course.at(end) - last).length();
}

/// Stretches of a curve, none shorter than what a line of sight can tell apart. Changes nearer to
/// each other than that count as one, those at the ends of the curve as none.
std::vector<Stretch> stretches_of(const ModelCurve& curve, std::span<const CountChange> changes,
                                  double size) {
    const double shortest = nearest_places * size;
    std::vector<Stretch> stretches{{0, curve.course.end()}};
    for (const CountChange& change : changes) {
        Stretch& last = stretches.back();
        if (length_of(curve.course, last.begin, change.t) <= shortest) {
            if (last.begin > 0) last.change += change.change;
            continue;
        }
        if (length_of(curve.course, change.t, curve.course.end()) <= shortest) break;
        last.end = change.t;
        stretches.push_back({change.t, curve.course.end(), change.change});
    }
    return stretches;
}

/// Finds the pieces of one curve by rays, stretch after stretch.
class RayPieces {
public:
    RayPieces(const ModelCurve& curve, const SightTest& sight) : curve_(curve), sight_(sight) {}

    /// Adds a stretch without a known change. Rays at places of it look for what the search for
    /// changes has missed.
    void add(const Stretch& stretch) {
        std::vector<CurvePiece> runs = runs_of(stretch);
        if (runs.size() == 1) return append(runs.front());
        for (CurvePiece& run : runs) {
            // One ray may hit the seam of a border that it passes. A run of such is none.
            const double middle = (run.begin + run.end) / 2;
            const bool visible = sight_.visible(curve_.course.at(middle), curve_);
            if (visible || !shows_at(middle)) run.visible = visible;
            append(run);
        }
    }
    std::vector<CurvePiece> take() { return std::move(pieces_); }

private:
    /// True where the curve is visible, or a place beside it: of edges that coincide in the image,
    /// rounding alone hides one behind the border of the other.
    bool shows_at(double t) const {
        const Vec3 place = curve_.course.at(t);
        return sight_.visible(place, curve_) || sight_.visible_beside(place, curve_);
    }

    /// Neighbouring places of a stretch of one class. Halving finds where it changes.
    std::vector<CurvePiece> runs_of(const Stretch& stretch) const {
        const bool contour = curve_.is_contour_edge(stretch.middle(), sight_.projection());
        const std::vector<Probe> probes = probes_of(stretch);
        double last = probes.front().t;
        std::vector<CurvePiece> runs{{stretch.begin, stretch.end, probes.front().visible, contour}};
        for (const Probe& probe : probes) {
            const bool visible = runs.back().visible;
            if (probe.visible != visible) {
                runs.back().end = change_between(last, probe.t, visible);
                runs.push_back({runs.back().end, stretch.end, probe.visible, contour});
            }
            last = probe.t;
        }
        return runs;
    }

    struct Probe {
        double t;
        bool visible;
    };

    /// Rays that look for changes within a stretch, in order: at its middle, at the points of the
    /// curve in it, and ever more towards its ends. Changes that the search misses are those of
    /// nearly tangent images, which lie beside contacts at any scale. A place that another
    /// face hides, and beside which the curve is visible, decides nothing. Without any that does
    /// the stretch is visible.
    std::vector<Probe> probes_of(const Stretch& stretch) const {
        std::vector<double> places = inner_places(stretch);
        const std::size_t inner = places.size();
        for (const double t : towards_ends(stretch)) places.push_back(t);
        std::vector<Vec3> points;
        for (const double t : places) points.push_back(curve_.course.at(t));
        const std::vector<PointSight> found = sight_.sights(points, curve_);
        const auto is_visible = [](const PointSight& sight) { return sight.visible; };
        if (std::all_of(found.begin(), found.end(), is_visible)) return {{places[0], true}};
        const bool none = std::none_of(found.begin(), found.end(), is_visible);
        std::vector<Probe> probes;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool is_inner = i < inner;
            const bool decides = found[i].visible ? is_inner || found[i].sure
                                                  : (is_inner && found[i].by_own) ||
                                                        !sight_.visible_beside(points[i], curve_);
            if (decides) probes.push_back({places[i], found[i].visible});
            if (decides && none) return probes;
        }
        if (probes.empty()) return {{places[0], true}};
        std::sort(probes.begin(), probes.end(),
                  [](const Probe& a, const Probe& b) { return a.t < b.t; });
        return probes;
    }

    /// The middle of a stretch, then the points of the curve in it.
    std::vector<double> inner_places(const Stretch& stretch) const {
        std::vector<double> places{stretch.middle()};
        for (double t = std::floor(stretch.begin) + 1; t < stretch.end; ++t)
            if (!is_at_end(t, stretch)) places.push_back(t);
        return places;
    }

    /// Places in the first and the last chord of a stretch, each four times as near to the end as
    /// the one before. None at cusps, at which a line of sight meets an outline and the sheet that
    /// hides it in one root.
    std::vector<double> towards_ends(const Stretch& stretch) const {
        const double first = std::min(std::floor(stretch.begin) + 1, stretch.end);
        const double last = std::max(std::ceil(stretch.end) - 1, stretch.begin);
        std::vector<double> places;
        constexpr int most = 12; // quarters: far more than is_at_end() leaves
        double share = 1;
        for (int i = 0; i < most; ++i) {
            share /= 4;
            if (!is_cusp(stretch.begin))
                places.push_back(stretch.begin + share * (first - stretch.begin));
            if (!is_cusp(stretch.end)) places.push_back(stretch.end - share * (stretch.end - last));
        }
        std::erase_if(places, [&](double t) { return is_at_end(t, stretch); });
        return places;
    }

    bool is_cusp(double t) const {
        return std::find(curve_.cusps.begin(), curve_.cusps.end(), t) != curve_.cusps.end();
    }

    /// True for a place so near to an end of a stretch that a line of sight may touch a surface
    /// there.
    bool is_at_end(double t, const Stretch& stretch) const {
        const Vec3 place = curve_.course.at(t);
        return std::min((place - curve_.course.at(stretch.begin)).length(),
                        (place - curve_.course.at(stretch.end)).length()) <=
               nearest_places * sight_.size();
    }

    /// The place between two parameters at which the first one's class ends.
    double change_between(double a, double b, bool visible) const {
        constexpr int halvings = 40;
        for (int i = 0; i < halvings; ++i) {
            const double middle = (a + b) / 2;
            (shows_at(middle) == visible ? a : b) = middle;
        }
        return a;
    }

    void append(const CurvePiece& piece) {
        if (!pieces_.empty() && pieces_.back().visible == piece.visible &&
            pieces_.back().contour == piece.contour)
            pieces_.back().end = piece.end;
        else
            pieces_.push_back(piece);
    }

    const ModelCurve& curve_;
    const SightTest& sight_;
    std::vector<CurvePiece> pieces_;
};

} // namespace

std::vector<CurvePiece> pieces_by_rays(const ModelCurve& curve,
                                       std::span<const CountChange> changes,
                                       const SightTest& sight) {
    RayPieces pieces(curve, sight);
    for (const Stretch& stretch : stretches_of(curve, changes, sight.size())) pieces.add(stretch);
    return pieces.take();
}

std::vector<CountedPiece> pieces_by_count(const ModelCurve& curve,
                                          std::span<const CountChange> changes,
                                          const SightTest& sight) {
    const std::vector<Stretch> stretches = stretches_of(curve, changes, sight.size());
    const auto length = [&](const Stretch& s) { return length_of(curve.course, s.begin, s.end); };
    const auto longest =
        std::max_element(stretches.begin(), stretches.end(),
                         [&](const auto& a, const auto& b) { return length(a) < length(b); });
    int count = sight.sheets_before(curve.course.at(longest->middle()), curve);
    for (auto s = longest; s != stretches.begin(); --s) count -= s->change;
    std::vector<CountedPiece> pieces;
    for (const Stretch& stretch : stretches) {
        count += stretch.change; // that of the first is 0
        pieces.push_back({stretch.begin, stretch.end, count});
    }
    return pieces;
}

} // namespace keiko
