#pragma once

#include "keiko/film/film.h"
#include "keiko/inspect/lines/joined_lines.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/material.h"

#include "tests/support/defect_panel.h"

#include <array>
#include <vector>

namespace keiko::test {

enum class TrialLight {
    point,    ///< a bare lamp in the middle of the C-plane
    parallel, ///< light from that direction
    tubes     ///< twelve tubes on the C-plane, placed for the eye
};
constexpr std::array<TrialLight, 3> trial_lights{TrialLight::point, TrialLight::parallel,
                                                 TrialLight::tubes};
const char* name_of(TrialLight light);

/// How small a defect may be to be seen on a panel, by one eye under different lights.
class LightTrial {
public:
    /// Pictures are `height` pixels high and 3 : 2.
    LightTrial(Material paint, int height);

    Film picture(TrialLight light, Defect defect, double size) const;

    /// Number of a defect's nine places at which it is visible. There it changes the brightness of
    /// a display by 2 % on average over 5 x 5 pixels within 50 mm of the place. White is the
    /// brightest percent of the clean panel.
    int seen(TrialLight light, Defect defect, double size) const;

    /// Sizes from which on a defect is seen at one of its places, and at all nine of them; found
    /// to a factor of `step`, infinite where `most` does not do.
    struct Threshold {
        double somewhere, everywhere;
    };
    Threshold threshold(TrialLight light, Defect defect, double least, double most,
                        double step) const;

    /// Crossings of the seam by lines of the tubes, on a panel with a defect.
    std::vector<LineCrossing> crossings(Defect defect, double size) const;

private:
    Material paint_;
    Camera camera_;
    std::array<LightRig, 3> rigs_;
    std::array<Film, 3> clean_;
};

} // namespace keiko::test
