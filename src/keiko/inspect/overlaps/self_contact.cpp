#include "keiko/inspect/overlaps/self_contact.h"

#include "keiko/base/job.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/inspect/overlaps/face_inside.h"
#include "keiko/inspect/overlaps/sheet_approach.h"
#include "keiko/inspect/overlaps/sheet_cell.h"
#include "keiko/inspect/overlaps/tangent_spread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace keiko {
namespace {

class SelfContactSearch {
public:
    SelfContactSearch(const SurfaceModel& model, const PlacedFace& face, double least,
                      std::size_t most_tests)
        : model_(model),
          sheet_(model, face, least / neighbour_factor),
          inside_(model, model.faces[face.face], least),
          least_(least),
          left_(most_tests),
          root_(sheet_, sheet_.domain()) {}

    /// Large cells come first, so that a contact is found before its surroundings are cut small.
    std::optional<SelfContact> run() {
        open_.push_back({&root_, &root_});
        for (; !open_.empty() && !contact_.found; open_.pop_front()) {
            if (left_ == 0) return contact_;
            constexpr std::size_t often = 256;
            if (--left_ % often == 0) check_stop();
            const auto [a, b] = open_.front();
            a == b ? search(*a) : search(*a, *b);
        }
        return contact_.found ? std::optional(contact_) : std::nullopt;
    }

private:
    double neighbourhood() const { return neighbour_factor * least_; }

    /// True if trims leave nothing of a cell.
    bool is_outside(const SheetCell& cell) {
        const auto& parts = cell.parts();
        return std::all_of(parts.begin(), parts.end(), [&](const FaceSheet::Part& part) {
            return inside_.side(part.patch, part.uv) == TrimSide::outside;
        });
    }

    /// True if any two places over the box of (s, t) are neighbours or farther apart than `least_`.
    bool is_gentle(const Box2& box) {
        const auto parts = sheet_.parts(box);
        if (!parts) return false;
        // The ends of a closed sheet may differ by a share of `least_`.
        constexpr double slack = 1.25;
        return near_places_are_neighbours(*parts, box.extent(), slack * least_, neighbourhood());
    }

    /// Two cells to search for places of one that meet places of the other; one cell twice for
    /// places of it that meet each other.
    using CellPair = std::array<SheetCell*, 2>;

    void search(SheetCell& cell) {
        if (is_outside(cell) || is_gentle(cell.box()) || cell.size() <= neighbourhood() / 2) return;
        const auto [low, high] = cell.halves(cell.longer_axis());
        for (const CellPair& pair : {CellPair{low, low}, CellPair{high, high}, CellPair{low, high}})
            open_.push_back(pair);
    }

    void search(SheetCell& a, SheetCell& b) {
        if (!a.has_patches() || !b.has_patches()) return;
        if (a.is_apart(b, least_) || are_neighbours(a, b)) return;
        if (is_outside(a) || is_outside(b) || try_contact(a, b)) return;
        if (std::max(a.size(), b.size()) <= least_ / 2) return;
        const std::optional<unsigned> beside = axis_beside(a, b);
        const auto size = [&](const SheetCell& cell) {
            return beside ? cell.box().extent()[*beside] : cell.size();
        };
        SheetCell& larger = size(a) >= size(b) ? a : b;
        SheetCell& other = &larger == &a ? b : a;
        for (SheetCell* half : larger.halves(beside ? *beside : larger.longer_axis()))
            open_.push_back({half, &other});
    }

    /// The axis in which two cells that touch lie beside each other, if they do so in one alone:
    /// what is nearest to their common border are neighbours then, however long it is.
    std::optional<unsigned> axis_beside(const SheetCell& a, const SheetCell& b) const {
        const double narrow = neighbourhood() / 5; // two such strips are proved to be neighbours
        std::optional<unsigned> axis;
        any_shift([&](const Vec2& shift) {
            const Box2 moved{b.box().lower + shift, b.box().upper + shift};
            const Vec2 gap(
                std::max(moved.lower.x - a.box().upper.x, a.box().lower.x - moved.upper.x),
                std::max(moved.lower.y - a.box().upper.y, a.box().lower.y - moved.upper.y));
            for (const unsigned k : {0U, 1U})
                if (gap[k] > -1e-9 && gap[k] <= narrow && gap[1 - k] < -1e-9) axis = k;
            return axis.has_value();
        });
        // Strips that end in a tip are neighbours about it alone, and narrower ones prove no more.
        const auto reaches_tip = [&](const SheetCell& cell) {
            return std::any_of(sheet_.tips().begin(), sheet_.tips().end(), [&](const Vec3& tip) {
                return cell.hull().padded(neighbourhood()).contains(tip);
            });
        };
        if (axis && (reaches_tip(a) || reaches_tip(b))) return std::nullopt;
        if (axis && std::max(a.box().extent()[*axis], b.box().extent()[*axis]) <= narrow)
            return std::nullopt;
        return axis;
    }

