#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/report/content/profiles_text.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace keiko {
namespace {

/// Units of the picture: its width, the edges beside the plots, and the parts of a plot.
constexpr double width = 760, left = 68, right = 12, head = 18, plot_height = 56, space = 8;
constexpr double foot = 18;         ///< below the last plot, for the lengths
constexpr double indistinct = 0.3;  ///< units: nearer points are left out
constexpr double least_shade = 1.5; ///< units: the narrowest shade that is visible

using Value = std::optional<double> (*)(const ProfileSample&);

/// A curve of a plot.
struct Curve {
    const char* style; ///< class of its path
    Value value;
};

/// One plot: its texts, curves and limit.
struct Plot {
    std::string title, note;
    std::vector<Curve> curves;
    std::optional<double> limit;
    double scale = 1;      ///< that values are printed by
    bool from_zero = true; ///< else the values' own range
};

struct Range {
    double low = 0, high = 0;
};

/// The values that a plot shows. Curvatures are not spread further than a tenth of their size: what
/// is less is no wave but the rounding of a constant.
Range range_of(const Plot& plot, const SeamProfile& profile) {
    constexpr double least_spread = 0.1, above = 1.08;
    Range range{HUGE_VAL, -HUGE_VAL};
    for (const ProfileSample& sample : profile.samples)
        for (const Curve& curve : plot.curves)
            if (const auto value = curve.value(sample))
                range = {std::min(range.low, *value), std::max(range.high, *value)};
    if (!(range.low <= range.high)) return {0, 1};
    if (plot.from_zero) {
        const double most = std::max(range.high, plot.limit.value_or(0));
        return {0, most > 0 ? above * most : 1};
    }
    const double size = std::max({std::abs(range.low), std::abs(range.high), 1e-9});
    const double more = std::max(0.0, least_spread * size - (range.high - range.low)) / 2;
    const double edge = (above - 1) * (range.high - range.low);
    return {range.low - more - edge, range.high + more + edge};
}

class ProfileDrawing {
public:
    explicit ProfileDrawing(const SeamProfile& profile) : profile_(profile) { body_.precision(5); }

    void add(const Plot& plot) {
        const Range range = range_of(plot, profile_);
        if (plot.limit) shade(plot.curves.front().value, *plot.limit);
        body_ << "<path class=\"axis\" d=\"M" << left << ' ' << top_ + head << "v" << plot_height
              << "H" << width - right << "\"/>";
        if (plot.limit && *plot.limit < range.high)
            body_ << "<path class=\"limit\" d=\"M" << left << ' ' << y(*plot.limit, range) << "H"
                  << width - right << "\"/>";
        for (const Curve& curve : plot.curves) draw(curve, range);
        text(left, top_ + head - 5, "start", plot.title);
        text(width - right, top_ + head - 5, "end", plot.note);
        text(left - 6, top_ + head + 9, "end", short_number(range.high * plot.scale));
        text(left - 6, top_ + head + plot_height, "end", short_number(range.low * plot.scale));
        body_ << '\n';
        top_ += head + plot_height + space;
    }

    std::string svg() {
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
            text(left + share * (width - left - right), top_ + 8,
                 share == 0   ? "start"
                 : share == 1 ? "end"
                              : "middle",
                 fixed_number(share * profile_.length, 1) + (share == 1 ? " mm" : ""));
        std::ostringstream out;
        out << "<svg class=\"profile\" role=\"img\" aria-label=\"profile along the seam\" "
               "viewBox=\"0 0 "
            << width << ' ' << top_ + foot << "\">\n"
            << body_.str() << "\n</svg>\n";
        return out.str();
    }

private:
    double x(double along) const {
        return left + (width - left - right) * (profile_.length > 0 ? along / profile_.length : 0);
    }
    double y(double value, const Range& range) const {
        return top_ + head + plot_height * (range.high - value) / (range.high - range.low);
    }

    void draw(const Curve& curve, const Range& range);
    void shade(Value value, double limit);
    void shade(double from, double to);
    void text(double at_x, double at_y, const char* anchor, const std::string& words) {
        body_ << "<text x=\"" << at_x << "\" y=\"" << at_y << "\" text-anchor=\"" << anchor << "\">"
              << html_escaped(words) << "</text>";
    }

