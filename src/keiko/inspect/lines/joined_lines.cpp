#include "keiko/inspect/lines/joined_lines.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/class_stretches.h"
#include "keiko/inspect/seams/continuing_lines.h"
#include "keiko/inspect/seams/model_borders.h"
#include "keiko/inspect/seams/seam_chain.h"
#include "keiko/inspect/seams/seam_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace keiko {
namespace {

/// A piece oriented as its line, with its geometry and what its ends meet.
struct StudiedPiece {
    std::vector<CourseAt> courses;
    std::array<LineBorders::End, 2> ends; ///< head, tail
};

std::vector<CourseAt> courses_of(const SurfaceModel& model, const SurfaceLine& piece,
                                 const LampLevels& lamps) {
    std::vector<CourseAt> courses;
    const std::vector<LinePoint>& points = piece.line.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto course =
            line_course(lamps.field, lamps.level(piece.lamp),
                        placed_derivatives(model, piece.instance, piece.patch, points[i].uv));
        if (!course) continue;
        const double step = i == 0 ? 0 : (points[i].place - points[i - 1].place).length();
        courses.push_back({step, *course, points[i]});
    }
    return courses;
}

/// True if the points run against the courses.
bool runs_backwards(const SurfaceModel& model, const SurfaceLine& piece, const LampLevels& lamps) {
    const std::vector<LinePoint>& points = piece.line.points;
    const std::size_t middle = points.size() / 2;
    const auto course =
        line_course(lamps.field, lamps.level(piece.lamp),
                    placed_derivatives(model, piece.instance, piece.patch, points[middle].uv));
    const std::size_t after = std::min(middle + 1, points.size() - 1);
    return course && course->tangent.dot(points[after].place - points[middle - 1].place) < 0;
}

StudiedPiece study(const SurfaceModel& model, const LineBorders& borders, SurfaceLine& piece,
                   std::uint32_t index, const LampLevels& lamps) {
    if (runs_backwards(model, piece, lamps))
        std::reverse(piece.line.points.begin(), piece.line.points.end());
    StudiedPiece studied{courses_of(model, piece, lamps), {}};
    if (piece.line.closed) return studied;
    for (const bool tail : {false, true})
        studied.ends[tail] = borders.end_of(piece, index, !tail, lamps);
    return studied;
}

/// True if a break inside a face is larger than the digits of files explain, like those of knot
/// lines.
bool worth_telling(const LineCrossing& crossing) {
    constexpr double gap = 1e-4, angle = 1e-4, kink = 0.06;
    return crossing.border.seam != no_index || crossing.gap > gap || crossing.angle > angle ||
           std::abs(crossing.kink.value) > kink;
}

bool worse(const LineCrossing& a, const LineCrossing& b) {
    if (a.verdict != b.verdict) return a.verdict > b.verdict; // none is the least
    return a.severity > b.severity;
}

class LineJoiner {
public:
    LineJoiner(const SurfaceModel& model, const LineSeams& seams,
               std::span<const LineSource> sources, const Camera& camera, LineLook look,
               const FaceLimits& limits, const Job& job)
        : model_(model),
          seams_(seams),
          limits_(limits),
          job_(job),
          continuing_(seams.curves, seams.seams, seams.chains, seams.join_distance) {
        const Vec3 body = material_bounds(model, job).center();
        for (const LineSource& source : sources)
            lamps_.push_back(lamp_levels(look, LineEye(camera), source, body));
    }

    JoinedLines run(std::vector<SurfaceLine> pieces) {
        result_.pieces = std::move(pieces);
        study_all();
        pair();
        chain();
        measure();
        leave_out();
        shape();
        std::stable_sort(result_.crossings.begin(), result_.crossings.end(), worse);
        return std::move(result_);
    }

private:
    const LampLevels& lamps_of(const SurfaceLine& piece) const { return lamps_[piece.plane]; }

    void study_all();
    void pair();
    void chain();
    void follow(std::uint32_t first);
    void measure();
    void leave_out();
    std::array<PlacedFace, 2> sides_at(const LineBorder& border) const;
    const CriteriaPreset& limits_at(const LineBorder& border) const;
    RunOutPlaces run_outs_of(std::uint32_t chain, const FaceSizes& sizes) const;
    void excuse_run_outs();
    void add_inflections(JoinedLine& line, const LineStatistics& shape,
                         std::span<const CourseAt> courses, std::span<const std::uint32_t> pieces,
                         double along) const;
    void shape();
    std::string faces_at(const LineBorder& border) const;
    void name(LineCrossing& crossing) const;

    const SurfaceModel& model_;
    const LineSeams& seams_;
    const FaceLimits& limits_;
    const Job& job_;
    ContinuingLines continuing_;
    std::vector<LampLevels> lamps_;
    JoinedLines result_;
    std::vector<StudiedPiece> studied_;
    std::vector<LineEndpoint> meetings_;
    std::vector<LinePair> pairs_;
    std::vector<std::uint32_t> next_, before_, line_of_; ///< by piece
    std::vector<bool> breaks_after_;                     ///< by piece: a crossing is reported there
};

