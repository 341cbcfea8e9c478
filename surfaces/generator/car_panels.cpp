#include "car_panels.h"

#include "car_body.h"
#include "car_greenhouse.h"

#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

/// A rounded quadrilateral in skin parameters, in terms of -1 <= along <= 1 (u) and
/// -1 <= across <= 1 (v).
struct Opening {
    /// Middle and half sizes.
    double u;
    double v;
    double half_u;
    double half_v;
    /// How much narrower (share of half_v) it is towards growing u.
    double taper = 0.0;
    /// How much narrower it is at both u ends.
    double pinch = 0.0;
    /// How far its v ends are pushed towards growing u, its u ends towards growing v.
    double bow_u = 0.0;
    double bow_v = 0.0;
    /// How far v rises from the middle to the u end.
    double slant = 0.0;
};

/// tau runs counter-clockwise in (u, v) from the u end; an analytic curve, so that pieces of it
/// are fitted to rounding.
TrimPath opening_path(const Skin& skin, const Opening& o) {
    constexpr double kSquareness = 0.4;
    return [&skin, o](double tau, const TrimPoint&) {
        const double c = std::cos(tau);
        const double s = std::sin(tau);
        const double along = c * (1.0 + kSquareness * s * s);
        const double across = s * (1.0 + kSquareness * c * c);
        const double width = o.half_v * (1.0 - o.taper * along - o.pinch * along * along);
        const gp_XY uv(o.u + o.half_u * along + o.bow_u * across * across,
                       o.v + width * across + o.slant * along + o.bow_v * along * along);
        return TrimPoint{skin.evaluate(uv).position, {uv}};
    };
}

/// The opening's outline, in quarters so that no piece bends too far for its degree.
TrimCurve outline(const Skin& skin, const Opening& opening, int first_quarter, int quarters) {
    TrimCurve curve;
    for (int k = first_quarter; k < first_quarter + quarters; ++k) {
        const TrimCurve part = trace(opening_path(skin, opening), 0.5 * std::numbers::pi * k,
                                     0.5 * std::numbers::pi * (k + 1), {}, {&skin});
        curve.insert(curve.end(), part.begin(), part.end());
    }
    return curve;
}

PanelCurve middle_window(const Skin& greenhouse, const std::string& name, const Opening& opening) {
    return {name, with_mirror_image(outline(greenhouse, opening, 0, 2), {mirrored_on_greenhouse},
                                    {&greenhouse})};
}

/// The opening's middle lies on the nose (u = 0) or the tail.
PanelCurve middle_panel(const Skin& body, const std::string& name, const Opening& opening) {
    const int first_quarter = opening.u == 0.0 ? -1 : 1;
    return {name, with_mirror_image(outline(body, opening, first_quarter, 2), {mirrored_on_body},
                                    {&body})};
}

void add_pair(std::vector<PanelCurve>& panels, const Skin& skin, const std::string& name,
              const Opening& opening, gp_XY (*mirror)(gp_XY)) {
    const TrimCurve right = outline(skin, opening, 0, 4);
    panels.push_back({name + "-right", right});
    panels.push_back({name + "-left", mirrored(right, {mirror}, {&skin})});
}

} // namespace

std::vector<PanelCurve> car_windows(const Skin& greenhouse) {
    constexpr Opening kWindscreen{
        .u = 1.43, .v = 2.5, .half_u = 0.37, .half_v = 1.2, .bow_u = 0.16};
    constexpr Opening kBrakeLamp{.u = 4.53, .v = 2.5, .half_u = 0.045, .half_v = 0.4};
    constexpr Opening kBacklight{
        .u = 3.85, .v = 2.5, .half_u = 0.5, .half_v = 1.1, .taper = 0.12, .bow_u = -0.1};
    constexpr Opening kSide{.u = 2.72,
                            .v = 4.37,
                            .half_u = 0.92,
                            .half_v = 0.34,
                            .taper = -0.08,
                            .pinch = 0.45,
                            .bow_v = -0.14};
    std::vector<PanelCurve> panels{middle_window(greenhouse, "glass-windscreen", kWindscreen),
                                   middle_window(greenhouse, "lamp-brake", kBrakeLamp),
                                   middle_window(greenhouse, "glass-backlight", kBacklight)};
    add_pair(panels, greenhouse, "glass-side", kSide, mirrored_on_greenhouse);
    return panels;
}

std::vector<PanelCurve> car_body_panels(const Skin& body) {
    constexpr Opening kIntake{.u = 0.0, .v = 0.62, .half_u = 0.85, .half_v = 0.27, .pinch = 0.2};
    constexpr Opening kOutlet{.u = 11.0, .v = 0.5, .half_u = 0.8, .half_v = 0.22, .pinch = 0.2};
    constexpr Opening kHeadLamp{
        .u = 1.45, .v = 2.62, .half_u = 0.36, .half_v = 0.23, .slant = 0.08};
    constexpr Opening kTailLamp{.u = 9.5, .v = 2.55, .half_u = 0.42, .half_v = 0.2};
    std::vector<PanelCurve> panels{middle_panel(body, "grille-front", kIntake),
                                   middle_panel(body, "grille-rear", kOutlet)};
    add_pair(panels, body, "lamp-head", kHeadLamp, mirrored_on_body);
    add_pair(panels, body, "lamp-tail", kTailLamp, mirrored_on_body);
    return panels;
}

} // namespace keiko::fixtures
