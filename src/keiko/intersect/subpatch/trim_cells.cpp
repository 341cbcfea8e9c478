#include "keiko/intersect/subpatch/trim_cells.h"

#include "keiko/intersect/subpatch/traced_model.h"

namespace keiko {
namespace {

class Classifier {
public:
    Classifier(const SubPatch& sub_patch, const PatchFrame& patch, const FaceTrim& trim)
        : sub_patch_(sub_patch), patch_(patch), trim_(trim) {}

    /// The cells of a square of `count` x `count`, the first of which is (i, j).
    void classify(unsigned i, unsigned j, unsigned count) {
        const Vec2 first(i, j), last(i + count, j + count);
        // Roots are rounded on their way to the face's parameters.
        const Vec2 room(1e-9);
        const Box2 here{sub_patch_.patch_parameters((first - room) / 8),
                        sub_patch_.patch_parameters((last + room) / 8)};
        const TrimSide side =
            within(here, unit_square) ? trim_.region.classify(on_face(here)) : TrimSide::mixed;
        const TrimCells::Set cells =
            TrimCells::met({(first + room) / 4 - Vec2(1), (last - room) / 4 - Vec2(1)});
        if (side == TrimSide::inside)
            cells_.material |= cells;
        else if (side == TrimSide::outside && !may_be_seam(here))
            cells_.empty |= cells;
        else if (count > 1)
            for (const unsigned dj : {0U, count / 2})
                for (const unsigned di : {0U, count / 2}) classify(i + di, j + dj, count / 2);
    }
    const TrimCells& cells() const { return cells_; }

private:
    static bool within(const Box2& box, const Box2& all) {
        return all.contains(box.lower) && all.contains(box.upper);
    }
    Box2 on_face(const Box2& box) const {
        Box2 result;
        result.extend(patch_.to_face(box.lower));
        result.extend(patch_.to_face(box.upper));
        return result;
    }
    bool may_be_seam(const Box2& box) const {
        // Where the reach is wider, or not known at a pole, boxes of curves tell nothing.
        constexpr double widest = 0.01;
        if (!(trim_.reach > 0)) return false;
        const Vec2& reach = sub_patch_.seam_reach;
        if (!(reach.x < widest && reach.y < widest)) return true;
        return trim_.region.may_be_near_edge(on_face({box.lower - reach, box.upper + reach}));
    }

    const SubPatch& sub_patch_;
    const PatchFrame& patch_;
    const FaceTrim& trim_;
    TrimCells cells_;
};

} // namespace

TrimCells trim_cells(const SubPatch& sub_patch, const PatchFrame& patch, const FaceTrim& trim) {
    if (sub_patch.trim != TrimSide::mixed) return {};
    Classifier classifier(sub_patch, patch, trim);
    classifier.classify(0, 0, 8);
    return classifier.cells();
}

} // namespace keiko
