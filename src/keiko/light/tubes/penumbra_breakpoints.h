#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/tubes/width_samples.h"

#include <span>
#include <vector>

namespace keiko {

/// Places across a lamp's width where the visible part of its lines may jump or kink, and the part
/// that lines may miss of that.
class PenumbraBreakpoints {
public:
    /// `gap`: the one for which the turns were weighed, of the whole width.
    PenumbraBreakpoints(const LampWidth& width, std::span<const CriticalSlice> turns, double gap);

    /// Places, sorted. If both ends and the middle of each part between two of them agree, they
    /// miss at most `allowed` of the lamp together. Every jump of more than that is among them. If
    /// both ends and the middle of the whole `agree`, for which no cut may be needed, the threshold
    /// is four times as large.
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
    double gap_;
};

} // namespace keiko
