#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/penumbra/source_width.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A slice of a source through one line along it: solid angle by its wedge angle, and the hidden
/// part of it.
struct Slice {
    double all = 0;    ///< without occlusion, sr per radian of the wedge angle
    double hidden = 0; ///< of all, in its unit

    /// Hidden share, 0 to 1; undefined for a slice without light.
    double share() const { return hidden / all; }
};

/// Slices of a part of a source's width, at the nodes of nested rules: Gauss's of 1 and 3 and
/// Kronrod's of 7. They include both ends, which have no weight, but show what lies beyond the last
/// node.
struct Slices {
    static constexpr std::size_t count = 9;                        ///< nodes, by rising place
    static constexpr std::size_t first = 0;                        ///< node at the begin
    static constexpr std::size_t middle = 4;                       ///< node at the center
    static constexpr std::size_t last = 8;                         ///< node at the end
    static constexpr std::array<std::size_t, 2> ends{first, last}; ///< nodes at the ends
    static constexpr std::array<std::size_t, 3> ends_and_middle{first, middle,
                                                                last}; ///< nodes of `seen`

    double center = 0, half = 1;       ///< of the width, -1 to 1
    std::array<SubAxis, count> axes{}; ///< line of each node, once its light is computed
    std::array<Slice, count> at{};     ///< slice of each node
    /// Visible parts of the lines of the ends and the middle, if known.
    std::array<std::optional<IntervalSet>, 3> seen{};
    bool begins_where_last_ends = false; ///< of several parts
    /// Deviation of the middle's visible parts from lines from end to end, as a share of the light,
    /// as far as it is known.
    double parts_off = 0;

    /// Place at which the part begins, from -1.
    double begin() const { return center - half; }
    /// Place at which the part ends, up to 1.
    double end() const { return center + half; }
    /// The largest light of any slice.
    double brightest() const;
};

/// A place across a width, or a narrow part of it that is left out, where the visible part turns.
struct WidthCut {
    double begin, end; ///< places from -1 to 1, begin <= end
    bool jump;         ///< the visible part may jump there: lines are needed on both sides
};

/// The parts of a width between its own cuts and others, before any query. They end and begin just
/// beside the others, since the visible part on those is undefined. `tapers`: see SliceRule.
std::vector<Slices> parts_of(const SourceWidth& width, std::span<const WidthCut> cuts = {},
                             bool tapers = false);

/// Sets the hidden part of a node's slice by the visible part of its line.
void hide_slice(const SourceWidth& width, std::size_t node, const IntervalSet& seen,
                Slices& slices);

/// Solid angle of a source, or of a part of it.
struct SolidAngle {
    double all = 0;    ///< projected solid angle without occlusion, sr
    double hidden = 0; ///< hidden part of it, sr

    /// Adds the solid angle of another part.
    SolidAngle& operator+=(const SolidAngle& other) {
        all += other.all, hidden += other.hidden;
        return *this;
    }
    /// Visible share, 0 to 1; 1 if there is nothing to be hidden.
    double visible_share() const { return all > 0 ? std::clamp(1 - hidden / all, 0.0, 1.0) : 1; }
};

/// Termination criterion of the integration.
struct SliceRule {
    double error = 0;          ///< of what is hidden, absolute
    double widest_spacing = 1; ///< between nodes, of half the width
    bool part_by_part = false; ///< visible parts must each change uniformly
    /// Halvings after which the finest rule is taken as it is, unless nodes are farther apart than
    /// the widest spacing.
    int most_halvings = 0;
    /// True if ends with less than 1e-6 of the middle's light, where the source tapers, are left
    /// out. The other nodes then decide.
    bool tapers = false;
};

/// True if the ends and the middle of a part suffice to determine its hidden part, by their own
/// estimate.
bool ends_and_middle_agree(const Slices& slices, const SliceRule& until);

/// Integral over the part of `slices`, whose ends and middle are known. It uses more nodes, then
/// halves, until nodes are near enough and two rules agree on the hidden part, and the ends agree
/// with the nodes next to them.
SolidAngle integrate(const SourceWidth& width, const Visibility& visible, Slices slices,
                     const SliceRule& until);

/// Appends the lines of the ends and the middles of parts that must be queried: those of slices
/// that light anything and whose visible part is unknown.
void add_ends_and_middles(const SourceWidth& width, std::span<const Slices> parts,
                          std::vector<Segment>& lines);
/// Sets the hidden parts by the visible parts of those lines, from `next` on; of each visible part
/// by itself if `part_by_part`.
void hide_ends_and_middles(const SourceWidth& width, bool part_by_part, std::span<Slices> parts,
                           std::vector<IntervalSet>::const_iterator& next);

/// Places across a source's width where the visible part of its lines may jump or kink, and the
/// part that lines may miss of that.
class PenumbraBreakpoints {
public:
    /// `spacing`: the one for which the turns were weighed, of the whole width.
    PenumbraBreakpoints(const SourceWidth& width, std::span<const CriticalSlice> turns,
                        double spacing);

    /// Places, sorted. If both ends and the middle of each part between two of them agree, they
    /// miss at most `allowed` of the source together. Every jump of more than that is among them.
    /// If both ends and the middle of the whole `agree`, for which no cut may be needed, the
    /// threshold is four times as large.
    std::vector<WidthCut> cuts(double allowed, bool agree) const;

private:
    struct Turn {
        double place, jump;
        int dark;
        bool at_once; ///< else only the rate of change changes
    };
    /// Turns between two neighbouring lines.
    struct Cell {
        std::span<const Turn> turns;
        double missed = 0;
    };
    double missed(std::span<const double> cuts) const;
    std::vector<Cell> cells(std::span<const double> cuts) const;
    std::vector<double> places(double allowed, bool agree) const;
    bool jumps_at(double place) const;

    std::vector<Turn> turns_;
    double spacing_;
};

} // namespace keiko
