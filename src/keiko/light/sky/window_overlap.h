#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/fog/window_beam.h"

#include <span>
#include <vector>

namespace keiko {

/// Visibility past bodies of what a window shows of the sky, without the directions that other
/// windows show as well: so each direction counts once.
class WindowOverlap final : public Visibility {
public:
    /// Visibility of a window with some `corners`, beside `others`, from a point, mm; `bodies` is
    /// that without them. References to all but the corners are kept.
    WindowOverlap(const Visibility& bodies, std::span<const Vec3> corners,
                  std::span<const Window> others, const Vec3& point);

    IntervalSet intervals(const Segment& segment) const override;
    std::vector<IntervalSet> intervals(std::span<const Segment> segments) const override;
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const override;
    /// Turns of the bodies, and the corners of the other windows.
    std::vector<CriticalSlice> turns(const Prism& prism, const TurnRule& rule) const override;

private:
    IntervalSet beside(const Segment& segment, const IntervalSet& seen) const;

    const Visibility& bodies_;
    const Vec3& point_;
    std::vector<const Window*> others_; ///< that may overlap the window
};

} // namespace keiko