    const SeamProfile& profile_;
    std::ostringstream body_;
    double top_ = 0;
};

/// A curve breaks where a value is missing.
void ProfileDrawing::draw(const Curve& curve, const Range& range) {
    body_ << "<path class=\"" << curve.style << "\" d=\"";
    std::optional<Vec2> before;
    for (const ProfileSample& sample : profile_.samples) {
        const auto value = curve.value(sample);
        const Vec2 at = value ? Vec2(x(sample.along), y(*value, range)) : Vec2(0);
        if (value && before && (at - *before).length() < indistinct) continue;
        if (value) body_ << (before ? 'L' : 'M') << at.x << ' ' << at.y;
        before = value ? std::optional(at) : std::nullopt;
    }
    body_ << "\"/>";
}

/// Shades where a value exceeds the limit, by straight lines between samples as its share is
/// computed.
void ProfileDrawing::shade(Value value, double limit) {
    std::optional<double> from, to; // mm, of the run that is being collected
    for (std::size_t i = 1; i < profile_.samples.size(); ++i) {
        const ProfileSample &a = profile_.samples[i - 1], &b = profile_.samples[i];
        const auto p = value(a), q = value(b);
        if (a.piece != b.piece || !p || !q || std::max(*p, *q) <= limit) continue;
        const double cut = *p == *q ? 0 : (limit - *p) / (*q - *p);
        const double begin = *p > limit ? a.along : a.along + cut * (b.along - a.along);
        const double end = *q > limit ? b.along : a.along + cut * (b.along - a.along);
        if (to && begin > *to) shade(*from, *to), from.reset();
        if (!from) from = begin;
        to = end;
    }
    if (from) shade(*from, *to);
}

void ProfileDrawing::shade(double from, double to) {
    const double wide = std::max(least_shade, x(to) - x(from));
    body_ << "<rect class=\"beyond\" x=\"" << std::min(x(from), width - right - wide) << "\" y=\""
          << top_ + head << "\" width=\"" << wide << "\" height=\"" << plot_height << "\"/>";
}

/// "largest 0.04 mm · limit 0.01 mm · 37 % of the length beyond · not judged"
std::string note_of(const ProfileQuantity& quantity, const std::string& unit, double scale) {
    std::string note = "largest " + short_number(quantity.largest * scale) + unit;
    if (!quantity.limit) return note + " · no limit here";
    note += " · limit " + short_number(*quantity.limit * scale) + unit + " · " +
            fixed_number(quantity.beyond.value * 100, 1) + " % of the length beyond";
    return quantity.judged ? note : note + " · not judged";
}

Plot plot_of(const ProfileQuantity& quantity, const std::string& name, const std::string& unit,
             double scale, Value value) {
    return {name, note_of(quantity, unit, scale), {{"value", value}}, quantity.limit, scale};
}

Plot curvatures_plot() {
    const auto of_a = [](const ProfileSample& s) {
        return s.point.angle ? std::optional(s.point.curvature_a) : std::nullopt;
    };
    const auto of_b = [](const ProfileSample& s) {
        return s.point.angle ? std::optional(s.point.curvature_b) : std::nullopt;
    };
    return {.title = "curvature across the seam, 1/m",
            .note = "first side solid, second dashed",
            .curves = {{"value a", of_a}, {"value b", of_b}},
            .limit = std::nullopt,
            .scale = 1000,
            .from_zero = false};
}

} // namespace

std::string profile_svg(const SeamProfile& profile, CurvatureFormula formula) {
    ProfileDrawing drawing(profile);
    if (profile.gap)
        drawing.add(plot_of(*profile.gap, "gap, mm", " mm", 1,
                            [](const ProfileSample& s) { return std::optional(s.point.gap); }));
    if (profile.angle)
        drawing.add(plot_of(*profile.angle, "angle, °", "°", 1,
                            [](const ProfileSample& s) { return s.point.angle; }));
    if (profile.angle) drawing.add(curvatures_plot());
    if (profile.curvature)
        drawing.add(plot_of(*profile.curvature,
                            "curvature mismatch, %, " + std::string(formula_text(formula)), " %",
                            100, [](const ProfileSample& s) { return s.mismatch; }));
    if (profile.slope && profile.slope->limit)
        drawing.add(plot_of(*profile.slope, "change of the curvature's slope, °", "°", 1,
                            [](const ProfileSample& s) { return s.slope; }));
    return drawing.svg();
}

} // namespace keiko