void LineJoiner::study_all() {
    const LineBorders borders(model_, seams_.curves, seams_.seams, seams_.chains);
    studied_.resize(result_.pieces.size());
    parallel_for(result_.pieces.size(), job_, "joints", [&](std::size_t i) {
        SurfaceLine& piece = result_.pieces[i];
        studied_[i] = study(model_, borders, piece, static_cast<std::uint32_t>(i), lamps_of(piece));
    });
}

void LineJoiner::pair() {
    for (const StudiedPiece& piece : studied_)
        for (const LineBorders::End& end : piece.ends)
            meetings_.insert(meetings_.end(), end.meetings.begin(), end.meetings.end());
    pairs_ = pair_meetings(meetings_, limits_.preset().feature_angle);
    next_.assign(studied_.size(), no_index);
    before_.assign(studied_.size(), no_index);
    for (const LinePair& pair : pairs_) {
        next_[meetings_[pair.tail].piece] = meetings_[pair.head].piece;
        before_[meetings_[pair.head].piece] = meetings_[pair.tail].piece;
    }
}

void LineJoiner::chain() {
    line_of_.assign(studied_.size(), no_index);
    for (std::uint32_t i = 0; i < studied_.size(); ++i)
        if (before_[i] == no_index) follow(i);
    for (std::uint32_t i = 0; i < studied_.size(); ++i)
        if (line_of_[i] == no_index) follow(i);
    std::vector<std::uint32_t> order(result_.lines.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto key = [&](std::uint32_t i) {
        const JoinedLine& line = result_.lines[i];
        return std::tuple(line.plane, line.lamp, line.pieces.front());
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<JoinedLine> lines;
    for (const std::uint32_t i : order) {
        for (const std::uint32_t piece : result_.lines[i].pieces)
            line_of_[piece] = static_cast<std::uint32_t>(lines.size());
        lines.push_back(std::move(result_.lines[i]));
    }
    result_.lines = std::move(lines);
}

void LineJoiner::follow(std::uint32_t first) {
    const SurfaceLine& piece = result_.pieces[first];
    JoinedLine line{piece.plane, piece.lamp, LineEnd::closed, LineEnd::closed, {}, 0, {}, {}};
    std::uint32_t i = first;
    do {
        line.pieces.push_back(i);
        line.length += length_of(result_.pieces[i].line);
        line_of_[i] = 0;
        i = next_[i];
    } while (i != no_index && i != first);
    if (i == no_index && !piece.line.closed) {
        const auto why = [&](std::uint32_t index, bool head) {
            const SurfaceLine& ending = result_.pieces[index];
            return line_end(model_, ending, head, studied_[index].ends[head ? 0 : 1],
                            lamps_of(ending).field, limits_.preset().feature_angle);
        };
        line.begin = why(first, true);
        line.end = why(line.pieces.back(), false);
    }
    result_.lines.push_back(std::move(line));
}

void LineJoiner::measure() {
    std::vector<LineCrossing> found(pairs_.size());
    parallel_for(pairs_.size(), job_, "crossings", [&](std::size_t i) {
        const LineEndpoint &tail = meetings_[pairs_[i].tail], &head = meetings_[pairs_[i].head];
        found[i] = line_crossing(tail, head, lamps_[tail.plane], limits_at(tail.border).lines);
    });
    breaks_after_.assign(studied_.size(), false);
    for (LineCrossing& crossing : found) {
        if (!worth_telling(crossing)) continue;
        breaks_after_[crossing.from] = true;
        result_.crossings.push_back(std::move(crossing));
    }
    for (std::uint32_t i = 0; i < studied_.size(); ++i)
        for (const bool tail : {false, true}) {
            if ((tail ? next_ : before_)[i] != no_index) continue;
            for (const LineEndpoint& m : studied_[i].ends[tail].meetings) {
                const bool jumps = m.border.seam != no_index && std::isfinite(m.jump) &&
                                   m.angle <= limits_.preset().feature_angle;
                if (!jumps) continue;
                result_.crossings.push_back(
                    line_break(m, lamps_[m.plane], limits_at(m.border).lines));
                break;
            }
        }
    for (LineCrossing& crossing : result_.crossings) name(crossing);
    excuse_run_outs();
}

/// Takes out crossings between faces that are not judged. Their lines stay as they are.
void LineJoiner::leave_out() {
    result_.out_of_scope = std::erase_if(result_.crossings, [&](const LineCrossing& crossing) {
        const std::array<PlacedFace, 2> sides = sides_at(crossing.border);
        return !limits_.in_scope(sides[0], sides[1]);
    });
}

std::array<PlacedFace, 2> LineJoiner::sides_at(const LineBorder& border) const {
    const PlacedFace inside{border.instance, border.face};
    if (border.seam == no_index) return {inside, inside};
    const Seam& seam = seams_.seams[seams_.chains[border.seam].front()];
    return {PlacedFace{seam.a.instance, seam.a.face}, PlacedFace{seam.b.instance, seam.b.face}};
}

const CriteriaPreset& LineJoiner::limits_at(const LineBorder& border) const {
    const std::array<PlacedFace, 2> sides = sides_at(border);
    return limits_.between(sides[0], sides[1]);
}

RunOutPlaces LineJoiner::run_outs_of(std::uint32_t chain, const FaceSizes& sizes) const {
    std::vector<SeamProbe> pieces;
    for (const std::uint32_t piece : seams_.chains[chain])
        pieces.emplace_back(seams_.curves, seams_.seams[piece]);
    const Seam& first = seams_.seams[seams_.chains[chain].front()];
    return {pieces,
            stretch_limits(sizes.of(first.a.instance, first.a.face),
                           sizes.of(first.b.instance, first.b.face), limits_at({.seam = chain}),
                           seams_.join_distance),
            [&] { return continuing_.beyond(chain); }};
}

/// Excuses jumps of lines where a crease fades out: the seam's own verdict states whether it fades
/// well.
void LineJoiner::excuse_run_outs() {
    std::map<std::uint32_t, std::vector<LineCrossing*>> by_chain;
    for (LineCrossing& crossing : result_.crossings)
        if (crossing.border.seam != no_index && crossing.verdict &&
            *crossing.verdict != Verdict::pass && crossing.angle > limits_at(crossing.border).angle)
            by_chain[crossing.border.seam].push_back(&crossing);
    if (by_chain.empty()) return;
    const FaceSizes sizes(seams_.curves);
    const std::vector<std::pair<std::uint32_t, std::vector<LineCrossing*>>> chains(by_chain.begin(),
                                                                                   by_chain.end());
    parallel_for(chains.size(), job_, "run-outs", [&](std::size_t i) {
        constexpr double beside = 0.01; // mm: of a chord from its curve
        const RunOutPlaces run_outs = run_outs_of(chains[i].first, sizes);
        for (LineCrossing* crossing : chains[i].second)
            if (run_outs.hold(crossing->place, crossing->gap + beside))
                crossing->run_out = true, crossing->verdict.reset(), crossing->severity = 0;
    });
}

void LineJoiner::name(LineCrossing& crossing) const {
    crossing.line = line_of_[crossing.from];
    crossing.faces = faces_at(crossing.border);
}

std::string LineJoiner::faces_at(const LineBorder& border) const {
    if (border.seam != no_index) {
        const Seam& seam = seams_.seams[seams_.chains[border.seam].front()];
        return faces_at_seam(model_, {seam.a.instance, seam.a.face},
                             {seam.b.instance, seam.b.face});
    }
    return line_inside_face(model_, {border.instance, border.face}, border.constant_u, border.at);
}

/// Adds the inflections of one stretch, which begins `along` mm after the line does. `pieces`: one
/// a course.
void LineJoiner::add_inflections(JoinedLine& line, const LineStatistics& shape,
                                 std::span<const CourseAt> courses,
                                 std::span<const std::uint32_t> pieces, double along) const {
    std::size_t reached = 0;
    for (const std::size_t i : shape.inflections) {
        for (; reached < i; ++reached) along += courses[reached + 1].step;
        const bool inside = i + 1 < courses.size() && pieces[i] == pieces[i + 1];
        LineInflection found{0, courses[i].at.place};
        if (inside)
            found = inflection_between(model_, result_.pieces[pieces[i]], lamps_[line.plane],
                                       courses[i].at, courses[i + 1].at);
        line.inflections.push_back({along + found.along, found.place});
    }
}

void LineJoiner::shape() {
    parallel_for(result_.lines.size(), job_, "shapes", [&](std::size_t i) {
        JoinedLine& line = result_.lines[i];
        std::vector<CourseAt> courses;
        std::vector<std::uint32_t> pieces; // one a course
        double along = 0;
        for (const std::uint32_t piece : line.pieces) {
            const std::vector<CourseAt>& some = studied_[piece].courses;
            courses.insert(courses.end(), some.begin(), some.end());
            pieces.resize(courses.size(), piece);
            if (piece != line.pieces.back() && !breaks_after_[piece]) continue;
            line.shapes.push_back(line_shape(courses, lamps_[line.plane].step(line.lamp)));
            add_inflections(line, line.shapes.back(), courses, pieces, along);
            along += line.shapes.back().length;
            courses.clear(), pieces.clear();
        }
    });
}

} // namespace

LineSeams::LineSeams(const SurfaceModel& model, double join, const Job& job)
    : seams(pair_seams(model, join, job)),
      curves(model),
      chains(seam_chains(curves, seams, join)),
      join_distance(join) {}

JoinedLines join_lines(const SurfaceModel& model, const LineSeams& seams,
                       std::vector<SurfaceLine> pieces, std::span<const LineSource> sources,
                       const Camera& camera, LineLook look, const FaceLimits& limits,
                       const Job& job) {
    return LineJoiner(model, seams, sources, camera, look, limits, job).run(std::move(pieces));
}

} // namespace keiko
