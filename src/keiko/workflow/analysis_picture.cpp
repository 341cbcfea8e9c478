#include "keiko/workflow/analysis_picture.h"

#include "keiko/base/units.h"
#include "keiko/film/overlay.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/inspect/basics/line_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace keiko {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double zebra_period = 10, isophote_period = 5; ///< degrees, a dark and a light band
/// Share of the body's picture that may exceed the scale of curvatures.
constexpr double beyond_scale = 0.02;

constexpr std::array<std::string_view, 7> names{"zebra",           "isophote",       "highlight",
                                                "curvature:gauss", "curvature:mean", "curvature:k1",
                                                "curvature:k2"};

/// Surface at a pixel's centre.
struct Seen {
    Vec3 place, ray, normal; ///< the normal towards the viewpoint
    bool turned = false;     ///< the layer's normal points away
    double facing() const { return -normal.dot(ray); }
};

class FilmSight {
public:
    FilmSight(const Film& film, const Camera& camera) : film_(film), camera_(camera) {}

    int width() const { return film_.color.width; }
    int height() const { return film_.color.height; }
    float face(int x, int y) const { return *film_.aovs.at(Aov::face).pixel(x, y); }
    float alpha(int x, int y) const { return *film_.alpha.pixel(x, y); }

    std::optional<Seen> at(int x, int y) const {
        const float* n = film_.aovs.at(Aov::normal).pixel(x, y);
        const double depth{*film_.aovs.at(Aov::depth).pixel(x, y)};
        const Vec3 normal(double{n[0]}, double{n[1]}, double{n[2]});
        if (!std::isfinite(depth) || !(normal.length() > 0)) return std::nullopt;
        const Ray ray = camera_.ray(x + 0.5, y + 0.5);
        const bool turned = normal.dot(ray.direction) > 0;
        return Seen{ray.origin + ray.direction * depth, ray.direction,
                    turned ? -normal.normalized() : normal.normalized(), turned};
    }

    /// Curvature viewed from the camera, positive in hollows.
    double curvature(AnalysisMode look, int x, int y) const {
        const auto seen = at(x, y);
        if (!seen) return none;
        const float* k = film_.aovs.at(Aov::curvature).pixel(x, y);
        const double sign = seen->turned ? -1 : 1;
        if (look == AnalysisMode::gauss) return double{k[3]};
        if (look == AnalysisMode::mean) return sign * double{k[2]};
        return sign * double{(look == AnalysisMode::k1) == seen->turned ? k[1] : k[0]};
    }

private:
    const Film& film_;
    const Camera& camera_;
};

/// One number a pixel; NaN without one.
template <class F>
std::vector<double> numbers(const FilmSight& sight, const F& of) {
    std::vector<double> values;
    for (int y = 0; y < sight.height(); ++y)
        for (int x = 0; x < sight.width(); ++x) values.push_back(of(x, y));
    return values;
}

double angle_to_vertical(const Vec3& direction) {
    return radians_to_degrees(
        std::atan2(std::hypot(direction.x, direction.y), direction.z)); // exact near the poles too
}

/// Phase in bands: bands of one kind have an integer part that is 2n.
double phase_of(AnalysisMode look, const Seen& seen, std::span<const LineField> planes) {
    if (look == AnalysisMode::zebra)
        return 2 * angle_to_vertical(seen.ray + seen.normal * (2 * seen.facing())) / zebra_period;
    if (look == AnalysisMode::isophote) return 2 * angle_to_vertical(seen.normal) / isophote_period;
    for (const LineField& plane : planes) {
        const LineField::Image image = plane.image(seen.place, seen.normal);
        const CPlaneFrame& frame = plane.plane();
        if (image.faces && frame.pitch > 0)
            return 2 * (image.value - frame.first) / frame.pitch + 0.5;
    }
    return none;
}

/// Share of light bands between two phases: the integral of a square wave.
double light_share(double from, double to) {
    const auto light_up_to = [](double phase) {
        const double whole = std::floor(phase / 2);
        return whole + std::clamp(phase - 2 * whole - 1, 0.0, 1.0);
    };
    return (light_up_to(to) - light_up_to(from)) / (to - from);
}

class Bands {
public:
    Bands(AnalysisMode look, const FilmSight& sight, std::span<const LineField> planes)
        : sight_(sight), phases_(numbers(sight, [&](int x, int y) {
              const auto seen = sight.at(x, y);
              return seen ? phase_of(look, *seen, planes) : none;
          })) {}

    /// Light from 0, dark, to 1; grey if there is no phase.
    double light(int x, int y) const {
        const double phase = at(x, y);
        if (std::isnan(phase)) return 0.5;
        const double sharpest = std::max(1e-6, 1e-12 * std::abs(phase));
        const double reach =
            std::max(sharpest, (std::abs(slope(x, y, 1, 0)) + std::abs(slope(x, y, 0, 1))) / 2);
        return light_share(phase - reach, phase + reach);
    }

private:
    double at(int x, int y) const {
        return phases_[static_cast<std::size_t>(y) * static_cast<std::size_t>(sight_.width()) +
                       static_cast<std::size_t>(x)];
    }
    bool same_face(int x, int y, int other_x, int other_y) const {
        return other_x >= 0 && other_y >= 0 && other_x < sight_.width() &&
               other_y < sight_.height() && sight_.face(x, y) == sight_.face(other_x, other_y) &&
               !std::isnan(at(other_x, other_y));
    }
    /// Change of the phase from a pixel to the next, the smaller one of either side: the other may
    /// be beyond a fold.
    double slope(int x, int y, int dx, int dy) const {
        double least = std::numeric_limits<double>::infinity();
        for (const int side : {-1, 1})
            if (same_face(x, y, x + side * dx, y + side * dy))
                least = std::min(least, std::abs(at(x + side * dx, y + side * dy) - at(x, y)));
        return std::isfinite(least) ? least : 0;
    }

