#include "keiko/inspect/combs/duplicate_segments.h"

#include "keiko/math/bounds.h"

#include <algorithm>

namespace keiko {
namespace {

struct Kept {
    const CombPiece* piece;
    Box3 box;
};

Box3 box_of(const CombPiece& piece) {
    Box3 box;
    for (const CombSample& sample : piece.samples) box.extend(sample.place);
    return box;
}

/// True if the foot of a place on a chord is near and, to within rounding, between its ends.
bool beside(const Vec3& place, const Vec3& a, const Vec3& b, double near) {
    constexpr double slack = 1e-9;
    const Vec3 chord = b - a;
    const double share = (place - a).dot(chord) / chord.dot(chord);
    if (!(share >= -slack && share <= 1 + slack)) return false;
    return (a + chord * share - place).length() <= near;
}

bool covers(const Kept& kept, const Vec3& place, double near) {
    if (!kept.box.padded(near).contains(place)) return false;
    const std::vector<CombSample>& samples = kept.piece->samples;
    for (std::size_t i = 1; i < samples.size(); ++i)
        if (beside(place, samples[i - 1].place, samples[i].place, near)) return true;
    return false;
}

/// The stretches of a piece with chords whose middles are not covered.
std::vector<CombPiece> uncovered(const CombPiece& piece, const std::vector<Kept>& kept,
                                 double near) {
    std::vector<CombPiece> rest;
    bool going_on = false;
    for (std::size_t i = 1; i < piece.samples.size(); ++i) {
        const CombSample &a = piece.samples[i - 1], &b = piece.samples[i];
        const Vec3 middle = (a.place + b.place) / 2;
        const bool covered = std::any_of(kept.begin(), kept.end(), [&](const Kept& other) {
            return covers(other, middle, near);
        });
        if (!covered && !going_on) {
            rest.push_back(piece);
            rest.back().samples = {a};
        }
        if (!covered) rest.back().samples.push_back(b);
        going_on = !covered;
    }
    return rest;
}

} // namespace

std::vector<CombPiece> without_doubles(std::vector<CombPiece> pieces, double near) {
    std::vector<CombPiece> single;
    std::vector<Kept> kept;
    for (CombPiece& piece : pieces) {
        if (!piece.on_border) {
            single.push_back(std::move(piece));
            continue;
        }
        for (CombPiece& rest : uncovered(piece, kept, near)) single.push_back(std::move(rest));
        kept.push_back({&piece, box_of(piece)});
    }
    return single;
}

} // namespace keiko
