#include "keiko/report/content/curve_sets.h"

#include "keiko/geometry/bezier/interpolation.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/report/content/contour_set.h"
#include "keiko/report/content/verdict_color.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace keiko {
namespace {

/// Points of a curve between places where it may break.
using Run = std::vector<Vec3>;

/// mm: ends of pieces on neighbouring patches that are one place, each found by itself.
constexpr double same_place = 1e-6;

/// The runs of the pieces of a curve: pieces on one face that meet are one run.
class Runs {
public:
    /// Adds a piece; `joined`: on the face of the piece before, without a break between them.
    void add(Run points, bool joined) {
        const bool meets = joined && !runs_.empty() &&
                           (runs_.back().back() - points.front()).length() <= same_place;
        if (meets)
            runs_.back().insert(runs_.back().end(), points.begin() + 1, points.end());
        else if (points.size() > 1)
            runs_.push_back(std::move(points));
    }
    const std::vector<Run>& all() const { return runs_; }

private:
    std::vector<Run> runs_;
};

std::string with_deviation(const std::string& name, double deviation) {
    std::ostringstream text;
    constexpr int digits = 3;
    text.precision(digits);
    text << name << ", within " << deviation << " mm";
    return text.str();
}

/// The points without those at the same place as the one before, its ends kept: a spline's knots
/// must not crowd.
Run thinned(const Run& run) {
    Run kept{run.front()};
    for (const Vec3& point : run)
        if ((point - kept.back()).length() > same_place) kept.push_back(point);
    if (kept.size() > 1) kept.back() = run.back();
    return kept;
}

/// The curve through runs of points whose chords lie within `chord_error` mm of it.
NamedCurve fitted_curve(const std::string& name, const std::vector<Run>& runs, double chord_error) {
    NamedCurve curve{name};
    double departure = 0;
    const double allowed = 3 * chord_error + same_place;
    for (const Run& run : runs) {
        const Run points = thinned(run);
        if (points.size() < 2) continue;
        InterpolatedCurve fit = interpolating_spline(points);
        if (!(fit.departure <= allowed)) fit = interpolating_polyline(points);
        departure = std::max(departure, fit.departure);
        curve.pieces.push_back(std::move(fit.curve));
    }
    curve.deviation = chord_error + departure + same_place;
    curve.name = with_deviation(name, curve.deviation);
    return curve;
}

/// Verdict and breaks of a line by the crossings of its view.
struct LineCrossings {
    std::optional<Verdict> worst;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> breaks; ///< pieces from and to