    /// True if `test` is for a shift in (s, t) by no period or by one, either way.
    template <class Test>
    bool any_shift(const Test& test) const {
        const int most_s = sheet_.period().x > 0 ? 1 : 0, most_t = sheet_.period().y > 0 ? 1 : 0;
        for (int i = -most_s; i <= most_s; ++i)
            for (int j = -most_t; j <= most_t; ++j)
                if (test(Vec2(i, j) * sheet_.period())) return true;
        return false;
    }

    /// True if both cells lie within a ball about a tip.
    bool are_at_tip(const SheetCell& a, const SheetCell& b, double radius) const {
        Box3 both = a.hull();
        both.extend(b.hull());
        return std::any_of(sheet_.tips().begin(), sheet_.tips().end(), [&](const Vec3& tip) {
            const Vec3 low = tip - both.lower, high = both.upper - tip;
            return Vec3(std::max(low.x, high.x), std::max(low.y, high.y), std::max(low.z, high.z))
                       .length() <= radius;
        });
    }

    bool are_neighbours(const SheetCell& a, const SheetCell& b) {
        if (are_at_tip(a, b, neighbourhood() / 2)) return true;
        Box3 both = a.hull();
        both.extend(b.hull());
        return any_shift([&](const Vec2& shift) {
            Box2 around = a.box();
            around.extend(Box2{b.box().lower + shift, b.box().upper + shift});
            const Vec2 extent = around.extent(), own = a.box().extent(), other = b.box().extent();
            // Boxes with more between them than they hold are not tested.
            const Vec2 most = (own + other) * 2 + Vec2(neighbourhood());
            if (extent.x > most.x || extent.y > most.y) return false;
            if (both.size() <= neighbourhood() / 2 && extent.length() <= neighbourhood())
                return true;
            return is_gentle(around);
        });
    }

    bool try_contact(const SheetCell& a, const SheetCell& b) {
        const FaceSheet::Part *of_a = a.only_part(), *of_b = b.only_part();
        if (of_a == nullptr || of_b == nullptr) return false;
        const SheetApproach found = sheet_approach(*of_a, *of_b);
        if (!(found.distance <= least_) || !is_material(*of_a, *of_b, found)) return false;
        const Vec2 from = place_of(a, *of_a, found.a), to = place_of(b, *of_b, found.b);
        const double way = way_between(from, to);
        if (!(way > neighbourhood())) return false;
        contact_.found = true, contact_.way = way;
        contact_.distance = found.distance, contact_.place = sheet_.origin() + found.middle;
        contact_.angle = found.angle;
        return true;
    }

    /// True if both places are material, and one of them is not at a border of the face: borders
    /// that meet are a seam.
    bool is_material(const FaceSheet::Part& a, const FaceSheet::Part& b,
                     const SheetApproach& found) {
        const SurfaceDerivatives at_a = evaluate(a.view, found.a, 1);
        const SurfaceDerivatives at_b = evaluate(b.view, found.b, 1);
        return inside_.is_on(a.patch, found.a, at_a) && inside_.is_on(b.patch, found.b, at_b) &&
               (inside_.is_inside(a.patch, found.a, at_a) ||
                inside_.is_inside(b.patch, found.b, at_b));
    }

    static Vec2 place_of(const SheetCell& cell, const FaceSheet::Part& part, const Vec2& uv) {
        const Vec2 extent = part.uv.extent();
        const Vec2 share((uv.x - part.uv.lower.x) / extent.x, (uv.y - part.uv.lower.y) / extent.y);
        return cell.box().lower + cell.box().extent() * share;
    }

    /// mm over the surface along the straight line in (s, t), by the shorter way round.
    double way_between(const Vec2& from, const Vec2& to) const {
        double least = INFINITY;
        any_shift([&](const Vec2& shift) {
            least = std::min(least, way_along(from, to + shift));
            return false;
        });
        return least;
    }

    double way_along(const Vec2& from, const Vec2& to) const {
        constexpr int steps = 32;
        double way = 0;
        std::optional<Vec3> last;
        for (int k = 0; k <= steps; ++k) {
            const auto part = sheet_.part_at(from + (to - from) * (double(k) / steps));
            if (!part) return INFINITY;
            const Vec3 p = evaluate(part->view, part->uv.lower, 0).position();
            if (last) way += (p - *last).length();
            last = p;
        }
        return way;
    }

    const SurfaceModel& model_;
    FaceSheet sheet_;
    FaceInside inside_;
    double least_;     ///< mm
    std::size_t left_; ///< tests
    SheetCell root_;
    std::deque<CellPair> open_; ///< not yet searched
    SelfContact contact_;
};

} // namespace

std::optional<SelfContact> self_contact(const SurfaceModel& model, const PlacedFace& face,
                                        double least, std::size_t most_tests) {
    return SelfContactSearch(model, face, least, most_tests).run();
}

} // namespace keiko