    const FilmSight& sight_;
    std::vector<double> phases_;
};

std::string band_words(AnalysisMode look) {
    if (look == AnalysisMode::zebra) return "zebra: mirrored rings of 5 degrees about the vertical";
    if (look == AnalysisMode::isophote) return "isophotes: bands of 2.5 degrees from the vertical";
    return "highlight lines: normals that meet the lamps' plane, by pitch";
}

/// Lines of words, none wider than `width` if words can be broken there.
std::vector<std::string> wrapped(const std::string& words, double width) {
    std::vector<std::string> lines{""};
    std::istringstream in(words);
    for (std::string word; in >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || text_size(longer, 1).x <= width)
            lines.back() = longer;
        else
            lines.push_back(word);
    }
    return lines;
}

Image with_caption(Image picture, const std::string& words) {
    constexpr double margin = 8, line_height = 11;
    const std::vector<std::string> lines = wrapped(words, picture.width - 2 * margin);
    double y = picture.height - 3 - line_height * static_cast<double>(lines.size());
    Overlay overlay;
    for (const std::string& line : lines) {
        overlay.texts.push_back(
            {.at = Vec2(margin, y), .text = line, .color = Rgb(0.85), .scale = 1});
        y += line_height;
    }
    return with_overlay(std::move(picture), overlay);
}

Image banded(AnalysisMode look, const FilmSight& sight, std::span<const LineField> planes) {
    const Bands bands(look, sight, planes);
    Image picture(sight.width(), sight.height(), 3);
    for (int y = 0; y < sight.height(); ++y)
        for (int x = 0; x < sight.width(); ++x) {
            constexpr double backdrop = 0.07, dark = 0.06, light = 0.94;
            const auto seen = sight.at(x, y);
            const double shade = seen ? 0.55 + 0.45 * seen->facing() : 1;
            const double own =
                seen ? (dark + (light - dark) * bands.light(x, y)) * shade : backdrop;
            const double alpha = seen ? double{sight.alpha(x, y)} : 0;
            const double value = own * alpha + backdrop * (1 - alpha);
            std::fill_n(picture.pixel(x, y), 3, static_cast<float>(value));
        }
    return with_caption(std::move(picture), band_words(look));
}

/// The least value that all sizes except a share of them are below.
double usual_size(std::vector<double> values) {
    values.erase(
        std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }),
        values.end());
    if (values.empty()) return 0;
    for (double& value : values) value = std::abs(value);
    const auto at =
        values.begin() +
        static_cast<std::ptrdiff_t>((1 - beyond_scale) * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

std::vector<double> curvatures(AnalysisMode look, const FilmSight& sight) {
    return numbers(sight, [&](int x, int y) { return sight.curvature(look, x, y); });
}

Image colored(AnalysisMode look, const FilmSight& sight, double full) {
    const std::vector<double> values = curvatures(look, sight);
    Image shown(sight.width(), sight.height(), 1), facing(sight.width(), sight.height(), 1);
    std::transform(values.begin(), values.end(), shown.values.begin(),
                   [](double value) { return static_cast<float>(value); });
    for (int y = 0; y < sight.height(); ++y)
        for (int x = 0; x < sight.width(); ++x)
            if (const auto seen = sight.at(x, y))
                *facing.pixel(x, y) = static_cast<float>(seen->facing());
    return signed_color_picture(shown, facing, full,
                                look == AnalysisMode::gauss ? "1/mm2" : "1/mm");
}

} // namespace

std::string_view name_of(AnalysisMode look) {
    return names[static_cast<std::size_t>(look)];
}

const std::vector<AnalysisMode>& every_look() {
    static const std::vector<AnalysisMode> all{
        AnalysisMode::zebra, AnalysisMode::isophote, AnalysisMode::highlight, AnalysisMode::gauss,
        AnalysisMode::mean,  AnalysisMode::k1,       AnalysisMode::k2};
    return all;
}

bool is_curvature(AnalysisMode look) {
    return look >= AnalysisMode::gauss;
}

std::vector<Aov> look_layers() {
    return {Aov::normal, Aov::face, Aov::depth, Aov::curvature};
}

double usual_curvature(AnalysisMode look, const Film& film, const Camera& camera) {
    constexpr double flat = 1e-12;
    return round_scale(std::max(usual_size(curvatures(look, FilmSight(film, camera))), flat));
}

Image analysis_picture(AnalysisMode look, const Film& film, const Camera& camera,
                       const LightRig& rig, std::optional<double> full) {
    const FilmSight sight(film, camera);
    if (is_curvature(look))
        return colored(look, sight, full ? *full : usual_curvature(look, film, camera));
    std::vector<LineField> planes;
    for (const LightSource& source : rig.sources)
        if (const auto* plane = std::get_if<CPlane>(&source))
            planes.emplace_back(LineLook::highlight, LineEye(camera), *plane, Vec3(0));
    return banded(look, sight, planes);
}

} // namespace keiko
