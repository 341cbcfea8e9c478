#include "keiko/inspect/seams/seam_measure.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/approximation_error.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/bend_pieces.h"
#include "keiko/inspect/seams/continuing_lines.h"
#include "keiko/inspect/seams/knot_piece.h"
#include "keiko/inspect/seams/scraps.h"
#include "keiko/inspect/seams/seam_chain.h"
#include "keiko/inspect/seams/seam_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

SeamLine line_of(const BoundaryCurves& curves, std::span<const Seam> seams,
                 const std::vector<std::uint32_t>& pieces) {
    const Seam& first = seams[pieces.front()];
    SeamLine line{first.a.instance, first.a.face, first.b.instance, first.b.face, {}};
    for (const std::uint32_t piece : pieces) {
        line.probes.emplace_back(curves, seams[piece]);
        line.probes.back().set_runs_out(runs_out(curves, seams[piece]));
    }
    return line;
}

/// The part of a paired seam that belongs to a stretch.
Seam cut_seam(Seam seam, const SeamPart& part) {
    seam.a.begin = part.begin.t, seam.a.end = part.end.t;
    seam.b.begin = part.begin.s, seam.b.end = part.end.s;
    return seam;
}

/// The seams between faces, with judged scraps.
MeasuredSeams with_judged_scraps(const ModelBorders& borders, std::span<const Seam> paired,
                                 const FaceLimits& limits, double join, const Job& job) {
    const SurfaceModel& model = borders.model;
    const BoundaryCurves& curves = borders.curves;
    const std::vector<Seam> seams = widened_seams(curves, paired, join);
    const std::vector<std::vector<std::uint32_t>> chains = seam_chains(curves, seams, join);
    const ContinuingLines continuing(curves, seams, chains, join);
    std::vector<std::vector<MeasuredStretch>> lines(chains.size());
    parallel_for(chains.size(), job, "measure", [&](std::size_t i) {
        const SeamLine line = line_of(curves, seams, chains[i]);
        const CriteriaPreset& preset =
            limits.between({line.instance_a, line.face_a}, {line.instance_b, line.face_b});
        const StretchLimits of_stretches =
            stretch_limits(borders.sizes.of(line.instance_a, line.face_a),
                           borders.sizes.of(line.instance_b, line.face_b), preset, join);
        lines[i] = measure_line(model, line, preset, of_stretches,
                                [&] { return continuing.beyond(static_cast<std::uint32_t>(i)); });
    });
    MeasuredSeams result;
    for (std::uint32_t i = 0; i < lines.size(); ++i)
        for (MeasuredStretch& stretch : lines[i]) {
            MeasuredSeam& seam = stretch.seam;
            seam.line = i;
            seam.faces = faces_at_seam(model, {seam.instance_a, seam.face_a},
                                       {seam.instance_b, seam.face_b});
            for (const SeamPart& part : stretch.parts) {
                seam.pieces.push_back(static_cast<std::uint32_t>(result.pieces.size()));
                result.pieces.push_back(cut_seam(seams[chains[i][part.piece]], part));
            }
            result.seams.push_back(std::move(seam));
        }
    return result;
}

/// An end of a scrap's border that leads out of it in the direction `out`.
SeamEnd tip(const Vec3& place, const Vec3& out) {
    return {place, out, out};
}

/// The ends of the borders of a scrap, on both of its sides; of a line inside a face, its own.
std::vector<SeamEnd> tips_of(const BoundaryCurves& curves, std::span<const Seam> pieces,
                             const MeasuredSeam& scrap) {
    std::vector<SeamEnd> tips;
    for (const std::uint32_t piece : scrap.pieces)
        for (const BoundaryInterval& on : {pieces[piece].a, pieces[piece].b}) {
            const SurfaceCurve curve = curves.curve(on);
            const double ahead = on.begin <= on.end ? 1 : -1;
            const SurfaceCurve::Point first = curve.at(on.begin), last = curve.at(on.end);
            tips.push_back(tip(first.position, first.first * -ahead));
            tips.push_back(tip(last.position, last.first * ahead));
        }
    if (!scrap.internal) return tips;
    for (const std::vector<Vec3>& course : scrap.course) {
        tips.push_back(tip(course.front(), course[0] - course[1]));
        tips.push_back(tip(course.back(), course.back() - course[course.size() - 2]));
    }
    return tips;
}

/// Takes scraps out of the verdict, unless they are judged after all (judged_scraps): those stop
/// being scraps.
void excuse_scraps(const BoundaryCurves& curves, double join, MeasuredSeams& measured) {
    std::vector<Scrap> scraps;
    std::vector<MeasuredSeam*> failing;
    for (MeasuredSeam& seam : measured.seams) {
        if (!seam.scrap || seam.verdict == Verdict::pass) continue;
        failing.push_back(&seam);
        scraps.push_back({{{{seam.instance_a, seam.face_a}, {seam.instance_b, seam.face_b}}},
                          seam.length,
                          seam.negligible,
                          tips_of(curves, measured.pieces, seam)});
    }
    const std::vector<bool> judged = judged_scraps(scraps, join);
    for (std::size_t i = 0; i < failing.size(); ++i) failing[i]->scrap = !judged[i];
    for (MeasuredSeam& seam : measured.seams)
        if (seam.scrap) seam.verdict = Verdict::pass, seam.severity = 0;
}

using KnotLine = std::vector<KnotPiece>;

class FaceKnots {
public:
    FaceKnots(const SurfaceModel& model, std::uint32_t face)
        : model_(model), index_(face), face_(model, face), knots_(broken_knots(face_)) {}

