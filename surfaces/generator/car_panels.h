#pragma once

#include "trim_tracer.h"

#include <string>

namespace keiko::fixtures {

/// A closed curve on a skin that parts a panel of its own, to the curve's left, from the rest.
struct PanelCurve {
    std::string name;
    TrimCurve curve;
};

/// Lamps and grilles, on the car's body.
std::vector<PanelCurve> car_body_panels(const Skin& body);

/// Glass and brake lamp, on its greenhouse.
std::vector<PanelCurve> car_windows(const Skin& greenhouse);

} // namespace keiko::fixtures
