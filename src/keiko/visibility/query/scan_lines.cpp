#include "keiko/visibility/boundaries/plane_cuts.h"
#include "keiko/visibility/query/occluder_candidates.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Scan lines between two places across.
template <class Lines>
auto between(const Lines& lines, double low, double high) {
    const auto first = std::partition_point(lines.begin(), lines.end(),
                                            [&](const auto& l) { return l.across < low; });
    const auto last =
        std::partition_point(first, lines.end(), [&](const auto& l) { return l.across <= high; });
    return std::span(first, last);
}

/// Finds the rest of a range between boxes, which are sorted.
void find_free(std::vector<ParameterInterval>& blocked, double low, double high,
               std::vector<ParameterInterval>& free) {
    free.clear();
    std::sort(blocked.begin(), blocked.end(),
              [](const auto& a, const auto& b) { return a.begin < b.begin; });
    for (const ParameterInterval& b : blocked) {
        if (b.begin > low) free.push_back({low, std::min(b.begin, high)});
        low = std::max(low, b.end);
        if (low >= high) return;
    }
    free.push_back({low, high});
}

} // namespace

const OccluderCandidates::Screen& OccluderCandidates::screen_of(const Vec3& along) const {
    if (screen_ && screen_->screen.is_along(along)) return *screen_;
    screen_.emplace(Screen{ScanPlane(viewpoint_, along, middle_), {}, {}, {}});
    if (!screen_->screen.regular()) return *screen_;
    screen_->pieces.reserve(silhouettes_.pieces.size());
    for (const SilhouetteCandidate& c : silhouettes_.pieces)
        screen_->pieces.push_back(
            screen_->screen.box(scene_->silhouettes.pieces[c.piece], c.edge_on));
    screen_->borders.reserve(borders_.size());
    for (const std::uint32_t border : borders_)
        screen_->borders.push_back(screen_->screen.box(scene_->borders[border]));
    return *screen_;
}

std::optional<std::vector<OccluderCandidates::ScanLine>> OccluderCandidates::scan_lines(
    const ScanPlane& screen, std::span<const Segment> row) const {
    if (!screen.regular()) return std::nullopt;
    std::vector<ScanLine> lines;
    lines.reserve(row.size());
    for (const Segment& ends : row) {
        if (!screen.is_along(ends.b - ends.a)) return std::nullopt;
        const ScreenPlace a = screen.place(ends.a), b = screen.place(ends.b);
        if (!(a.depth > 0 && b.depth > 0)) return std::nullopt;
        lines.push_back({lines.size(), a.across, a.along, b.along});
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const ScanLine& a, const ScanLine& b) { return a.across < b.across; });
    return lines;
}

void OccluderCandidates::scan(const Screen& screen, std::span<const ScanLine> scan_lines,
                              std::vector<Line>& lines) const {
    const auto each_crossed = [&](const ScanBounds& box, const auto& visit) {
        for (const ScanLine& l : between(scan_lines, box.across_low, box.across_high))
            if (box.along_low <= std::max(l.begin, l.end) &&
                box.along_high >= std::min(l.begin, l.end))
                visit(lines[l.line]);
    };
    for (std::size_t i = 0; i < screen.pieces.size(); ++i)
        each_crossed(screen.pieces[i], [&](Line& line) {
            line.certain =
                scene_->solver.find(silhouettes_.pieces[i], line.plane, line.wedge, line.events) &&
                line.certain;
        });
    for (std::size_t i = 0; i < screen.borders.size(); ++i)
        each_crossed(screen.borders[i], [&](Line& line) {
            find_border_events(scene_->borders[borders_[i]], scene_->silhouettes.regions,
                               line.plane, line.events);
        });
}

/// Two intervals of neighbouring lines are one where a way from one to the other along the screen
/// meets no candidate: nothing that can change what is seen lies there.
void OccluderCandidates::join_neighbours(const Screen& screen, std::span<const ScanLine> scan_lines,
                                         std::span<const std::size_t> first_interval,
                                         IntervalClasses& groups) const {
    const auto intervals_of = [&](const ScanLine& l, const auto& visit) {
        for (std::size_t g = first_interval[l.line]; g < first_interval[l.line + 1]; ++g) {
            const EventInterval& interval = groups.interval(g);
            const double step = l.end - l.begin;
            visit(g, l.begin + step * interval.begin, l.begin + step * interval.end);
        }
    };
    std::vector<ParameterInterval> blocked, free;
    for (std::size_t i = 0; i + 1 < scan_lines.size(); ++i) {
        const ScanLine &a = scan_lines[i], &b = scan_lines[i + 1];
        blocked.clear();
        for (const auto* boxes : {&screen.pieces, &screen.borders})
            for (const ScanBounds& box : *boxes)
                if (box.across_low <= b.across && box.across_high >= a.across && !box.empty())
                    blocked.push_back({box.along_low, box.along_high});
        const double low = std::max(a.begin, b.begin), high = std::min(a.end, b.end);
        if (!(low < high)) continue;
        const double least = 1e-9 * (high - low);
        find_free(blocked, low, high, free);
        for (const ParameterInterval& way : free)
            intervals_of(a, [&](std::size_t ga, double a0, double a1) {
                intervals_of(b, [&](std::size_t gb, double b0, double b1) {
                    const double from = std::max({a0, b0, way.begin});
                    if (std::min({a1, b1, way.end}) - from > least) groups.join(ga, gb);
                });
            });
    }
}

std::optional<std::vector<VisibleIntervals>> OccluderCandidates::intervals_of_row(
    std::span<const Segment> row) const {
    if (row.empty() || all_seen_) return std::nullopt;
    const Screen& screen = screen_of((row[0].b - row[0].a).normalized());
    const auto scan_lines = this->scan_lines(screen.screen, row);
    if (!scan_lines) return std::nullopt;
    std::vector<Line> lines;
    lines.reserve(row.size());
    for (const Segment& ends : row) {
        auto line = line_through(ends);
        if (!line) return std::nullopt;
        lines.push_back(std::move(*line));
    }
    scan(screen, *scan_lines, lines);

    IntervalClasses groups;
    std::vector<std::size_t> first_interval;
    first_interval.reserve(row.size() + 1);
    bool joinable = !region_touched_ && !has_horizon_;
    for (Line& line : lines) {
        add_own_events(line);
        first_interval.push_back(groups.add(line.plane, event_intervals(line.events, line.asked)));
        joinable = joinable && line.certain && !line.searches_own;
    }
    first_interval.push_back(groups.size());
    if (joinable) join_neighbours(screen, *scan_lines, first_interval, groups);
    groups.classify(*tracer_);
    std::vector<VisibleIntervals> parts;
    parts.reserve(row.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        parts.push_back({groups.seen(first_interval[i], first_interval[i + 1] - first_interval[i]),
                         lines[i].certain});
    return parts;
}

} // namespace keiko
