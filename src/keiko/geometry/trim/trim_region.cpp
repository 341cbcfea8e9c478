#include "keiko/geometry/trim/trim_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace keiko {
namespace {

/// Number of rows beyond which more would cost memory without a gain.
constexpr std::size_t most_rows = 256;

MonotonePiece connector(const Vec2& from, const Vec2& to, std::uint32_t curve, double at) {
    return {{Vec3(from.x, from.y, 1), Vec3(to.x, to.y, 1)}, curve, at, at};
}

/// The pieces of one loop, closed by straight connectors wherever two ends differ at all: the
/// crossing count is only right on a chain that is closed bit for bit.
void append_loop(const SurfaceModel& model, const TrimLoop& loop,
                 std::vector<MonotonePiece>& pieces) {
    const std::size_t begin = pieces.size();
    for (std::uint32_t c = loop.first_curve; c < loop.first_curve + loop.curve_count; ++c) {
        std::vector<MonotonePiece> next = monotone_pieces(model.trim_curve(c), c);
        if (pieces.size() > begin && pieces.back().last() != next.front().first())
            pieces.push_back(connector(pieces.back().last(), next.front().first(), c, 0));
        std::move(next.begin(), next.end(), std::back_inserter(pieces));
    }
    if (pieces.size() == begin) return;
    const MonotonePiece& last = pieces.back();
    if (last.last() != pieces[begin].first())
        pieces.push_back(connector(last.last(), pieces[begin].first(), last.curve(), 1));
}

/// A part of a piece between two of its parameters.
struct Stretch {
    double a = 0, b = 1;
    Vec2 at_a{0}, at_b{0};

    /// Share of the chord from a to b at which it is nearest to `p`.
    double foot(const Vec2& p, const ParameterMetric& metric) const {
        const Vec2 chord = at_b - at_a;
        const double square = metric.dot(chord, chord);
        return square > 0 ? std::clamp(metric.dot(chord, p - at_a) / square, 0.0, 1.0) : 0;
    }
};

/// Distance of a place from the segment that a stretch has as its chord.
double chord_distance(const Vec2& p, const Stretch& s, const ParameterMetric& metric) {
    return metric.length(s.at_a + (s.at_b - s.at_a) * s.foot(p, metric) - p);
}

/// Largest distance of any place of a stretch from its chord: at most the width of its box, and, by
/// Taylor's theorem, an eighth of the bend.
double most_off_chord(const Stretch& s, double bend, const ParameterMetric& metric) {
    Box2 box;
    box.extend(s.at_a);
    box.extend(s.at_b);
    const double length = s.b - s.a;
    return std::min(metric.across(box.extent()), bend / 8 * (length * length));
}

/// Nearest point of a piece by branch and bound on the chords of its stretches; tightens `best`.
bool approach(const MonotonePiece& piece, const Vec2& p, const ParameterMetric& metric,
              TrimRegion::NearCurve& best) {
    // Where steps have no length (at a pole) everything is equally near: without this limit the
    // search would visit all of it.
    constexpr double share_of_distance = 1e-3, share_of_reach = 1e-9;
    // A stretch this short is its chord to within rounding.
    constexpr double straight = 1e-9;
    const double least = share_of_reach * best.distance, bend = metric.across(piece.bend());
    bool found = false;
    const auto tighten = [&](const Vec2& at, double t) {
        const double d = metric.length(at - p);
        if (d < best.distance)
            best = {d, piece.curve(), piece.curve_parameter(t), at}, found = true;
    };
    constexpr std::size_t most_open = 32; // halved 30 times, a stretch is short enough
    std::array<Stretch, most_open> open;
    open[0] = {0, 1, piece.first(), piece.last()};
    for (std::size_t count = 1; count > 0;) {
        const Stretch s = open[--count];
        const double share = s.foot(p, metric), off = most_off_chord(s, bend, metric);
        const Vec2 foot = s.at_a + (s.at_b - s.at_a) * share;
        if (!(metric.length(foot - p) - off < best.distance)) continue;
        const double t = s.a + (s.b - s.a) * share;
        if (s.b - s.a < straight) {
            tighten(foot, t);
            continue;
        }
        tighten(piece.point(t), t);
        if (off <= std::max(least, share_of_distance * best.distance)) continue;
        const double m = (s.a + s.b) / 2;
        const Vec2 at_m = piece.point(m);
        open[count++] = {m, s.b, at_m, s.at_b};
        open[count++] = {s.a, m, s.at_a, at_m};
    }
    return found;
}

} // namespace

