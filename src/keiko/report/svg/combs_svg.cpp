#include "keiko/math/bounds.h"
#include "keiko/report/content/combs_text.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

namespace keiko {
namespace {

constexpr double width = 960, margin = 40, head = 64; ///< units of the picture
/// Length of a tooth of the scale's curvature, as a share of the drawing's diagonal.
constexpr double tooth_share = 0.08;
constexpr double usual_share = 0.98;  ///< of the samples are within the scale
constexpr double least_spacing = 2.5; ///< of teeth, in the picture
constexpr double spike = 1.1;         ///< ratio to the tooth before: replaces it

/// Axes of a drawing viewed from `towards`, z up if possible.
struct DrawingAxes {
    Vec3 right, up;

    explicit DrawingAxes(const Vec3& towards) {
        const Vec3 upright = std::abs(towards.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
        right = upright.cross(towards).normalized();
        // Sections are drawn with x, or else y, to the right, as the coordinates run.
        const double along = std::abs(right.x) > std::abs(right.y) ? right.x : right.y;
        if (along < 0) right = -right;
        up = (upright - towards * towards.dot(upright)).normalized();
    }
    Vec2 of(const Vec3& p) const { return {p.dot(right), -p.dot(up)}; }
};

template <class F>
void for_each_sample(std::span<const CombCurve> curves, const F& visit) {
    for (const CombCurve& curve : curves)
        for (const CombPiece& piece : curve.pieces)
            for (const CombSample& sample : piece.samples) visit(sample);
}

/// The 1, 2 or 5 times a power of ten that is not below nearly all curvatures.
double usual_curvature(std::span<const CombCurve> curves) {
    std::vector<double> sizes;
    for_each_sample(curves,
                    [&](const CombSample& s) { sizes.push_back(std::abs(s.bend.curvature)); });
    std::sort(sizes.begin(), sizes.end());
    const auto at = static_cast<std::size_t>(usual_share * static_cast<double>(sizes.size() - 1));
    constexpr double flat = 1e-9;
    const double value = std::max(sizes[at], flat);
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * power) return step * power;
    return 10 * power;
}

class CombDrawing {
public:
    CombDrawing(std::ostream& out, std::span<const CombCurve> curves, const Vec3& normal)
        : out_(out), curves_(curves), axes_(normal), scale_(usual_curvature(curves)) {
        Box2 box;
        for_each_sample(curves, [&](const CombSample& s) { box.extend(axes_.of(s.place)); });
        tooth_ = tooth_share * std::max(box.size(), 1e-9);
        for_each_sample(curves, [&](const CombSample& s) { box.extend(tip(s)); });
        unit_ = (width - 2 * margin) / std::max(box.extent().x, box.extent().y * 0.8);
        origin_ = box.lower;
        height_ = box.extent().y * unit_ + 2 * margin + head;
    }

    double height() const { return height_; }
    double scale() const { return scale_; } ///< 1/mm
    double tooth() const { return tooth_ * unit_; }

    void draw() {
        for (const CombCurve& curve : curves_)
            for (const CombPiece& piece : curve.pieces) {
                for (const CombSample* sample : teeth(piece)) {
                    const bool cut = std::abs(sample->bend.curvature) > scale_;
                    path(cut ? "cut" : "tooth", {axes_.of(sample->place), tip(*sample)});
                }
                std::vector<Vec2> line, tips;
                for (const CombSample& s : piece.samples)
                    line.push_back(axes_.of(s.place)), tips.push_back(tip(s));
                path("tips", tips);
                path("curve", line);
            }
    }

private:
    /// Samples whose teeth are drawn. Of samples too near each other to be distinguished, it is the
    /// first, or one with a clearly larger curvature: a spike may have any width.
    std::vector<const CombSample*> teeth(const CombPiece& piece) const {
        std::vector<const CombSample*> chosen;
        std::optional<Vec2> first;
        for (const CombSample& s : piece.samples) {
            const Vec2 root = axes_.of(s.place);
            if (!first || (root - *first).length() * unit_ >= least_spacing) {
                first = root;
                chosen.push_back(&s);
            } else if (std::abs(s.bend.curvature) >
                       spike * std::abs(chosen.back()->bend.curvature)) {
                chosen.back() = &s;
            }
        }
        return chosen;
    }

    Vec2 tip(const CombSample& s) const {
        const double share = std::clamp(s.bend.curvature / scale_, -1.0, 1.0);
        return axes_.of(s.place - s.bend.towards * (share * tooth_));
    }

    void path(const char* style, const std::vector<Vec2>& points) {
        out_ << "<path class=\"" << style << "\" d=\"";
        char letter = 'M';
        for (const Vec2& p : points) {
            const Vec2 at = (p - origin_) * unit_ + Vec2(margin, margin + head);
            out_ << letter << at.x << " " << at.y;
            letter = 'L';
        }
        out_ << "\"/>\n";
    }

    std::ostream& out_;
    std::span<const CombCurve> curves_;
    DrawingAxes axes_;
    double scale_, tooth_ = 0, unit_ = 1, height_ = 0;
    Vec2 origin_{0};
};

} // namespace

std::string combs_svg(std::span<const CombCurve> curves, const Vec3& normal,
                      const std::string& title) {
    std::ostringstream body, out;
    body.precision(6), out.precision(6);
    CombDrawing drawing(body, curves, normal);
    drawing.draw();
    double length = 0;
    for (const CombCurve& curve : curves) length += curve.length;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << " "
        << drawing.height() << "\" font-family=\"sans-serif\" font-size=\"13\">\n"
        << "<style>path{fill:none;stroke-linejoin:round}path.tooth{stroke:#7aa7d8;stroke-width:.7}"
           "path.cut{stroke:#c42b1c;stroke-width:1}path.tips{stroke:#1f5fa8;stroke-width:1}"
           "path.curve{stroke:#111;stroke-width:1.6}</style>\n"
        << "<rect width=\"" << width << "\" height=\"" << drawing.height() << "\" fill=\"#fff\"/>\n"
        << "<text x=\"16\" y=\"24\" font-size=\"16\">" << html_escaped(title) << ": "
        << fixed_number(length, 1) << " mm</text>\n"
        << "<path class=\"curve\" d=\"M16 42h" << drawing.tooth() << "\"/>\n"
        << "<text x=\"" << 24 + drawing.tooth() << "\" y=\"47\">curvature " << drawing.scale()
        << " /mm, radius " << 1 / drawing.scale() << " mm; longer teeth are cut and red</text>\n"
        << body.str() << "</svg>\n";
    return out.str();
}

std::vector<CombPicture> comb_pictures(std::span<const CombCurve> curves,
                                       std::span<const SectionPlane> planes) {
    std::vector<CombPicture> pictures;
    const auto add = [&](const std::string& name, const Vec3& normal, const auto& is_shown) {
        std::vector<CombCurve> shown;
        std::copy_if(curves.begin(), curves.end(), std::back_inserter(shown), is_shown);
        if (!shown.empty()) pictures.push_back({name, combs_svg(shown, normal, name)});
    };
    for (std::uint32_t i = 0; i < planes.size(); ++i)
        add(planes[i].name, planes[i].normal, [i](const CombCurve& curve) {
            return curve.kind == CombCurve::Kind::section && curve.plane == i;
        });
    add("iso-curves", Vec3(-1, -1, 0.8).normalized(),
        [](const CombCurve& curve) { return curve.kind != CombCurve::Kind::section; });
    return pictures;
}

} // namespace keiko
