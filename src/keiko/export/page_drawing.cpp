#include "keiko/export/page_drawing.h"

#include "keiko/export/svg_path.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace keiko {
namespace {

// Lengths on the page are thousandths of its width.
constexpr double page_width = 1000, most_height = 640;
constexpr double gap = 56;     ///< between views, with room for their names
constexpr double margin = 28;  ///< around all: marks reach beyond the views
constexpr double caption = 36; ///< below a view, for its name and its size
constexpr double mark_radius = 10, letter_width = 7;

/// Marks of a view that are drawn as one.
struct MarkGroup {
    Vec2 at{0};
    bool visible = true;
    std::vector<std::uint32_t> numbers;
};

/// Adds marks that are visible, or those that are not, to the first groups that they would cover.
void add_marks(const SheetView& view, bool visible, double scale, const Vec2& shift,
               std::vector<MarkGroup>& groups) {
    constexpr double wide = 46; // of a mark of several
    for (const SheetMark& mark : view.marks) {
        if (mark.visible != visible) continue;
        const Vec2 at = mark.at * scale + shift;
        const auto covers = [&](const MarkGroup& group) {
            return std::abs(group.at.x - at.x) < wide &&
                   std::abs(group.at.y - at.y) < 2 * mark_radius;
        };
        const auto found = std::find_if(groups.begin(), groups.end(), covers);
        if (found == groups.end())
            groups.push_back({at, visible, {mark.number}});
        else
            found->numbers.push_back(mark.number);
    }
}

/// The marks of a view. Hidden ones are part of a visible group that would cover them.
std::vector<MarkGroup> grouped(const SheetView& view, double scale, const Vec2& shift) {
    std::vector<MarkGroup> groups;
    for (const bool visible : {true, false}) add_marks(view, visible, scale, shift, groups);
    for (MarkGroup& group : groups) std::sort(group.numbers.begin(), group.numbers.end());
    return groups;
}

/// "3", or "3 +4" for the first of five.
std::string label_of(const MarkGroup& group) {
    const std::string first = std::to_string(group.numbers.front());
    return group.numbers.size() == 1 ? first
                                     : first + " +" + std::to_string(group.numbers.size() - 1);
}

/// "findings 3, 8, 9"
std::string title_of(const MarkGroup& group) {
    std::string text = group.numbers.size() == 1 ? "finding" : "findings";
    for (const std::uint32_t number : group.numbers)
        text += (number == group.numbers.front() ? " " : ", ") + std::to_string(number);
    return text + (group.visible ? "" : ", hidden");
}

/// A class of lines of one view, in the order of drawing.
struct LineClass {
    CurveKind kind;
    bool visible;
};
constexpr std::array<LineClass, 7> line_classes{{{CurveKind::crease, false},
                                                 {CurveKind::edge, false},
                                                 {CurveKind::outline, false},
                                                 {CurveKind::seam, true},
                                                 {CurveKind::crease, true},
                                                 {CurveKind::edge, true},
                                                 {CurveKind::outline, true}}};

class PageDrawing {
public:
    PageDrawing(std::span<const SheetView> views, FindingTones tones)
        : views_(views), tones_(tones) {
        for (const SheetView& view : views) boxes_.push_back(image_box(view));
    }

