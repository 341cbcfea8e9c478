#include "keiko/inspect/seams/seam_sides.h"

namespace keiko {

SeamSides::SeamSides(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
                     std::span<const Seam> pieces)
    : borders_(borders) {
    for (const MeasuredSeam& seam : seams) {
        if (seam.scrap) continue;
        for (const std::uint32_t piece : seam.pieces) add(seam, pieces[piece]);
        for (const KnotPiece& piece : seam.knots) add(seam, piece);
    }
}

void SeamSides::add(const MeasuredSeam& seam, const Seam& piece) {
    const auto line = [&](const BoundaryInterval& on) {
        return SeamSide::Line{borders_.curves.curve(on), {on.begin, on.end}};
    };
    add_both(seam, line(piece.a), line(piece.b));
}

void SeamSides::add(const MeasuredSeam& seam, const KnotPiece& piece) {
    const auto& face = knotted_.try_emplace(seam.face_a, borders_.model, seam.face_a).first->second;
    const Affine& placed = borders_.model.instances[seam.instance_a].transform;
    const auto line = [&](bool left) {
        return SeamSide::Line{face.side(lines_.emplace_back(piece.side(left)), placed, left),
                              {0, 1}};
    };
    add_both(seam, line(true), line(false));
}

void SeamSides::add_both(const MeasuredSeam& seam, const SeamSide::Line& a,
                         const SeamSide::Line& b) {
    const bool sharp = seam.kind == SeamClass::crease || seam.kind == SeamClass::run_out;
    const bool passes = seam.angle && seam.angle->verdict == Verdict::pass;
    const bool leads_on = seam.kind == SeamClass::smooth && (passes || !seam.internal);
    const PlacedFace of_a{seam.instance_a, seam.face_a}, of_b{seam.instance_b, seam.face_b};
    sides_[{of_a.instance, of_a.face}].push_back(
        {a, b, of_b, sharp, leads_on, seam.internal, seam.negligible});
    sides_[{of_b.instance, of_b.face}].push_back(
        {b, a, of_a, sharp, leads_on, seam.internal, seam.negligible});
}

} // namespace keiko
