#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/tubes/lamp_width.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A slice of a lamp through one line along it: solid angle by its wedge angle, and what of it is
/// hidden.
struct Slice {
    double all = 0, hidden = 0;

    double share() const { return hidden / all; }
};

/// Slices of a part of a lamp's width, at the nodes of Gauss's rules of 1 and 3 and of Kronrod's of
/// 7, each of which holds those before it, and at both ends, which weigh nothing, but tell what
/// lies beyond the last node.
struct Slices {
    static constexpr std::size_t count = 9, first = 0, middle = 4, last = 8;
    static constexpr std::array<std::size_t, 2> ends{first, last};
    static constexpr std::array<std::size_t, 3> ends_and_middle{first, middle, last};

    double center = 0, half = 1; ///< of the width, -1 to 1
    std::array<SubAxis, count> axes{};
    std::array<Slice, count> at{};
    /// What is seen of the lines of the ends and the middle, where it is known.
    std::array<std::optional<IntervalSet>, 3> seen{};
    bool begins_where_last_ends = false; ///< of several parts
    /// Of the light: by how much the middle's seen parts are known to be off lines from end to end.
    double parts_off = 0;

    double begin() const { return center - half; }
    double end() const { return center + half; }
    /// The most light of any.
    double brightest() const;
};

/// A place across a width, or a narrow part of it that is left out, where what is seen turns.
struct WidthCut {
    double begin, end;
    bool jump; ///< what is seen may change at once there: lines are to see it from both sides
};

/// The parts of a width between its own cuts and others, of which nothing is asked yet. They end
/// and begin just beside these others, as what is seen on them is not told.
std::vector<Slices> parts_of(const LampWidth& width, std::span<const WidthCut> cuts = {});

/// With what is seen of the line at a node.
void hide_slice(const LampWidth& width, std::size_t node, const IntervalSet& seen, Slices& slices);

/// Solid angle of a lamp, or of a part of it.
struct SolidAngle {
    double all = 0, hidden = 0;

    SolidAngle& operator+=(const SolidAngle& other) {
        all += other.all, hidden += other.hidden;
        return *this;
    }
    double visible_share() const { return all > 0 ? std::clamp(1 - hidden / all, 0.0, 1.0) : 1; }
};

/// When to be content.
struct SliceRule {
    double error = 0;          ///< of what is hidden, absolute
    double widest_gap = 1;     ///< between nodes, of half the width
    bool part_by_part = false; ///< seen parts are each to change evenly
    int most_halvings = 0;
};

/// Whether the ends and the middle of a part are enough to tell what is hidden of it, as far as
/// they know.
bool ends_and_middle_agree(const Slices& slices, const SliceRule& until);

/// Over the part that `slices` stand for, of which the ends and the middle are known: by more
/// nodes, then by halves, until nodes are near enough and two rules agree on what is hidden, and
/// the ends with the nodes next to them.
SolidAngle integrate(const LampWidth& width, const Visibility& visible, Slices slices,
                     const SliceRule& until);

/// Appends the lines of the ends and the middles of parts to be asked for: of slices that light
/// anything and of which it is not known what is seen.
void add_ends_and_middles(const LampWidth& width, std::span<const Slices> parts,
                          std::vector<Segment>& lines);
/// With what is seen of those lines, from `next` on, of each part that is seen by itself if
/// `part_by_part`.
void hide_ends_and_middles(const LampWidth& width, bool part_by_part, std::span<Slices> parts,
                           std::vector<IntervalSet>::const_iterator& next);

} // namespace keiko
