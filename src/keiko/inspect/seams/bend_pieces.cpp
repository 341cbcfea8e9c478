#include "keiko/inspect/seams/bend_pieces.h"

#include "keiko/base/units.h"
#include "keiko/inspect/seams/knot_piece.h"
#include "keiko/inspect/seams/slow_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace keiko {
namespace {

/// Share of a patch's width at which the search for a distance from a line starts.
constexpr double first_step = 1e-6;
/// Degrees: larger than the turn of a window that rounding and the errors of curvature rates cause.
constexpr double least_turn = 1e-3;
/// Degrees: larger than the turn between sides close together that rounding causes.
constexpr double least_limit = 1e-4;

class Bends {
public:
    Bends(const KnottedFace& face, double window) : face_(face), window_(window) {}

    std::vector<KnotPiece> all() {
        const SurfaceModel& model = face_.model();
        for (const bool constant_u : {true, false}) {
            Strips strips;
            for (std::uint32_t k = 0; k < face_.face().patch_count; ++k)
                add_bends(model.patches[face_.face().first_patch + k],
                          model.patch(face_.face().first_patch + k), constant_u, strips);
            for (auto& [along, strip] : strips) add_bends_of_runs(strip, along, constant_u);
        }
        return sharpest();
    }

private:
    /// A bend, and the window that it lies in.
    struct Bend {
        KnotPiece piece, window;
        double whole = 0; ///< degrees, of a bend as wide as its window; else 0
    };

    /// Narrow patches: the ranges of the parameter across the lines, by the range along them.
    using Strips = std::map<std::pair<double, double>, std::vector<ParameterInterval>>;

    /// True if the face is no wider than the window from a line to another one.
    bool is_narrow(const KnotPiece& from, double to) const {
        return distances(from, to).least <= window_;
    }

    /// Adds the bends about the middles of runs of patches that are together no wider than the
    /// window. Several patches share a bend where as many knots as the degree lie close together.
    void add_bends_of_runs(std::vector<ParameterInterval>& strip,
                           const std::pair<double, double>& along, bool constant_u) {
        std::sort(strip.begin(), strip.end(),
                  [](const auto& a, const auto& b) { return a.begin < b.begin; });
        for (std::size_t i = 0; i < strip.size(); ++i) {
            const KnotPiece from{constant_u, strip[i].begin, along.first, along.second};
            std::size_t last = i;
            while (last + 1 < strip.size() && strip[last + 1].begin == strip[last].end &&
                   is_narrow(from, strip[last + 1].end))
                ++last;
            if (last == i) continue;
            const double most = strip[last].end - strip[i].begin;
            const double half = distances(from, strip[last].end).most / 2;
            KnotPiece line = from;
            line.at = parameter_at(from, half, most, most).value_or(from.at + most / 2);
            if (!is_point(line)) add_bend(line, most);
        }
    }

    /// Adds the bends of a patch, and a patch that is narrow to its strip.
    void add_bends(const Patch& patch, const BezierPatchView& points, bool constant_u,
                   Strips& strips) {
        const ParameterMap& across = constant_u ? patch.map_u : patch.map_v;
        const ParameterMap& along = constant_u ? patch.map_v : patch.map_u;
        tested_ = isoline_places((constant_u ? points.degree_v : points.degree_u) + 1);
        for (const double t : slow_lines(points, constant_u, tested_, window_)) {
            if (t == middle_of_narrow)
                strips[{along.begin, along.end}].push_back({across.begin, across.end});
            const double at = t == 0 ? across.begin : t == 1 ? across.end : across.to_face(t);
            const KnotPiece line{constant_u, at, along.begin, along.end};
            const auto is_known = [&](const Bend& b) { return b.piece.order() == line.order(); };
            if (is_point(line) || std::any_of(bends_.begin(), bends_.end(), is_known)) continue;
            add_bend(line, across.end - across.begin);
        }
    }

    void add_bend(const KnotPiece& line, double width) {
        KnotPiece close = between(line, window_ / 2000, width);
        KnotPiece apart = between(line, window_ / 2, width);
        const double limit = close.is_bend() ? largest_angle(close) : 0;
        close.has_limits = is_singular(line), apart.has_limits = false;
        if (apart.is_bend() && is_tight(apart, limit))
            bends_.push_back({apart, apart, largest_angle(apart)});
        else if (close.is_bend() && (limit > least_limit || (close.has_limits && breaks(close))))
            bends_.push_back({close, apart.is_bend() ? apart : close});
    }

