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

/// Changes as if all that follow one within a distance of it, mm along the curve, were at its
/// place.
std::vector<CountChange> merged(std::span<const CountChange> changes, const CurveCourse& course,
                                double distance) {
    std::vector<CountChange> merged;
    for (const CountChange& change : changes)
        if (!merged.empty() && length_of(course, merged.back().t, change.t) <= distance)
            merged.back().change += change.change;
        else
            merged.push_back(change);
    return merged;
}

/// Stretches of a curve, none shorter than what a line of sight can tell apart. Changes nearer to
/// each other than that count as one, those at the ends of the curve as none.
std::vector<Stretch> stretches_of(const ModelCurve& curve, std::span<const CountChange> changes,
                                  double size) {
    const double shortest = nearest_places * size, end = curve.course.end();
    std::vector<Stretch> stretches{{0, end}};
    for (const CountChange& change : merged(changes, curve.course, shortest)) {
        if (length_of(curve.course, 0, change.t) <= shortest) continue;
        if (length_of(curve.course, change.t, end) <= shortest) break;
        stretches.back().end = change.t;
        stretches.push_back({change.t, end, change.change});
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
        std::vector<Run> runs = runs_of(stretch);
        for (Run& run : runs) {
            if (runs.size() > 1) test_middle(run.piece);
            runs_.push_back(run);
        }
    }

    /// The pieces of all stretches that were added.
    std::vector<CurvePiece> take() {
        for (std::size_t i = 1; i < runs_.size(); ++i) settle(runs_[i], runs_[i - 1], runs_[i]);
        for (std::size_t i = runs_.size(); i-- > 1;) settle(runs_[i - 1], runs_[i], runs_[i]);
        std::vector<CurvePiece> pieces;
        for (const auto& [piece, change, decided] : runs_)
            if (!pieces.empty() && pieces.back().visible == piece.visible &&
                pieces.back().contour == piece.contour)
                pieces.back().end = piece.end;
            else
                pieces.push_back(piece);
        return pieces;
    }

private:
    /// Neighbouring places of a stretch of one class.
    struct Run {
        CurvePiece piece;
        int change = 0;      ///< sum of the known changes at its begin
        bool decided = true; ///< by a ray
    };

    /// A run that no ray decides is as a neighbour if the changes between both add up to 0. So is
    /// the end of a curve behind the edge of a slit that is narrower than the places that lines of
    /// sight can tell apart. `later`: the second of both.
    static void settle(Run& run, const Run& neighbour, const Run& later) {
        if (run.decided || !neighbour.decided || later.change != 0) return;
        run.piece.visible = neighbour.piece.visible;
        run.decided = true;
    }

    /// Tests a run again in its middle: one ray may hit the seam of a border that it passes.
    void test_middle(CurvePiece& run) const {
        const double middle = (run.begin + run.end) / 2;
        const bool visible = sight_.visible(curve_.course.at(middle), curve_);
        if (visible || !shows_at(middle)) run.visible = visible;
    }

    /// True where the curve is visible, or a place beside it: of edges that coincide in the image,
    /// rounding alone hides one behind the border of the other.
    bool shows_at(double t) const {
        const Vec3 place = curve_.course.at(t);
        return sight_.visible(place, curve_) || sight_.visible_beside(place, curve_);
    }

    /// The runs of a stretch. Halving finds where one ends. One that no ray decides is visible.
    std::vector<Run> runs_of(const Stretch& stretch) const {
        const bool contour = curve_.is_contour_edge(stretch.middle(), sight_.projection());
        const std::vector<Probe> probes = probes_of(stretch);
        const bool decided = !probes.empty(), visible = !decided || probes.front().visible;
        std::vector<Run> runs{
            {{stretch.begin, stretch.end, visible, contour}, stretch.change, decided}};
        double last = stretch.begin;
        for (const Probe& probe : probes) {
            CurvePiece& run = runs.back().piece;
            if (probe.visible != run.visible) {
                run.end = change_between(last, probe.t, run.visible);
                runs.push_back({{run.end, stretch.end, probe.visible, contour}});
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
    /// face hides, and beside which the curve is visible, decides nothing. Empty without any that
    /// does.
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

    const ModelCurve& curve_;
    const SightTest& sight_;
    std::vector<Run> runs_;
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
