#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/tubes/width_samples.h"

#include <span>
#include <vector>

namespace keiko {

/// Where across a lamp's width what is seen of its lines may jump or bend, and what of that lines
/// may miss.
class PenumbraBreakpoints {
public:
    /// `gap`: that the turns were weighed for, of the whole width.
    PenumbraBreakpoints(const LampWidth& width, std::span<const CriticalSlice> turns, double gap);

    /// Places, sorted, such that both ends and the middle of each part between two, if they agree,
    /// miss no more than `allowed` of the lamp together. Every jump of more than that is among
    /// them, or of four times as much where both ends and the middle of the whole `agree`, for
    /// which none may be enough.
    std::vector<WidthCut> cuts(double allowed, bool agree) const;

private:
    struct Turn {
        double place, jump;
        int dark;
        bool at_once; ///< else only how fast changes
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
