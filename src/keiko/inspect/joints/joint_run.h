#pragma once

#include "keiko/inspect/joints/joint_section.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace keiko {

/// A stretch of one border along which its panel faces one other body.
struct JointRun {
    std::size_t body = 0;               ///< of the border
    std::size_t other = 0;              ///< the body across, of a higher number
    std::vector<JointStation> stations; ///< at least one, by rising parameter
};

/// Sections along borders.
class JointRuns {
public:
    /// Keeps references to both.
    JointRuns(const PanelBorders& borders, const JointLimits& limits)
        : borders_(borders), limits_(limits) {}

    /// The runs of a border towards bodies of higher numbers. Their ends are exact to `end_error`
    /// where the section is lost.
    std::vector<JointRun> of(std::uint32_t border) const;
    /// The section at a parameter of a border towards one body; nullopt if there is none.
    std::optional<JointSection> section(std::uint32_t border, double t, std::size_t other) const;
    /// The last station between a good and a bad parameter of a border at which the section is
    /// `good`; nullopt if it is the good one itself.
    template <class Good>
    std::optional<JointStation> last_good(std::uint32_t border, double good, double bad,
                                          std::size_t other, const Good& is_good) const {
        std::optional<JointStation> last;
        const SurfaceCurve& curve = borders_.all()[border].curve;
        Vec3 place = curve.at(good).position;
        while ((curve.at(bad).position - place).length() > end_error) {
            const double t = (good + bad) / 2;
            if (t == good || t == bad) break;
            const auto found = section(border, t, other);
            if (found && is_good(*found)) {
                good = t, place = curve.at(t).position;
                last = JointStation{border, t, place, 0, found};
            } else {
                bad = t;
            }
        }
        return last;
    }

    static constexpr double end_error = 1e-7; ///< mm

private:
    std::vector<double> parameters(std::uint32_t border) const;
    void extend(JointRun& run, double before, double after) const;

    const PanelBorders& borders_;
    const JointLimits& limits_;
};

} // namespace keiko
