#include "keiko/inspect/bend_pieces.h"

#include "keiko/inspect/slow_lines.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Share of a patch's width at which the search for a distance from a line starts.
constexpr double first_step = 1e-6;
/// Degrees: what rounding and the rates of curvatures leave of a window's turn is far less.
constexpr double least_turn = 1e-3;

class Bends {
public:
    Bends(const KnottedFace& face, double window) : face_(face), window_(window) {}

    std::vector<KnotPiece> all() {
        const SurfaceModel& model = face_.model();
        for (std::uint32_t k = 0; k < face_.face().patch_count; ++k)
            for (const bool constant_u : {true, false})
                add_bends(model.patches[face_.face().first_patch + k],
                          model.patch(face_.face().first_patch + k), constant_u);
        return std::move(found_);
    }

private:
    void add_bends(const Patch& patch, const BezierPatchView& points, bool constant_u) {
        const ParameterMap& across = constant_u ? patch.map_u : patch.map_v;
        const ParameterMap& along = constant_u ? patch.map_v : patch.map_u;
        for (const double t : slow_lines(points, constant_u, window_)) {
            const double at = t == 0 ? across.begin : t == 1 ? across.end : across.to_face(t);
            const KnotPiece line{constant_u, at, along.begin, along.end};
            const auto covers = [&](const KnotPiece& piece) { return piece.covers(line); };
            if (is_point(line) || std::any_of(found_.begin(), found_.end(), covers)) continue;
            add_bend(line, across.end - across.begin);
        }
    }

    /// Sides close together show a break of the limits; sides apart what turns between them, and
    /// count where that is clearly more.
    void add_bend(const KnotPiece& line, double width) {
        const KnotPiece close = between(line, window_ / 2000, width);
        const KnotPiece apart = between(line, window_ / 2, width);
        const double turn = apart.is_bend() ? largest_angle(apart) : 0;
        constexpr double clearly = 1.5;
        if (turn > least_turn && !(close.is_bend() && turn < clearly * largest_angle(close)))
            found_.push_back(apart);
        else if (close.is_bend() && breaks(close))
            found_.push_back(close);
    }

    std::vector<SeamPoint> places(const KnotPiece& piece) const {
        const std::array<Vec3, 2> left = piece.side(true), right = piece.side(false);
        const Affine unmoved;
        const SeamProbe probe = face_.probe(piece, unmoved, left, right);
        std::vector<SeamPoint> points;
        for (const double t : tested_places) points.push_back(probe.at(t));
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

    /// The line with its sides `distance` mm away, itself where the face ends before.
    KnotPiece between(KnotPiece line, double distance, double width) const {
        const Box2 domain = face_.domain();
        const double begin = line.constant_u ? domain.lower.x : domain.lower.y;
        const double end = line.constant_u ? domain.upper.x : domain.upper.y;
        const auto low = parameter_at(line, distance, -width, line.at - begin);
        const auto high = parameter_at(line, distance, width, end - line.at);
        if (low && high) line.low = *low, line.high = *high;
        return line;
    }

    /// The parameter beside a line whose farthest tested place is `distance` mm away from it, to a
    /// hundredth; nothing where there is none within `most`. The search starts at `width`.
    std::optional<double> parameter_at(const KnotPiece& line, double distance, double width,
                                       double most) const {
        const auto reaches = [&](double step) {
            return farthest(line, line.at + std::copysign(step, width)) >= distance;
        };
        double below = 0, above = std::min(first_step * std::abs(width), most);
        while (!reaches(above)) {
            if (!(above < most)) return std::nullopt;
            below = above, above = std::min(4 * above, most);
        }
        constexpr double enough = 0.01;
        while (above - below > enough * above) {
            const double middle = (below + above) / 2;
            (reaches(middle) ? above : below) = middle;
        }
        return line.at + std::copysign(above, width);
    }

    double farthest(const KnotPiece& line, double beside) const {
        double most = 0;
        for (const double t : tested_places) {
            const double x = line.begin + t * (line.end - line.begin);
            const Vec3 way =
                face_.point(line.point(beside, x)) - face_.point(line.point(line.at, x));
            most = std::max(most, way.length());
        }
        return most;
    }

    /// A pole has no sides.
    bool is_point(const KnotPiece& line) const {
        const auto place = [&](double t) {
            return face_.point(line.point(line.at, line.begin + t * (line.end - line.begin)));
        };
        const Vec3 first = place(tested_places.front());
        return std::all_of(tested_places.begin(), tested_places.end(),
                           [&](double t) { return (place(t) - first).length() < window_ / 2000; });
    }

    const KnottedFace& face_;
    double window_;
    std::vector<KnotPiece> found_;
};

} // namespace

std::vector<KnotPiece> bend_pieces(const KnottedFace& face, double window) {
    return Bends(face, window).all();
}

} // namespace keiko
