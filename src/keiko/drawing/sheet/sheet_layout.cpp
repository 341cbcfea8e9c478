#include "keiko/drawing/sheet/sheet_layout.h"

#include "keiko/base/error.h"
#include "keiko/drawing/sheet/sheet_furniture.h"
#include "keiko/math/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr double gap = 18;          ///< mm, around a view: dimensions and name have room there
constexpr double name_height = 3.5; ///< mm, of letters

struct Pen {
    double visible, hidden; ///< mm
};

/// Pens of the kinds of curves: outlines and edges are thick, what lies on a surface is thin
/// [ISO128-2].
Pen pen_of(CurveKind kind) {
    switch (kind) {
        case CurveKind::outline:
            return {0.5, 0.25};
        case CurveKind::edge:
        case CurveKind::crease:
        case CurveKind::section:
            return {0.35, 0.18};
        case CurveKind::line:
            return {0.25, 0.13};
        case CurveKind::seam:
        case CurveKind::iso:
            break;
    }
    return {0.13, 0.09};
}

Box2 cell_at(const Vec2& lower, const Vec2& size) {
    return {lower, lower + size};
}

class SheetMaker {
public:
    SheetMaker(std::span<const SheetView> views, const SheetOptions& options)
        : views_(views), options_(options), sheet_{options.title, options.paper, {}, {}} {
        for (const SheetView& view : views) {
            boxes_.push_back(image_box(view));
            if (boxes_.back().empty())
                throw Error("", "view '" + view.name + "'", "shows no line of the body");
        }
    }

    Sheet run() {
        const Box2 area = drawing_area(options_.paper);
        if (options_.three_views)
            place_three(area);
        else
            place_in_grid(area);
        add_frame(sheet_);
        add_title_block(sheet_, options_.title, notes());
        add_list(sheet_, options_.list);
        if (scale_) add_scale_bar(sheet_, *scale_);
        return std::move(sheet_);
    }

private:
    std::vector<std::string> notes() const {
        std::vector<std::string> notes;
        notes.push_back(scale_ ? "scale " + scale_text(*scale_) + ", dimensions in mm"
                               : "not to scale");
        if (options_.three_views) notes.emplace_back("first-angle projection");
        return notes;
    }

    void place_three(const Box2& area) {
        const Vec2 main = boxes_[0].extent();
        const Vec2 all(main.x + boxes_[1].extent().x, main.y + boxes_[2].extent().y);
        const Vec2 room = area.extent() - Vec2(4 * gap, 4 * gap);
        const double scale = usual_scale(std::min(room.x / all.x, room.y / all.y));
        scale_ = scale;
        const Vec2 spare = (area.extent() - all * scale) / 3;
        const Vec2 corner(area.lower.x + spare.x, area.upper.y - spare.y - main.y * scale);
        put(0, corner, scale);
        put(1, corner + Vec2(main.x * scale + spare.x, 0), scale);
        put(2, corner - Vec2(0, spare.y + boxes_[2].extent().y * scale), scale);
    }

    void place_in_grid(const Box2& area) {
        const auto count = static_cast<double>(views_.size());
        const double columns = std::ceil(std::sqrt(count)), rows = std::ceil(count / columns);
        const Vec2 cell(area.extent().x / columns, area.extent().y / rows);
        const Vec2 room = cell - Vec2(2 * gap, 2 * gap);
        if (!(room.x > 0 && room.y > 0))
            throw Error("", "paper", "has no room for " + std::to_string(views_.size()) + " views");
        double most = Box2::infinity;
        for (std::size_t i = 0; i < views_.size(); ++i)
            if (views_[i].parallel) most = std::min(most, fit(boxes_[i], room));
        if (std::isfinite(most)) scale_ = usual_scale(most);
        for (std::size_t i = 0; i < views_.size(); ++i) {
            const auto column = std::fmod(static_cast<double>(i), columns);
            const double row = std::floor(static_cast<double>(i) / columns);
            const Box2 of_view =
                cell_at({area.lower.x + column * cell.x, area.upper.y - (row + 1) * cell.y}, cell);
            const double scale = views_[i].parallel ? *scale_ : fit(boxes_[i], room);
            put(i, of_view.center() - boxes_[i].extent() * (scale / 2), scale);
        }
    }

    static double fit(const Box2& box, const Vec2& room) {
        const Vec2 extent = box.extent();
        return std::min(room.x / extent.x, room.y / extent.y);
    }

    bool is_drawn(const Stroke& stroke, const std::string& name) const {
        const auto& without = options_.without;
        return (stroke.visible || options_.dash_hidden) &&
               std::find(without.begin(), without.end(), name) == without.end();
    }

    /// Draws a view with the lower left corner of its box at a place.
    void put(std::size_t index, const Vec2& corner, double scale) {
        const SheetView& view = views_[index];
        const Vec2 shift = corner - boxes_[index].lower * scale;
        for (const Stroke& stroke : view.strokes) {
            const std::string name(name_of(stroke.kind));
            if (!is_drawn(stroke, name)) continue;
            const Pen pen = pen_of(stroke.kind);
            SheetLayer& layer = stroke.visible
                                    ? layer_of(sheet_, name, pen.visible)
                                    : layer_of(sheet_, name + " hidden", pen.hidden, true);
            std::vector<Vec2>& line = layer.lines.emplace_back();
            for (const Vec2& point : stroke.points) line.push_back(point * scale + shift);
        }
        const Box2 on_sheet = cell_at(corner, boxes_[index].extent() * scale);
        for (const SheetMark& mark : view.marks)
            add_mark(sheet_, mark.at * scale + shift, mark.number, mark.visible);
        add_dimensions(sheet_, on_sheet, view.width, view.height);
        sheet_.texts.push_back({{on_sheet.center().x, on_sheet.upper.y + name_height},
                                name_height,
                                view.name,
                                SheetText::Anchor::middle});
    }

    std::span<const SheetView> views_;
    const SheetOptions& options_;
    Sheet sheet_;
    std::vector<Box2> boxes_;
    std::optional<double> scale_; ///< of all parallel views
};

} // namespace

Box2 image_box(const SheetView& view) {
    Box2 box;
    for (const Stroke& stroke : view.strokes)
        for (const Vec2& point : stroke.points) box.extend(point);
    return box;
}

double usual_scale(double most) {
    // Powers of ten of both signs: 1:50 is 2 / 100.
    const double power = std::pow(10, std::floor(std::log10(most)));
    for (const double step : {5.0, 2.0})
        if (step * power <= most) return step * power;
    return power;
}

std::string scale_text(double scale) {
    const auto whole = [](double value) { return std::to_string(std::llround(value)); };
    return scale < 1 ? "1:" + whole(1 / scale) : whole(scale) + ":1";
}

Sheet laid_out(std::span<const SheetView> views, const SheetOptions& options) {
    return SheetMaker(views, options).run();
}

} // namespace keiko
