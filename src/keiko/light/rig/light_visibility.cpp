#include "keiko/light/rig/light_visibility.h"

#include "keiko/light/areas/area_penumbra.h"
#include "keiko/light/sky/sky_irradiance.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/tubes/tube_irradiance.h"
#include "keiko/light/tubes/tube_penumbra.h"

#include <algorithm>

namespace keiko {
namespace {

/// Error allowed in the penumbrae of a source, as a share of its illuminance: half of the error of
/// the whole system.
constexpr double width_tolerance = 5e-5, width_tolerance_in_pictures = 3e-3;
/// Error allowed in the visible light of a panel of the sky, as a share of the light of all of it
/// past no body, and the largest of that in the panel's own light.
constexpr double sky_tolerance_in_pictures = 2.5e-3, panel_tolerance = 0.1;
/// Widest spacing between lines of equal visibility, as a share of half a source's width, by the
/// angle around a tube.
constexpr double widest_spacing = 0.12, widest_spacing_in_pictures = 1;

WidthOptions width_accuracy(bool in_picture) {
    if (!in_picture) return {width_tolerance, widest_spacing, true};
    return {width_tolerance_in_pictures, widest_spacing_in_pictures, false};
}

class Looker {
public:
    Looker(std::span<const int> asked, const Vec3& point, const Vec3& normal,
           const Visibility& visible, TubeModel model, bool axes)
        : asked_(asked),
          point_(point),
          normal_(normal),
          visible_(visible),
          model_(model),
          axes_(axes) {}

    std::vector<LightVisibility> operator()(const LampRow& row) const {
        std::vector<LightVisibility> seen(asked_.size(), LightVisibility{{}, 0, 0});
        std::vector<std::size_t> above;
        std::vector<TubeLamp> lamps;
        above.reserve(asked_.size()), lamps.reserve(asked_.size());
        for (std::size_t i = 0; i < asked_.size(); ++i) {
            lamps.push_back(lamp_of(row.frame, asked_[i], row.plane.luminance));
            if (below_horizon(lamps.back(), point_, normal_))
                lamps.pop_back();
            else
                above.push_back(i);
        }
        std::vector<LightVisibility> of_these =
            weighs_width(row.plane, model_) ? over_width(row, above, lamps) : along_axes(lamps);
        for (std::size_t k = 0; k < above.size(); ++k) seen[above[k]] = std::move(of_these[k]);
        return seen;
    }

    template <PointLight Light>
    std::vector<LightVisibility> operator()(const Light& light) const {
        const bool reaches = illuminance(light, point_, normal_) != Rgb();
        return {reaches ? seen_at(light.position) : LightVisibility{{}, 0, 0}};
    }

    std::vector<LightVisibility> operator()(const Sun& sun) const {
        const bool reaches = normal_.dot(sun.towards()) > 0 && sun.way_to(point_);
        return {reaches ? seen_at(sun.seen_from(point_)) : LightVisibility{{}, 0, 0}};
    }

    template <AreaLight Light>
    std::vector<LightVisibility> operator()(const Light& light) const {
        return {share_seen(
            visible_share(light, point_, normal_, visible_, area_accuracy(in_picture())))};
    }

    std::vector<LightVisibility> operator()(const SkyLight& sky) const {
        std::vector<LightVisibility> seen;
        seen.reserve(asked_.size());
        for (const int number : asked_) {
            const auto panel = sky_panel(sky, number, point_);
            seen.push_back(share_seen(panel ? visible_share(sky, *panel, point_, normal_, visible_,
                                                            sky_accuracy(sky, *panel))
                                            : 0));
        }
        return seen;
    }

