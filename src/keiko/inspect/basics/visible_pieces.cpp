#include "keiko/inspect/basics/visible_pieces.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double cut_width = 1e-9; ///< mm
constexpr int most_halvings = 60;
constexpr double most_tests = 10000; ///< between two points of a line
constexpr double border_tests = 16;  ///< of a step in which a border may be

double distance(const LinePoint& a, const LinePoint& b) {
    return (a.place - b.place).length();
}

class PieceCutter {
public:
    PieceCutter(const ZeroFunction& f, double step,
                const std::function<bool(const LinePoint&)>& visible,
                const std::function<bool(const Box2&)>& bordered)
        : f_(f), step_(step), visible_(visible), bordered_(bordered) {}

    /// Points of each piece, in the order along the line.
    std::vector<std::vector<LinePoint>> run(const std::vector<LinePoint>& points) {
        seen_ = visible_(points.front());
        if (seen_) pieces_.push_back({points.front()});
        for (std::size_t i = 1; i < points.size(); ++i) segment(points[i - 1], points[i]);
        return std::move(pieces_);
    }

private:
    void segment(const LinePoint& a, const LinePoint& b) {
        const double tests = std::clamp(std::ceil(distance(a, b) / step_), 1.0, most_tests);
        LinePoint last = a;
        for (double i = 1; i < tests; ++i)
            if (const auto next = f_.between(a, b, i / tests)) walk(last, *next);
        walk(last, b);
        if (seen_) append(b);
    }

    void walk(LinePoint& last, const LinePoint& next) {
        Box2 both;
        both.extend(last.uv), both.extend(next.uv);
        if (bordered_ && bordered_(both)) {
            const LinePoint from = last;
            for (double i = 1; i < border_tests; ++i)
                if (const auto between = f_.between(from, next, i / border_tests))
                    advance(last, *between);
        }
        advance(last, next);
    }

    void advance(LinePoint& last, const LinePoint& next) {
        check_stop();
        const bool seen = visible_(next);
        if (seen != seen_) {
            const LinePoint cut = seen ? seen_end(next, last) : seen_end(last, next);
            if (seen) pieces_.emplace_back();
            append(cut);
            seen_ = seen;
        }
        last = next;
    }

    LinePoint seen_end(LinePoint seen, LinePoint hidden) const {
        for (int i = 0; i < most_halvings && distance(seen, hidden) > cut_width; ++i) {
            const auto middle = f_.between(seen, hidden, 0.5);
            if (!middle) break;
            (visible_(*middle) ? seen : hidden) = *middle;
        }
        return seen;
    }

    void append(const LinePoint& point) {
        std::vector<LinePoint>& piece = pieces_.back();
        if (piece.empty() || distance(piece.back(), point) > 0) piece.push_back(point);
    }

    const ZeroFunction& f_;
    double step_;
    const std::function<bool(const LinePoint&)>& visible_;
    const std::function<bool(const Box2&)>& bordered_;
    bool seen_ = false;
    std::vector<std::vector<LinePoint>> pieces_;
};

/// Joins the last piece of a closed line to its first one if the line begins inside a piece.
void close_up(std::vector<std::vector<LinePoint>>& pieces, const PatchLine& line) {
    if (!line.closed || pieces.size() < 2) return;
    std::vector<LinePoint>&first = pieces.front(), &last = pieces.back();
    if (distance(first.front(), line.points.front()) > 0 ||
        distance(last.back(), line.points.back()) > 0)
        return;
    last.insert(last.end(), first.begin() + 1, first.end());
    first = std::move(last);
    pieces.pop_back();
}

} // namespace

std::vector<PatchLine> visible_pieces(const PatchLine& line, const ZeroFunction& f, double step,
                                      const std::function<bool(const LinePoint&)>& visible,
                                      const std::function<bool(const Box2&)>& bordered) {
    std::vector<std::vector<LinePoint>> pieces =
        PieceCutter(f, step, visible, bordered).run(line.points);
    close_up(pieces, line);
    std::vector<PatchLine> lines;
    for (std::vector<LinePoint>& points : pieces) {
        if (points.size() < 2) continue;
        const bool whole = pieces.size() == 1 &&
                           distance(points.front(), line.points.front()) == 0 &&
                           distance(points.back(), line.points.back()) == 0;
        lines.push_back(
            {line.level, line.closed && whole, line.proved, std::move(points), line.deviation});
    }
    return lines;
}

LinePoint FieldZeros::point(const Vec2& uv) const {
    return {uv, patch_.middle + evaluate(view_, uv, 0).position()};
}

BernsteinField iso_field(bool by_u, double at) {
    constexpr double inwards = 1e-10;
    const double inside = std::clamp(at, inwards, 1 - inwards);
    return {by_u ? 1 : 0, by_u ? 0 : 1, {-inside, 1 - inside}, 0};
}

std::vector<PatchLine> material_pieces(std::span<const LineCell> cells, const FieldZeros& zeros,
                                       double chord_error, double step,
                                       const std::function<bool(const LinePoint&)>& material) {
    std::vector<PatchLine> pieces;
    for (const PatchLine& line : lines_through(cells, zeros, chord_error))
        for (PatchLine& piece : visible_pieces(line, zeros, step, material))
            pieces.push_back(std::move(piece));
    return pieces;
}

} // namespace keiko
