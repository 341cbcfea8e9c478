#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/query/scan_plane.h"
#include "keiko/visibility/silhouettes/view_volume.h"

#include <vector>

namespace keiko {

/// Places across a prism at which outlines of its possible occluders turn, as a viewpoint sees it.
/// There they begin, end, run back or along the prism, or leave it by its ends. Between two
/// neighbouring places every outline runs on from one to the other: the hidden part of the lines
/// between them changes without a jump. Keeps references to its arguments.
class ContourExtrema {
public:
    /// `prism`: what the viewpoint sees of it; `volume`: between the viewpoint and it. The prism's
    /// ends are at `begin` and `end` along the screen.
    ContourExtrema(const Viewpoint& viewpoint, const ScanPlane& screen, const ScanBounds& prism,
                   const ViewVolume& volume, const ParameterInterval& ends, const TurnRule& rule);

    /// Adds a border or a crease that may be edge-on, all of it or a part.
    void add_border(const BoundaryPiece& border);
    /// Adds a line along which a smooth surface is seen edge-on.
    void add_fold(const BoundaryPiece& line);
    /// Adds something that may be anywhere in a box and cannot be followed.
    void add_unclear(const ScanBounds& box);

    /// True if the content of a box is so short that it matters less than the rule requires,
    /// together with all of that kind so far.
    bool leaves_out(const ScanBounds& box);
    /// Along by across, that a line may have which matters nowhere between its ends.
    double most_slope() const;

    /// Place across the prism at which an outline turns.
    struct Turn {
        double across; ///< the screen
        double missed; ///< as CriticalSlice
        int dark;      ///< likewise
        bool jump;     ///< likewise
    };
    /// Turns that matter by the rule.
    std::vector<Turn> found() const;

private:
    /// Widths and lengths of the prism below which two places are one.
    static constexpr double one_place = 1e-5, one_place_along = 1e-4;

    struct Part {
        BoundaryPiece::Curve curve;
        bool begins, ends; ///< where the whole piece does
    };
    /// Stretch of a line on the screen, in lengths and widths of the prism.
    struct Run {
        double a = 0, b = 0;             ///< across
        double from = 0, to = 0;         ///< along
        bool begins = true, ends = true; ///< within the prism's ends
        int dark = 0;                    ///< side across

        double slope() const { return (to - from) / (b - a); }
        /// Whether lines next to each other see it apart, as far as the way from end to end tells.
        bool steep() const;
        /// Whether one of them lies between the prism's sides.
        bool ends_inside() const { return (a > 0 && a < 1) || (b > 0 && b < 1); }
    };
    struct End {
        double across, along;
        int rise; ///< 1 where the run goes up from here, -1 where it goes down
        double slope, weight;
        bool whole; ///< of a piece, not of a part
        int dark;
        bool jump;
    };
    /// Image of a part on the screen, by its control points.
    struct Shown {
        ScanBounds box;
        Run run;
        bool before = true; ///< all before the viewpoint
        bool behind = true; ///< nothing before it
        /// By how much it may run back between its ends.
        double back_across = 0, back_along = 0;

        bool within_ends() const { return box.along_low > 0 && box.along_high < 1; }
    };

    void follow(const BoundaryPiece& line, const Part& part, bool fold, int most_halvings);
    Shown shown(const BoundaryPiece& line, const BoundaryPiece::Curve& curve) const;
    /// Whether a part runs on all along, across and along.
    bool is_even(const Shown& seen) const;
    /// True if the way by which it may run back matters less than the rule requires, together with
    /// all that is left out so far.
    bool is_nearly_even(const Shown& seen);
    double turn_of(const BoundaryPiece& line, const BoundaryPiece::Curve& curve,
                   const Shown& seen) const;
    ScreenPlace place(const Vec3& x) const;
    Run clipped(const BoundaryPiece& line, const BoundaryPiece::Curve& curve, Run run);
    void add_run(const Run& run, const Part& part);
    double where(const BoundaryPiece& line, const BoundaryPiece::Curve& curve, double along) const;
    double weight(const Run& run) const;
    double kink(double slope) const { return slope * spacing_ * spacing_ / 8; }
    void add(double across, double weight, int dark, bool jump);
    int dark_side(const BoundaryPiece& line, const BoundaryPiece::Curve& curve) const;
    std::vector<Turn> turning_ends() const;
    std::vector<Turn> all_turns() const;

    const Viewpoint& viewpoint_;
    const ScanPlane& screen_;
    const ViewVolume& volume_;
    ScanBounds prism_;
    double begin_, length_, width_;
    double spacing_, missed_; ///< of the rule
    double left_out_ = 0;
    std::vector<Turn> turns_;
    std::vector<End> ends_;
};

} // namespace keiko