    /// The bend with the nearest sides among bends within each other's windows; of those that are
    /// as wide as the window, the one that turns the most.
    std::vector<KnotPiece> sharpest() {
        const auto order = [](const Bend& bend) {
            return std::tuple(bend.whole > 0, -bend.whole, bend.piece.high - bend.piece.low);
        };
        const auto sharper = [&](const Bend& a, const Bend& b) { return order(a) < order(b); };
        std::stable_sort(bends_.begin(), bends_.end(), sharper);
        std::vector<KnotPiece> kept, windows;
        for (const Bend& bend : bends_) {
            const auto meets = [&](const KnotPiece& window) { return window.meets(bend.window); };
            if (std::any_of(windows.begin(), windows.end(), meets)) continue;
            kept.push_back(bend.piece), windows.push_back(bend.window);
        }
        return kept;
    }

    /// True if the normal turns clearly more between the sides than in the limit. Within the window
    /// it must not turn less than the sides' curvatures would additionally make it turn.
    bool is_tight(const KnotPiece& apart, double limit) const {
        constexpr double clearly = 1.01;
        const std::vector<SeamPoint> points = places(apart);
        return std::any_of(points.begin(), points.end(), [&](const SeamPoint& p) {
            const double besides =
                (std::abs(p.curvature_a) + std::abs(p.curvature_b)) / 2 * window_;
            return p.angle && *p.angle > std::max(least_turn, clearly * limit) &&
                   *p.angle >= radians_to_degrees(besides);
        });
    }

    bool is_singular(const KnotPiece& line) const {
        const std::vector<SeamPoint> points = places(line);
        return std::none_of(points.begin(), points.end(),
                            [](const SeamPoint& p) { return p.angle.has_value(); });
    }

    std::vector<SeamPoint> places(const KnotPiece& piece) const {
        const std::array<Vec3, 2> left = piece.side(true), right = piece.side(false);
        const Affine unmoved;
        const SeamProbe probe = face_.probe(piece, unmoved, left, right);
        std::vector<SeamPoint> points;
        for (const double t : tested_) points.push_back(probe.at(t));
        return points;
    }

    double largest_angle(const KnotPiece& piece) const {
        double largest = 0;
        for (const SeamPoint& p : places(piece)) largest = std::max(largest, p.angle.value_or(0));
        return largest;
    }

    bool breaks(const KnotPiece& piece) const {
        const std::vector<SeamPoint> points = places(piece);
        return std::any_of(points.begin(), points.end(), breaks_at);
    }

    /// The line with its sides `distance` mm away, or at the line itself if the face ends before.
    KnotPiece between(KnotPiece line, double distance, double width) const {
        const Box2 domain = face_.domain();
        const double begin = line.constant_u ? domain.lower.x : domain.lower.y;
        const double end = line.constant_u ? domain.upper.x : domain.upper.y;
        const auto low = parameter_at(line, distance, -width, line.at - begin);
        const auto high = parameter_at(line, distance, width, end - line.at);
        if (low && high) line.low = *low, line.high = *high;
        return line;
    }

    /// The parameter beside a line whose farthest tested place is `distance` mm square to it, to a
    /// thousandth of the parameter; nullopt if there is none within `most`. The search starts at
    /// `width`.
    std::optional<double> parameter_at(const KnotPiece& line, double distance, double width,
                                       double most) const {
        const auto reaches = [&](double step) {
            return distances(line, line.at + std::copysign(step, width)).most >= distance;
        };
        double below = 0, above = std::min(first_step * std::abs(width), most);
        while (!reaches(above)) {
            if (!(above < most)) return std::nullopt;
            below = above, above = std::min(4 * above, most);
        }
        constexpr double enough = 1e-3;
        while (above - below > enough * above) {
            const double middle = (below + above) / 2;
            (reaches(middle) ? above : below) = middle;
        }
        return line.at + std::copysign(above, width);
    }

    /// mm from the tested places of a line to those of another, square to it.
    struct Distances {
        double least = HUGE_VAL, most = 0;
    };

    Distances distances(const KnotPiece& line, double beside) const {
        Distances result;
        for (const double t : tested_) {
            const double x = line.begin + t * (line.end - line.begin);
            const Vec2 on_line = line.point(line.at, x);
            const Vec3 way = face_.point(line.point(beside, x)) - face_.point(on_line);
            const double far = square_to(way, face_.along(on_line, line.constant_u)).length();
            result.least = std::min(result.least, far), result.most = std::max(result.most, far);
        }
        return result;
    }

    /// True if a line is a point, as at a pole, and has no sides.
    bool is_point(const KnotPiece& line) const {
        const auto place = [&](double t) {
            return face_.point(line.point(line.at, line.begin + t * (line.end - line.begin)));
        };
        const Vec3 first = place(tested_.front());
        return std::all_of(tested_.begin(), tested_.end(),
                           [&](double t) { return (place(t) - first).length() < window_ / 2000; });
    }

    const KnottedFace& face_;
    double window_;
    std::vector<double> tested_; ///< shares of the line at hand
    std::vector<Bend> bends_;
};

} // namespace

std::vector<KnotPiece> bend_pieces(const KnottedFace& face, double window) {
    return Bends(face, window).all();
}

} // namespace keiko