    std::vector<std::vector<MeasuredSeam>> measured(const FaceLimits& by_face,
                                                    const FaceSizes& sizes) {
        std::vector<std::vector<MeasuredSeam>> seams;
        const std::vector<KnotLine> breaks = knot_chains(model_, face_.face(), knots_.pieces);
        for (std::uint32_t i = 0; i < model_.instances.size(); ++i) {
            const Part& part = model_.parts[model_.instances[i].part];
            if (index_ - part.first_face >= part.face_count) continue;
            const double size = sizes.of(i, index_);
            const CriteriaPreset& preset = by_face.of({i, index_});
            const StretchLimits limits = stretch_limits(size, size, preset, 0);
            const double scale = scale_of(model_.instances[i]);
            for (const KnotLine& line : breaks) seams.push_back(measure(i, line, preset, limits));
            for (const KnotLine& line : bends_within(limits.negligible / scale))
                seams.push_back(measure(i, line, preset, limits));
        }
        return seams;
    }

private:
    const std::vector<KnotLine>& bends_within(double window);
    std::vector<KnotPiece> untorn_bends(double window) const;
    std::vector<MeasuredSeam> measure(std::uint32_t instance, const KnotLine& line,
                                      const CriteriaPreset& preset,
                                      const StretchLimits& limits) const;

    /// The bends that are narrower than a window, mm of the unplaced face.
    struct WindowBends {
        double window = 0;
        std::vector<KnotLine> lines;
    };

    const SurfaceModel& model_;
    std::uint32_t index_;
    KnottedFace face_;
    BrokenKnots knots_;
    std::vector<WindowBends> searched_;
};

/// The bends within a window. Each window is searched once, for all instances that have it.
const std::vector<KnotLine>& FaceKnots::bends_within(double window) {
    constexpr double rounding = 1e-9; // share, of the scales of turned instances
    const auto is_same = [&](const WindowBends& bends) {
        return std::abs(bends.window - window) <= rounding * window;
    };
    const auto known = std::find_if(searched_.begin(), searched_.end(), is_same);
    if (known != searched_.end()) return known->lines;
    searched_.push_back({window, knot_chains(model_, face_.face(), untorn_bends(window))});
    return searched_.back().lines;
}

/// The bends of the face, except those at which it is torn.
std::vector<KnotPiece> FaceKnots::untorn_bends(double window) const {
    std::vector<KnotPiece> bends = bend_pieces(face_, window);
    for (const KnotPiece& knot : knots_.torn)
        std::erase_if(bends, [&](const KnotPiece& bend) { return bend.meets(knot); });
    return bends;
}

std::vector<MeasuredSeam> FaceKnots::measure(std::uint32_t instance, const KnotLine& line,
                                             const CriteriaPreset& preset,
                                             const StretchLimits& limits) const {
    std::vector<std::array<Vec3, 2>> points;
    points.reserve(2 * line.size());
    SeamLine seam{instance, index_, instance, index_, {}};
    const Affine& placed = model_.instances[instance].transform;
    for (const KnotPiece& piece : line) {
        const auto& left = points.emplace_back(piece.side(true));
        const auto& right = points.emplace_back(piece.side(false));
        seam.probes.push_back(face_.probe(piece, placed, left, right));
    }
    const std::string faces =
        line_inside_face(model_, {instance, index_}, line.front().constant_u, line.front().at);
    CriteriaPreset judged = preset;
    if (!std::all_of(line.begin(), line.end(), [](const KnotPiece& p) { return p.has_limits; }))
        judged.curvature.reset(), judged.curvature_slope.reset();
    std::vector<MeasuredSeam> measured;
    for (MeasuredStretch& stretch : measure_line(model_, seam, judged, limits)) {
        stretch.seam.faces = faces;
        stretch.seam.internal = true;
        for (const SeamPart& part : stretch.parts)
            stretch.seam.knots.push_back(line[part.piece].part(part.begin.t, part.end.t));
        measured.push_back(std::move(stretch.seam));
    }
    return measured;
}

} // namespace

MeasuredSeams measure_seams(const ModelBorders& borders, std::span<const Seam> seams,
                            const FaceLimits& limits, double join, const Job& job) {
    MeasuredSeams measured = with_judged_scraps(borders, seams, limits, join, job);
    excuse_scraps(borders.curves, join, measured);
    return measured;
}

MeasuredSeams measure_all_seams(const ModelBorders& borders, std::span<const Seam> seams,
                                const FaceLimits& limits, double join, const Job& job) {
    MeasuredSeams all = with_judged_scraps(borders, seams, limits, join, job);
    const auto lines = static_cast<std::uint32_t>(line_count(all.seams));
    for (MeasuredSeam& seam : measure_knot_lines(borders, limits, job)) {
        seam.line += lines;
        all.seams.push_back(std::move(seam));
    }
    excuse_scraps(borders.curves, join, all);
    return all;
}

std::size_t line_count(std::span<const MeasuredSeam> seams) {
    return seams.empty() ? 0 : seams.back().line + 1;
}

std::vector<MeasuredSeam> measure_knot_lines(const ModelBorders& borders, const FaceLimits& limits,
                                             const Job& job) {
    const SurfaceModel& model = borders.model;
    std::vector<std::vector<std::vector<MeasuredSeam>>> by_face(model.faces.size());
    parallel_for(model.faces.size(), job, "knots", [&](std::size_t f) {
        const auto index = static_cast<std::uint32_t>(f);
        if (has_irregular_patch(model, index)) return;
        by_face[f] = FaceKnots(model, index).measured(limits, borders.sizes);
    });
    std::vector<MeasuredSeam> all;
    std::uint32_t number = 0;
    for (auto& lines : by_face)
        for (auto& line : lines) {
            for (MeasuredSeam& seam : line) seam.line = number;
            ++number;
            std::move(line.begin(), line.end(), std::back_inserter(all));
        }
    return all;
}

} // namespace keiko
