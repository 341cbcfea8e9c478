#include "keiko/inspect/combs/comb_curves.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/basics/curve_chains.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/combs/face_combs.h"
#include "keiko/math/bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

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

/// Pieces along borders without the parts that an earlier piece covers within `near` mm. A border
/// belongs to the faces on both of its sides.
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

void turn(CombPiece& piece) {
    std::reverse(piece.samples.begin(), piece.samples.end());
    if (piece.touching)
        for (CombSample& sample : piece.samples) turn_over(sample.bend);
}

CombCurve curve_of(const CurveChain& chain, std::vector<CombPiece>& pieces) {
    CombCurve curve;
    curve.closed = chain.closed;
    for (const ChainLink& link : chain.links) {
        CombPiece& piece = pieces[link.piece];
        if (link.turned) turn(piece);
        const Vec3* before = nullptr;
        for (CombSample& sample : piece.samples) {
            if (before) curve.length += (sample.place - *before).length();
            sample.along = curve.length;
            before = &sample.place;
        }
        curve.pieces.push_back(std::move(piece));
    }
    return curve;
}

/// Curves joined over the borders of patches and faces.
std::vector<CombCurve> curves_of(std::vector<CombPiece> pieces, double join) {
    std::vector<std::array<Vec3, 2>> ends;
    for (const CombPiece& piece : pieces)
        ends.push_back({piece.samples.front().place, piece.samples.back().place});
    std::vector<CombCurve> curves;
    for (const CurveChain& chain : chain_curves(ends, join))
        curves.push_back(curve_of(chain, pieces));
    return curves;
}

template <class T>
void append(std::vector<T>& all, std::vector<T> some) {
    std::move(some.begin(), some.end(), std::back_inserter(all));
}

std::string share_text(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", share);
    return text;
}

struct FoundOnFace {
    std::vector<FaceSection> sections; ///< by plane
    std::vector<CombCurve> iso_curves;
};

std::vector<CombCurve> iso_curves(const FaceCombs& face, const std::string& name,
                                  const CombOptions& options) {
    std::vector<CombCurve> all;
    for (const bool by_u : {true, false})
        for (int k = 0; k < options.iso_curves; ++k) {
            const double share = (k + 0.5) / options.iso_curves;
            auto curves = curves_of(face.iso_curve(by_u, share), options.chord_error);
            for (CombCurve& curve : curves) {
                curve.kind = by_u ? CombCurve::Kind::iso_u : CombCurve::Kind::iso_v;
                curve.name = name + (by_u ? ": u at " : ": v at ") + share_text(share);
            }
            append(all, std::move(curves));
        }
    return all;
}

std::vector<FoundOnFace> search(const SurfaceModel& model, const std::vector<PlacedFace>& placed,
                                const CombOptions& options, const Job& job) {
    const double size = material_bounds(model, job).size();
    std::vector<FoundOnFace> found(placed.size());
    parallel_for(placed.size(), job, "combs", [&](std::size_t i) {
        const FaceCombs face(model, placed[i], options, size);
        for (const SectionPlane& plane : options.planes)
            found[i].sections.push_back(face.section(plane));
        found[i].iso_curves =
            iso_curves(face, placed_face_name(model, placed[i].instance, placed[i].face), options);
    });
    return found;
}

/// The curves of one plane, which are removed from `found`.
std::vector<CombCurve> section_curves(std::vector<FoundOnFace>& found, std::uint32_t plane,
                                      const CombOptions& options) {
    constexpr double same = 2; // chord errors
    std::vector<CombPiece> pieces;
    for (FoundOnFace& face : found) append(pieces, std::move(face.sections[plane].pieces));
    auto sections =
        curves_of(without_doubles(std::move(pieces), same * options.chord_error), options.join);
    for (CombCurve& curve : sections) curve.name = options.planes[plane].name, curve.plane = plane;
    return sections;
}

std::vector<SectionRemark> remarks_on(const std::vector<FoundOnFace>& found,
                                      const std::vector<PlacedFace>& placed, std::uint32_t plane) {
    std::vector<SectionRemark> remarks;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const FaceSection& section = found[i].sections[plane];
        SectionRemark remark{SectionRemark::Kind::within, plane, placed[i].instance,
                             placed[i].face};
        if (section.within) remarks.push_back(remark);
        remark.kind = SectionRemark::Kind::touches;
        for (const Vec3& place : section.touched) {
            remark.place = place;
            remarks.push_back(remark);
        }
    }
    return remarks;
}

/// Remark on a plane with neither curves nor other remarks.
SectionRemark missed(const SurfaceModel& model, const SectionPlane& plane, std::uint32_t index) {
    SectionRemark remark{SectionRemark::Kind::missed, index};
    remark.reach = heights(model, plane.normal);
    return remark;
}

} // namespace

FoundCombs comb_curves(const SurfaceModel& model, const CombOptions& options, const Job& job) {
    std::vector<PlacedFace> placed = placed_faces(model);
    std::erase_if(placed, [&](const PlacedFace& f) { return !model.faces[f.face].patch_count; });
    std::vector<FoundOnFace> found = search(model, placed, options, job);
    FoundCombs combs;
    for (std::uint32_t plane = 0; plane < options.planes.size(); ++plane) {
        std::vector<SectionRemark> remarks = remarks_on(found, placed, plane);
        std::vector<CombCurve> curves = section_curves(found, plane, options);
        if (remarks.empty() && curves.empty())
            remarks.push_back(missed(model, options.planes[plane], plane));
        append(combs.curves, std::move(curves));
        append(combs.remarks, std::move(remarks));
    }
    for (FoundOnFace& face : found) append(combs.curves, std::move(face.iso_curves));
    return combs;
}

std::vector<Vec3> inflections_of(const CombCurve& curve) {
    std::vector<Vec3> places;
    for (const CombPiece& piece : curve.pieces) {
        const CombSample* bent = nullptr; // the last curved sample, before flat ones
        for (const CombSample& sample : piece.samples) {
            const double to = sample.bend.curvature;
            if (to == 0) continue;
            if (bent && (bent->bend.curvature < 0) != (to < 0)) {
                const double from = bent->bend.curvature;
                places.push_back(bent->place + (sample.place - bent->place) * (from / (from - to)));
            }
            bent = &sample;
        }
    }
    return places;
}

const CombSample& most_bent(const CombCurve& curve) {
    const CombSample* most = &curve.pieces.front().samples.front();
    for (const CombPiece& piece : curve.pieces)
        for (const CombSample& sample : piece.samples)
            if (std::abs(sample.bend.curvature) > std::abs(most->bend.curvature)) most = &sample;
    return *most;
}

} // namespace keiko
