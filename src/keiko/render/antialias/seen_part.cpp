#include "keiko/render/antialias/seen_part.h"

#include "keiko/render/antialias/most_bending.h"
#include "keiko/render/antialias/outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Of its span: how far the image of a pixel on the lamps' plane may be off a parallelogram, where
/// luminances differ by no more than what is seen amid it.
constexpr double most_bend = 0.03;
/// Of the larger: by how much the cosines of a pixel may differ.
constexpr double most_turn = 0.3;
/// Sine of an angle by which the normal may turn: lamps fit in between.
constexpr double most_rotation = 0.17;

/// Of the larger luminance: how far the middle of a pixel may be off the mean of its corners where
/// what it mirrors, the body itself, has no place on the lamps' plane that would tell more.
constexpr double most_glare = 0.05;

struct Range {
    double least, most;

    explicit Range(double x) : least(x), most(x) {}
    void add(double x) { least = std::min(least, x), most = std::max(most, x); }
    double span() const { return most - least; }
};

} // namespace

bool SeenPart::shows(const EyeSample& amid) const {
    return std::any_of(seen.begin(), seen.end(),
                       [&](const EyeSample* corner) { return !differ_closely(*corner, amid); });
}

bool SeenPart::is_outshone_by(const EyeSample& amid) const {
    Range shown(luminance(seen[0]->luminance));
    for (const EyeSample* sample : seen) shown.add(luminance(sample->luminance));
    const double own = luminance(amid.luminance), slack = 0.1 * shown.most;
    return own < shown.least - slack || own > shown.most + slack;
}

double SeenPart::turn(const EyeSample& amid) const {
    Range cosine(amid.cosine), sine(0);
    for (const EyeSample* sample : seen) {
        cosine.add(sample->cosine);
        if (sample->hit) sine.add(sample->hit->normal.cross(amid.hit->normal).length());
    }
    return std::max(cosine.span() / (most_turn * cosine.most), sine.most / most_rotation);
}

double SeenPart::bend(const EyeSample& amid) const {
    Range across(amid.across_lamps), light(luminance(amid.luminance));
    ShortList<double, most_corners> places;
    for (const EyeSample* sample : seen) {
        across.add(sample->across_lamps);
        light.add(luminance(sample->luminance));
        places.push_back(sample->across_lamps);
    }
    if (across.span() == 0) return 0;
    // What the eye sees of an error counts against what is there.
    const double contrast = std::max(1.0, light.span() / std::max(luminance(amid.luminance), 1e-9));
    return std::abs(polygon_mean(corners, places) - amid.across_lamps) * contrast /
           (most_bend * across.span());
}

double SeenPart::glare(const EyeSample& amid) const {
    ShortList<double, most_corners> lights;
    for (const EyeSample* sample : seen) lights.push_back(luminance(sample->luminance));
    const double mean = polygon_mean(corners, lights), own = luminance(amid.luminance);
    return std::abs(mean - own) / (most_glare * std::max({mean, own, 1e-9}));
}

double SeenPart::unevenness(const EyeSample& amid) const {
    const auto beyond_horizon = [&](const EyeSample* sample) {
        return sample->c_plane.has_value() != amid.c_plane.has_value();
    };
    if (!amid.hit) return 0;
    if (is_outshone_by(amid) || std::any_of(seen.begin(), seen.end(), beyond_horizon))
        return std::numeric_limits<double>::infinity();
    const double size = std::sqrt(whole().area), turned = turn(amid) * size;
    return std::max(turned * turned, size * (amid.c_plane ? bend(amid) : glare(amid)));
}

std::vector<PicturePart> SeenPart::strips(const EyeSample& amid, double uneven,
                                          double narrowest) const {
    const auto shows_surface = [](const EyeSample* sample) { return sample->hit != nullptr; };
    if (!amid.hit || !std::all_of(seen.begin(), seen.end(), shows_surface)) return {};
    const Vec2 across = most_bending(corners, seen, amid);
    if (across == Vec2(0)) return {};
    Range range(across.dot(corners[0]));
    for (const Vec2& corner : corners) range.add(across.dot(corner));
    const double most = std::max(2.0, std::ceil(range.span() / narrowest));
    constexpr double spare = 3; // the bend is not the same all over
    const double n = std::min(most, std::ceil(std::sqrt(uneven)) + spare);
    const double step = range.span() / n;
    std::vector<PicturePart> parts;
    for (double i = 0; i < n; ++i) {
        const double end = i + 1 < n ? range.least + (i + 1) * step : range.most;
        const Polygon strip = strip_of(corners, across, range.least + i * step, end);
        if (strip.size() < 3) continue;
        const PicturePart part = polygon_part(strip);
        if (part.area > 0) parts.push_back(part);
    }
    return parts;
}

} // namespace keiko
