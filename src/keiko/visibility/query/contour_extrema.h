#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/query/scan_plane.h"
#include "keiko/visibility/silhouettes/view_volume.h"

#include <vector>

namespace keiko {

/// Where across a prism, as a viewpoint sees it, outlines of what may hide some of it turn: where
/// they begin, end or run back, where they run along the prism, and where they leave it by its
/// ends. Between two neighbouring such places every outline runs on from one to the other, so that
/// what is hidden of the lines between them changes without a jump. Looks into what it is made of.
class ContourExtrema {
public:
    /// `prism`: what the viewpoint sees of it; `volume`: between the viewpoint and it. The prism's
    /// ends are at `begin` and `end` along the screen.
    ContourExtrema(const Viewpoint& viewpoint, const ScanPlane& screen, const ScanBounds& prism,
                   const ViewVolume& volume, const ParameterInterval& ends, const TurnRule& rule);

    /// A border or a crease that may be seen edge-on, of which some may not.
    void add_border(const BoundaryPiece& border);
    /// A line along which a smooth surface is seen edge-on.
    void add_fold(const BoundaryPiece& line);
    /// Something that may be anywhere in a box and cannot be followed.
    void add_unclear(const ScanBounds& box);

    /// Whether what runs in a box is so short that it matters less than the rule asks for, together
    /// with all of that kind so far.
    bool sub_patches_out(const ScanBounds& box);
    /// Along by across, that a line may have which matters nowhere between its ends.
    double most_slope() const;

    struct Turn {
        double across; ///< the screen
        double missed; ///< as CriticalSlice
        int dark;      ///< likewise
        bool jump;     ///< likewise
    };
    /// Those that matter.
    std::vector<Turn> found() const;

private:
    /// Of the prism's width and of its length: what is one place.
    static constexpr double one_place = 1e-5, one_place_along = 1e-4;

    struct Part {
        BoundaryPiece::Curve curve;
        bool begins, ends; ///< where the whole piece does
    };
    /// Of a line on the screen, in lengths and widths of the prism.
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
    /// What the screen shows of a part, by its control points.
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
    /// Whether what it may run back by matters less than the rule asks for, together with all that
    /// is left out so far.
    bool is_nearly_even(const Shown& seen);
    double turn_of(const BoundaryPiece& line, const BoundaryPiece::Curve& curve,
                   const Shown& seen) const;
    ScreenPlace place(const Vec3& x) const;
    Run clipped(const BoundaryPiece& line, const BoundaryPiece::Curve& curve, Run run);
    void add_run(const Run& run, const Part& part);
    double where(const BoundaryPiece& line, const BoundaryPiece::Curve& curve, double along) const;
    double weight(const Run& run) const;
    double kink(double slope) const { return slope * gap_ * gap_ / 8; }
    void add(double across, double weight, int dark, bool jump);
    int dark_side(const BoundaryPiece& line, const BoundaryPiece::Curve& curve) const;
    std::vector<Turn> turning_ends() const;
    std::vector<Turn> all_turns() const;

    const Viewpoint& viewpoint_;
    const ScanPlane& screen_;
    const ViewVolume& volume_;
    ScanBounds prism_;
    double begin_, length_, width_;
    double gap_, missed_; ///< of the rule
    double left_out_ = 0;
    std::vector<Turn> turns_;
    std::vector<End> ends_;
};

} // namespace keiko