    LineCrossings(const JoinedLines& found, std::uint32_t line) {
        for (const LineCrossing& crossing : found.crossings) {
            if (crossing.line != line) continue;
            breaks.emplace_back(crossing.from, crossing.to);
            if (crossing.verdict)
                worst = std::max(worst.value_or(*crossing.verdict), *crossing.verdict);
        }
    }
    bool between(std::uint32_t from, std::uint32_t to) const {
        return std::find(breaks.begin(), breaks.end(), std::pair(from, to)) != breaks.end();
    }
};

Run points_of(const SurfaceLine& piece) {
    Run points;
    for (const LinePoint& point : piece.line.points) points.push_back(point.place);
    return points;
}

Run points_of(const CombPiece& piece) {
    Run points;
    for (const CombSample& sample : piece.samples) points.push_back(sample.place);
    return points;
}

template <class Piece>
bool on_one_face(const Piece& a, const Piece& b) {
    return a.instance == b.instance && a.face == b.face;
}

std::string line_name(LineLook look, std::size_t number, const ViewLines& view,
                      const JoinedLine& line, const std::optional<Verdict>& verdict) {
    std::ostringstream text;
    text << name_of(look) << " line " << number << ": "
         << (verdict ? std::string(name_of(*verdict)) : "not judged") << ", " << view.view
         << ", plane " << line.plane << ", lamp " << line.lamp;
    return text.str();
}

NamedCurve curve_of(const LineList& list, const ViewLines& view, std::uint32_t index,
                    std::size_t number) {
    const JoinedLine& line = view.found.lines[index];
    const LineCrossings crossings(view.found, index);
    Runs runs;
    double deviation = 0;
    for (std::size_t i = 0; i < line.pieces.size(); ++i) {
        const SurfaceLine& piece = view.found.pieces[line.pieces[i]];
        deviation = std::max(deviation, piece.line.deviation);
        const bool joined = i > 0 && on_one_face(piece, view.found.pieces[line.pieces[i - 1]]) &&
                            !crossings.between(line.pieces[i - 1], line.pieces[i]);
        runs.add(points_of(piece), joined);
    }
    const std::string name = line_name(list.look, number, view, line, crossings.worst);
    NamedCurve curve = fitted_curve(name, runs.all(), deviation);
    curve.color = verdict_color(crossings.worst);
    return curve;
}

NamedCurve curve_of(const CombCurve& comb, double chord_error) {
    Runs runs;
    for (std::size_t i = 0; i < comb.pieces.size(); ++i)
        runs.add(points_of(comb.pieces[i]),
                 i > 0 && on_one_face(comb.pieces[i], comb.pieces[i - 1]));
    const bool section = comb.kind == CombCurve::Kind::section;
    return fitted_curve((section ? "section " : "") + comb.name, runs.all(), chord_error);
}

/// mm, about how far a curve is from the chords of its points: a chord of two steps is four times
/// as far as those of one.
double chord_distance(const Run& run) {
    double largest = 0;
    for (std::size_t i = 1; i + 1 < run.size(); ++i)
        largest = std::max(largest, segment_distance(run[i - 1], run[i + 1], run[i]) / 4);
    return largest;
}

NamedCurve curve_of(const MeasuredSeam& seam, std::size_t number, bool is_accepted) {
    Runs runs;
    double chord_error = 0;
    for (const Run& piece : seam.course) {
        chord_error = std::max(chord_error, chord_distance(piece));
        runs.add(piece, true);
    }
    const std::string verdict = is_accepted ? "accepted" : std::string(name_of(seam.verdict));
    NamedCurve curve = fitted_curve("seam " + std::to_string(number) + ": " + verdict + ", " +
                                        std::string(name_of(seam.kind)) + ", " + seam.faces,
                                    runs.all(), chord_error);
    curve.color = verdict_color(seam.verdict);
    return curve;
}

} // namespace

std::vector<NamedCurve> contour_set(const SurfaceModel& model, const std::string& view,
                                    std::span<const ContourLine> contours) {
    std::vector<NamedCurve> curves;
    for (const ContourLine& contour : contours)
        curves.push_back(fitted_curve(
            "contour: " + view + ", " + placed_face_name(model, contour.instance, contour.face),
            {contour.points}, contour.deviation));
    return curves;
}

CurveSet line_curves(const LineList& list) {
    CurveSet set{list.rig};
    std::size_t number = 0;
    for (const ViewLines& view : list.views)
        for (std::uint32_t i = 0; i < view.found.lines.size(); ++i)
            set.curves.push_back(curve_of(list, view, i, number++));
    std::erase_if(set.curves, [](const NamedCurve& curve) { return curve.pieces.empty(); });
    return set;
}

CurveSet inspection_curves(const Inspection& inspection, std::span<const CombCurve> combs,
                           double chord_error) {
    CurveSet set{inspection.facts.source};
    for (const CombCurve& comb : combs) set.curves.push_back(curve_of(comb, chord_error));
    for (const MeasuredFace& face : inspection.faces)
        for (const InflectionCurve& inflection : face.inflections)
            set.curves.push_back(fitted_curve(face.name + ": inflection", {inflection.points},
                                              inflection.deviation));
    for (std::size_t i = 0; i < inspection.seams.size(); ++i)
        if (const MeasuredSeam& seam = inspection.seams[i]; !seam.scrap)
            set.curves.push_back(
                curve_of(seam, i + 1, is_accepted_seam(inspection, static_cast<std::uint32_t>(i))));
    std::erase_if(set.curves, [](const NamedCurve& curve) { return curve.pieces.empty(); });
    return set;
}

} // namespace keiko
