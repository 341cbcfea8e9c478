#include "keiko/compare/line_shift.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bvh/box_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace keiko {
namespace {

using Lamp = std::pair<std::uint32_t, std::uint32_t>; ///< plane, lamp

/// The chords of all lines of a lamp.
class LampChords {
public:
    void add(const Vec3& from, const Vec3& to) { chords_.emplace_back(from, to); }
    void finish() {
        std::vector<Box3> boxes;
        for (const auto& [from, to] : chords_) {
            Box3 box;
            box.extend(from), box.extend(to);
            boxes.push_back(box);
        }
        tree_.emplace(std::move(boxes));
    }
    /// The way to the nearest point, if it is within `reach`.
    std::optional<Vec3> way_to(const Vec3& p, double reach) const {
        std::optional<Vec3> best;
        tree_->visit_near(p, reach, [&](std::uint32_t i) {
            const auto& [from, to] = chords_[i];
            const Vec3 chord = to - from;
            const double square = chord.length2();
            const double share =
                square > 0 ? std::clamp((p - from).dot(chord) / square, 0.0, 1.0) : 0.0;
            const Vec3 way = from + chord * share - p;
            if (way.length() < reach) reach = way.length(), best = way;
            return reach;
        });
        return best;
    }

private:
    std::vector<std::pair<Vec3, Vec3>> chords_;
    std::optional<BoxTree> tree_;
};

std::map<Lamp, LampChords> chords_of(const JoinedLines& lines) {
    std::map<Lamp, LampChords> lamps;
    for (const SurfaceLine& piece : lines.pieces) {
        const std::vector<LinePoint>& points = piece.line.points;
        LampChords& chords = lamps[{piece.plane, piece.lamp}];
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            chords.add(points[i].place, points[i + 1].place);
    }
    for (auto& [lamp, chords] : lamps) chords.finish();
    return lamps;
}

/// Adds up what the places of a line tell.
class ShiftSum {
public:
    ShiftSum(const LampChords* others, const LineShiftOptions& options)
        : others_(others), options_(options) {}

    void add_chord(const Vec3& from, const Vec3& to) {
        const Vec3 chord = to - from;
        const double length = chord.length();
        if (!(length > 0)) return;
        const int parts = std::max(1, static_cast<int>(std::ceil(length / options_.step)));
        for (int i = 0; i < parts; ++i)
            add(from + chord * ((i + 0.5) / parts), chord / length, length / parts);
    }
    LineShift result() const {
        LineShift shift = shift_;
        if (beside_ > 0) shift.mean = sum_ / beside_;
        return shift;
    }

private:
    void add(const Vec3& place, const Vec3& along, double length) {
        shift_.length += length;
        const auto way = others_ ? others_->way_to(place, options_.reach) : std::nullopt;
        constexpr double ahead = 0.7; // cosine of 45 degrees
        if (!way ||
            (way->length() > options_.noise && std::abs(way->dot(along)) > ahead * way->length())) {
            shift_.alone += length;
            return;
        }
        const double distance = way->length();
        sum_ += distance * length, beside_ += length;
        if (distance > shift_.largest) shift_.largest = distance, shift_.place = place;
    }

    const LampChords* others_;
    const LineShiftOptions& options_;
    LineShift shift_;
    double sum_ = 0, beside_ = 0;
};

} // namespace

std::vector<LineShift> line_shifts(const JoinedLines& lines, const JoinedLines& others,
                                   const LineShiftOptions& options, const Job& job) {
    const std::map<Lamp, LampChords> lamps = chords_of(others);
    std::vector<LineShift> shifts(lines.lines.size());
    parallel_for(shifts.size(), job, "line shifts", [&](std::size_t i) {
        const JoinedLine& line = lines.lines[i];
        const auto found = lamps.find({line.plane, line.lamp});
        ShiftSum sum(found == lamps.end() ? nullptr : &found->second, options);
        for (const std::uint32_t piece : line.pieces) {
            const std::vector<LinePoint>& points = lines.pieces[piece].line.points;
            for (std::size_t k = 0; k + 1 < points.size(); ++k)
                sum.add_chord(points[k].place, points[k + 1].place);
        }
        shifts[i] = sum.result();
        shifts[i].plane = line.plane, shifts[i].lamp = line.lamp;
    });
    return shifts;
}

} // namespace keiko