TrimRegion::TrimRegion(const SurfaceModel& model, const Face& face,
                       std::span<const double> seam_widths) {
    for (const TrimLoop& loop : model.loops_of(face)) append_loop(model, loop, pieces_);
    for (const MonotonePiece& piece : pieces_) bounds_.extend(piece.box());
    list_edges(model, seam_widths);
    build_rows();
}

void TrimRegion::list_edges(const SurfaceModel& model, std::span<const double> seam_widths) {
    const auto width = [&](std::uint32_t curve, std::uint32_t edge) {
        if (edge == no_index) return 0.0;
        return seam_widths.empty() ? model.edges[edge].tolerance : seam_widths[curve];
    };
    for (const MonotonePiece& piece : pieces_) {
        const std::uint32_t edge = model.trim_curves[piece.curve()].edge;
        piece_edges_.push_back({edge, width(piece.curve(), edge)});
        if (edge != no_index) edges_.push_back(edge);
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

void TrimRegion::build_rows() {
    if (pieces_.empty()) return;
    find_row_borders();
    std::vector<std::vector<std::uint32_t>> rows(row_borders_.size() - 1);
    std::vector<std::uint32_t> order(pieces_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return pieces_[a].box().upper.x > pieces_[b].box().upper.x;
    });
    for (const std::uint32_t i : order) {
        const Box2& box = pieces_[i].box();
        for (std::size_t r = 0; r < rows.size(); ++r)
            if (row_borders_[r] <= box.upper.y && box.lower.y <= row_borders_[r + 1])
                rows[r].push_back(i);
    }
    for (const auto& row : rows) {
        row_begin_.push_back(static_cast<std::uint32_t>(row_pieces_.size()));
        row_pieces_.insert(row_pieces_.end(), row.begin(), row.end());
    }
    row_begin_.push_back(static_cast<std::uint32_t>(row_pieces_.size()));
}

/// Finds the begins and ends of pieces as borders of rows; if there are many, some are left out.
void TrimRegion::find_row_borders() {
    std::vector<double> ends;
    for (const MonotonePiece& piece : pieces_) {
        ends.push_back(piece.box().lower.y);
        ends.push_back(piece.box().upper.y);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const std::size_t stride = (ends.size() + most_rows - 1) / most_rows;
    for (std::size_t i = 0; i < ends.size(); i += stride) row_borders_.push_back(ends[i]);
    row_borders_.back() = ends.back();
    if (row_borders_.size() == 1) row_borders_.push_back(row_borders_.front());
}

std::pair<std::size_t, std::size_t> TrimRegion::pieces_between(double lower, double upper) const {
    if (pieces_.empty() || !(lower <= row_borders_.back() && upper >= row_borders_.front()))
        return {0, 0};
    const std::size_t first = row_of(lower), last = lower == upper ? first : row_of(upper);
    return {row_begin_[first], row_begin_[last + 1]};
}

std::size_t TrimRegion::row_of(double v) const {
    // The last border closes the last row instead of opening another.
    const auto begin = row_borders_.begin() + 1, end = row_borders_.end() - 1;
    return static_cast<std::size_t>(std::upper_bound(begin, end, v) - begin);
}

bool TrimRegion::contains(const Vec2& p) const {
    if (untrimmed()) return true;
    const auto [begin, end] = pieces_between(p.y, p.y);
    bool inside = false;
    for (std::size_t i = begin; i < end; ++i) {
        const MonotonePiece& piece = pieces_[row_pieces_[i]];
        if (!(p.x < piece.box().upper.x)) break;
        if (piece.crossed_from(p)) inside = !inside;
    }
    return inside;
}

std::vector<double> TrimRegion::crossings(unsigned axis, double at) const {
    std::vector<double> all;
    for (const MonotonePiece& piece : pieces_)
        for (const double place : piece.crossings(axis, at)) all.push_back(place);
    std::sort(all.begin(), all.end());
    return all;
}

double TrimRegion::most_off(const Box2& box, const Vec2& a, const Vec2& b,
                            const ParameterMetric& metric) const {
    const Stretch segment{0, 1, a, b};
    double most = 0;
    const auto [begin, end] = pieces_between(box.lower.y, box.upper.y);
    for (std::size_t i = begin; i < end; ++i) {
        const MonotonePiece& piece = pieces_[row_pieces_[i]];
        const auto inside = piece.stretch_in(box);
        if (!inside) continue;
        const auto [from, to] = *inside;
        const Stretch own{from, to, piece.point(from), piece.point(to)};
        // No place of the chord is farther from the segment than one of the chord's ends.
        most = std::max(most, std::max(chord_distance(own.at_a, segment, metric),
                                       chord_distance(own.at_b, segment, metric)) +
                                  most_off_chord(own, metric.across(piece.bend()), metric));
    }
    return most;
}

TrimSide TrimRegion::classify(const Box2& box) const {
    // Rounding of box and curves must not turn a near miss into a proof.
    const double away = std::max(box.lower.length(), box.upper.length());
    const Box2 grown = box.padded(1e-14 * (bounds_.size() + box.size()) + 4e-15 * away);
    const auto [begin, end] = pieces_between(grown.lower.y, grown.upper.y);
    for (std::size_t i = begin; i < end; ++i)
        if (pieces_[row_pieces_[i]].touches(grown)) return TrimSide::mixed;
    return contains(box.center()) ? TrimSide::inside : TrimSide::outside;
}

std::optional<TrimRegion::NearCurve> TrimRegion::nearest_curve(const Vec2& p,
                                                               const ParameterMetric& metric,
                                                               double radius) const {
    NearCurve best{radius};
    bool found = false;
    const double reach = radius / metric.least().y;
    const auto [begin, end] = pieces_between(p.y - reach, p.y + reach);
    for (std::size_t i = begin; i < end; ++i) {
        const MonotonePiece& piece = pieces_[row_pieces_[i]];
        if (metric.distance(p, piece.box()) <= best.distance)
            found |= approach(piece, p, metric, best);
    }
    return found ? std::optional(best) : std::nullopt;
}

std::optional<TrimRegion::NearEdge> TrimRegion::nearest_edge(
    const Vec2& p, const ParameterMetric& metric, double most,
    std::span<const std::uint32_t> among) const {
    std::optional<NearEdge> best;
    constexpr double room = 1 + 1e-9; // for rounding
    const Vec2 reach = Vec2(most * room) / metric.least();
    const Box2 around{p - reach, p + reach};
    const auto [begin, end] = pieces_between(around.lower.y, around.upper.y);
    for (std::size_t i = begin; i < end; ++i) {
        const MonotonePiece& piece = pieces_[row_pieces_[i]];
        if (!piece.box().overlaps(around)) continue;
        const PieceEdge& own = piece_edges_[row_pieces_[i]];
        const double radius = std::min(best ? best->at.distance : most, own.width);
        if (!(metric.distance(p, piece.box()) <= radius)) continue;
        if (!among.empty() && !std::binary_search(among.begin(), among.end(), own.edge)) continue;
        NearCurve near{radius};
        if (approach(piece, p, metric, near)) best = NearEdge{near, own.edge};
    }
    return best;
}

std::size_t TrimRegion::bytes() const {
    return pieces_.size() * (sizeof(MonotonePiece) + sizeof(PieceEdge)) +
           (edges_.size() + row_begin_.size() + row_pieces_.size()) * sizeof(std::uint32_t) +
           row_borders_.size() * sizeof(double);
}

bool TrimRegion::may_be_near_edge(const Box2& around) const {
    const auto [begin, end] = pieces_between(around.lower.y, around.upper.y);
    for (std::size_t i = begin; i < end; ++i)
        if (piece_edges_[row_pieces_[i]].width > 0 && pieces_[row_pieces_[i]].may_touch(around))
            return true;
    return false;
}

} // namespace keiko
