#include "keiko/drawing/hidden/curve_pieces.h"

#include <algorithm>

namespace keiko {
namespace {

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
    const double shortest = 4e-6 * size;
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

    /// Adds a stretch without a known change. Rays at the points of the curve in it look for what
    /// the search for changes has missed, and halving finds its place.
    void add(const Stretch& stretch) {
        const bool contour = curve_.is_contour_edge(stretch.middle(), sight_.projection());
        const std::vector<double> probes = probes_of(stretch);
        double begin = stretch.begin, last = probes.front();
        bool visible = visible_at(last);
        for (const double probe : probes) {
            const bool next = visible_at(probe);
            if (next != visible) {
                const double change = change_between(last, probe, visible);
                append({begin, change, visible, contour});
                begin = change, visible = next;
            }
            last = probe;
        }
        append({begin, stretch.end, visible, contour});
    }
    std::vector<CurvePiece> take() { return std::move(pieces_); }

private:
    bool visible_at(double t) const { return sight_.visible(curve_.course.at(t), curve_); }

    /// The middle of a stretch and the points of the curve in it, in order. Points at its ends are
    /// left out, as a line of sight may touch a surface there.
    std::vector<double> probes_of(const Stretch& stretch) const {
        constexpr double at_end = 2e-5; // of the body's size
        const double margin = at_end * sight_.size();
        const Vec3 begin = curve_.course.at(stretch.begin), end = curve_.course.at(stretch.end);
        std::vector<double> probes{stretch.middle()};
        for (double t = std::floor(stretch.begin) + 1; t < stretch.end; ++t) {
            const Vec3 place = curve_.course.at(t);
            if ((place - begin).length() > margin && (place - end).length() > margin)
                probes.push_back(t);
        }
        std::sort(probes.begin(), probes.end());
        return probes;
    }

    /// The place between two parameters at which the first one's class ends.
    double change_between(double a, double b, bool visible) const {
        constexpr int halvings = 40;
        for (int i = 0; i < halvings; ++i) {
            const double middle = (a + b) / 2;
            (visible_at(middle) == visible ? a : b) = middle;
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