    std::string run() {
        const std::vector<Vec2> corners = placed();
        out_.precision(5);
        out_ << "<svg class=\"drawing\" viewBox=\"0 0 " << page_width << ' ' << height_
             << "\" role=\"img\" aria-label=\"line drawing\">\n";
        for (std::size_t i = 0; i < views_.size(); ++i) add_lines(views_[i], i, corners[i]);
        for (std::size_t i = 0; i < views_.size(); ++i) add_mark_groups(views_[i], i, corners[i]);
        out_ << "</svg>";
        return out_.str();
    }

private:
    /// Sets scale and height, and returns the lower left corner of each view, y upwards.
    std::vector<Vec2> placed() {
        const Vec2 first = boxes_[0].extent();
        const bool three = views_.size() == 3;
        const Vec2 others = three ? Vec2(boxes_[1].extent().x, boxes_[2].extent().y) : Vec2(0, 0);
        const Vec2 gaps = three ? Vec2(gap, gap) : Vec2(0, 0);
        const Vec2 all = first + others;
        const double across = page_width - 2 * margin - gaps.x;
        scale_ = std::min(across / all.x, most_height / all.y);
        height_ = std::ceil(all.y * scale_ + gaps.y + 2 * margin + caption);
        const double left = (page_width - all.x * scale_ - gaps.x) / 2;
        const Vec2 main(left, height_ - margin - first.y * scale_);
        if (!three) return {main};
        return {main, main + Vec2(first.x * scale_ + gap, 0),
                main - Vec2(0, gap + others.y * scale_)};
    }

    Vec2 shift(std::size_t view, const Vec2& corner) const {
        return corner - boxes_[view].lower * scale_;
    }

    void add_lines(const SheetView& view, std::size_t index, const Vec2& corner) {
        for (const LineClass& drawn : line_classes) {
            std::vector<std::vector<Vec2>> lines;
            for (const Stroke& stroke : view.strokes) {
                if (stroke.kind != drawn.kind || stroke.visible != drawn.visible) continue;
                std::vector<Vec2>& line = lines.emplace_back();
                for (const Vec2& point : stroke.points)
                    line.push_back(point * scale_ + shift(index, corner));
            }
            if (lines.empty()) continue;
            out_ << "<path class=\"" << name_of(drawn.kind) << (drawn.visible ? "" : " hidden")
                 << "\" d=\"" << svg_path(lines, height_, 1) << "\"/>\n";
        }
        add_name(view, index, corner);
    }

    void add_name(const SheetView& view, std::size_t index, const Vec2& corner) {
        constexpr double room = 70, line = 15; // half of a text's width; its height
        const double middle = corner.x + boxes_[index].extent().x * scale_ / 2;
        const double x = std::clamp(middle, room, page_width - room), y = height_ - corner.y + line;
        add_text(x, y, html_escaped(view.name));
        if (view.width && view.height)
            add_text(x, y + line,
                     fixed_number(*view.width, 1) + " × " + fixed_number(*view.height, 1) + " mm");
    }

    void add_text(double x, double y, const std::string& text) {
        out_ << "<text x=\"" << x << "\" y=\"" << y << "\">" << text << "</text>\n";
    }

    void add_mark_groups(const SheetView& view, std::size_t index, const Vec2& corner) {
        for (const MarkGroup& group : grouped(view, scale_, shift(index, corner))) {
            const std::string label = label_of(group);
            const double wide =
                2 * mark_radius + letter_width * static_cast<double>(label.size() - 1);
            const double x = group.at.x, y = height_ - group.at.y;
            out_ << "<a href=\"#finding-" << group.numbers.front() << "\" class=\"mark "
                 << tone_of(group) << (group.visible ? "" : " hidden") << "\"><title>"
                 << title_of(group) << "</title><rect x=\"" << x - wide / 2 << "\" y=\""
                 << y - mark_radius << "\" width=\"" << wide << "\" height=\"" << 2 * mark_radius
                 << "\" rx=\"" << mark_radius << "\"/><text x=\"" << x << "\" y=\"" << y + 4
                 << "\">" << label << "</text></a>\n";
        }
    }

    /// The tone of a failing finding, if there is one.
    std::string tone_of(const MarkGroup& group) const {
        for (const std::uint32_t number : group.numbers)
            if (tones_[number - 1] == "fail") return "fail";
        return tones_[group.numbers.front() - 1];
    }

    std::span<const SheetView> views_;
    FindingTones tones_;
    std::vector<Box2> boxes_;
    double scale_ = 1, height_ = 0;
    std::ostringstream out_;
};

} // namespace

std::string page_drawing(std::span<const SheetView> views, FindingTones tones) {
    return PageDrawing(views, tones).run();
}

} // namespace keiko