    std::vector<LightVisibility> operator()(const LineLight& light) const {
        const auto view = view_of(light, point_);
        if (!view || !(unit_illuminance(*view, normal_) > 0)) return {{{}, 0, 0}};
        return {seen_along(queried_line(light, point_))};
    }

private:
    /// In pictures outlines between lines are not searched for: a quarter of the sky has all of a
    /// body's.
    WidthOptions sky_accuracy(const SkyLight& sky, const SkyPanel& panel) const {
        WidthOptions options = width_accuracy(in_picture());
        if (!in_picture()) return options;
        const double share = panel_share(sky, panel, point_, normal_);
        options.tolerance = std::min(sky_tolerance_in_pictures / share, panel_tolerance);
        options.tapers = true;
        return options;
    }
    static LightVisibility share_seen(double share) {
        return {share > 0 ? IntervalSet::whole() : IntervalSet(), share};
    }
    LightVisibility seen_at(const Vec3& place) const { return seen_along({place, place}); }
    LightVisibility seen_along(const Segment& segment) const {
        const IntervalSet seen = visible_.intervals(segment);
        return {seen, seen.empty() ? 0.0 : 1.0};
    }
    std::vector<LightVisibility> along_axes(std::span<const TubeLamp> lamps) const {
        std::vector<Segment> axes;
        axes.reserve(lamps.size());
        for (const TubeLamp& lamp : lamps) axes.push_back({lamp.a, lamp.b});
        std::vector<LightVisibility> seen;
        seen.reserve(lamps.size());
        for (IntervalSet& axis : visible_.intervals(axes)) {
            const double share = axis.empty() ? 0 : 1;
            seen.push_back({std::move(axis), share});
        }
        return seen;
    }
    std::vector<LightVisibility> over_width(const LampRow& row, std::span<const std::size_t> above,
                                            std::span<const TubeLamp> lamps) const {
        const TubeRowIrradiance comb(row.frame, point_, normal_, row.diffuse_model(model_));
        std::vector<std::vector<OccludingTube>> hiding;
        if (comb.overlapping())
            for (const std::size_t i : above) hiding.push_back(comb.hiding_tubes(asked_[i]));
        const WidthOptions accuracy = width_accuracy(in_picture());
        return seen_tubes(lamps, point_, normal_, visible_,
                          {.tolerance = accuracy.tolerance,
                           .axes = axes_,
                           .widest_spacing = accuracy.widest_spacing,
                           .between_lines = accuracy.between_lines},
                          hiding);
    }
    bool in_picture() const { return model_ != TubeModel::automatic; }

    std::span<const int> asked_; ///< numbers of lamps
    const Vec3 &point_, &normal_;
    const Visibility& visible_;
    TubeModel model_;
    bool axes_;
};

} // namespace

std::optional<LightVisibility> between(const LightVisibility& a, const LightVisibility& b,
                                       double at) {
    if (a.axis.size() != b.axis.size()) return std::nullopt;
    const auto mix = [&](double from, double to) { return from + (to - from) * at; };
    return LightVisibility{IntervalSet::between(a.axis, b.axis, at), mix(a.share, b.share),
                           mix(a.cap, b.cap)};
}

bool alike(const LightVisibility& a, const LightVisibility& b) {
    const auto same_ends = [](const ParameterInterval& i, const ParameterInterval& k) {
        return (i.begin > 0) == (k.begin > 0) && (i.end < 1) == (k.end < 1);
    };
    const auto same_part = [](double i, double k) {
        return (i > 0) == (k > 0) && (i < 1) == (k < 1);
    };
    return same_part(a.share, b.share) && same_part(a.cap, b.cap) &&
           std::equal(a.axis.begin(), a.axis.end(), b.axis.begin(), b.axis.end(), same_ends);
}

bool is_open_sky(const PreparedSource& source) {
    const auto* sky = std::get_if<SkyLight>(&source.kind());
    return sky && sky->windows.empty();
}

bool weighs_width(const CPlane& plane, TubeModel model) {
    const bool wide = model == TubeModel::automatic || model == TubeModel::picture;
    return wide && (plane.diffuse == TubeModel::automatic || plane.diffuse == model ||
                    plane.diffuse == TubeModel::strip || plane.diffuse == TubeModel::cylinder);
}

WidthOptions area_accuracy(bool in_picture) {
    WidthOptions options = width_accuracy(in_picture);
    options.between_lines = true; // a panel of metres may have a bar between any lines
    options.tapers = in_picture;  // towards its corners, and where the horizon cuts it
    return options;
}

std::vector<LightVisibility> light_visibilities(const PreparedSource& source,
                                                std::span<const int> lamps, const Vec3& point,
                                                const Vec3& normal, const Visibility& visible,
                                                TubeModel model, bool axes) {
    return std::visit(Looker(lamps, point, normal, visible, model, axes), source.kind());
}

} // namespace keiko
