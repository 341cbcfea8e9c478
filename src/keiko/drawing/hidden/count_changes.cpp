#include "keiko/drawing/hidden/count_changes.h"

#include "keiko/drawing/hidden/chord_crossings.h"
#include "keiko/drawing/hidden/curve_meetings.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Share of the body's size by which a curve must be nearer to hide another one.
constexpr double nearer_by = 1e-6;
/// Share of the body's size within which lines coincide: far more than rounding.
constexpr double same_line = 1e-9;

Box3 box_of(const ImagePoint& a, const ImagePoint& b) {
    Box3 box;
    for (const ImagePoint& p : {a, b}) box.extend(Vec3(p.at.x, p.at.y, p.depth));
    return box;
}

bool is_border(CurveKind kind) {
    return kind == CurveKind::edge || kind == CurveKind::crease || kind == CurveKind::seam;
}

/// Change where a curve on a face passes an outline of it: the curve goes behind the sheet before
/// it, or comes out. `run`: along the curve; `outline`: along the outline, into it if the curve is
/// the border at which it ends; `sight`: away from the eye.
int contact_change(const Vec3& run, const Vec3& outline, const Vec3& sight, bool border) {
    const double oo = outline.length2(), os = outline.dot(sight), ss = sight.length2();
    const double ro = run.dot(outline), rs = run.dot(sight), area = oo * ss - os * os;
    if (!(area > 0)) return 0;
    const double along = (ro * ss - rs * os) / area, away = (rs * oo - ro * os) / area;
    const bool covered = !border || along * away > 0;
    return covered ? (away > 0 ? 1 : -1) : 0;
}

} // namespace

OccluderImage::OccluderImage(const ImageProjection& projection,
                             std::span<const OccludingCurve> borders,
                             std::span<const OccludingCurve> outlines, double size,
                             double chord_error)
    : projection_(projection),
      size_(size),
      chord_error_(chord_error),
      chords_(chords_of(projection, borders, outlines)),
      tree_(boxes_of(chords_)),
      nearest_(Box3::infinity),
      image_error_(0) {
    for (const OccludingCurve& curve : outlines)
        outlines_[{curve.face.instance, curve.face.face}].push_back(&curve);
    for (const Chord& chord : chords_)
        nearest_ = std::min({nearest_, chord.a.depth, chord.b.depth});
    image_error_ = projection.parallel() ? chord_error : chord_error / nearest_;
}

std::vector<OccluderImage::Chord> OccluderImage::chords_of(
    const ImageProjection& projection, std::span<const OccludingCurve> borders,
    std::span<const OccludingCurve> outlines) {
    std::vector<Chord> chords;
    for (const auto& curves : {borders, outlines})
        for (const OccludingCurve& curve : curves) {
            ImagePoint last = projection.image(curve.course.points.front());
            for (std::uint32_t i = 0; i + 1 < curve.course.points.size(); ++i) {
                const ImagePoint next = projection.image(curve.course.points[i + 1]);
                chords.push_back({&curve, i, last, next});
                last = next;
            }
        }
    return chords;
}

std::vector<Box3> OccluderImage::boxes_of(std::span<const Chord> chords) {
    std::vector<Box3> boxes;
    for (const Chord& chord : chords) boxes.push_back(box_of(chord.a, chord.b));
    return boxes;
}

std::vector<CountChange> OccluderImage::along(const ModelCurve& curve) const {
    std::vector<CountChange> changes;
    add_crossings(curve, changes);
    add_contacts(curve, changes);
    add_cusps(curve, changes);
    add_piercings(curve, changes);
    std::stable_sort(changes.begin(), changes.end(),
                     [](const CountChange& a, const CountChange& b) { return a.t < b.t; });
    return changes;
}

void OccluderImage::add_crossings(const ModelCurve& curve,
                                  std::vector<CountChange>& changes) const {
    std::vector<std::pair<CountChange, const void*>> found;
    const std::vector<Vec3>& points = curve.course.points;
    ImagePoint last = projection_.image(points.front());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const ImagePoint next = projection_.image(points[i + 1]);
        Box3 box = box_of(last, next);
        const Vec3 bulges(2 * image_error_, 2 * image_error_, 2 * chord_error_);
        box.lower -= bulges, box.upper += bulges;
        box.lower.z = nearest_;
        for (const std::uint32_t k : tree_.overlapping(box))
            add_crossing(curve, i, chords_[k], found);
        last = next;
    }
    constexpr double same = 1e-8; // of the parameter: chords beside each other find one crossing
    for (std::size_t k = 0; k < found.size(); ++k) {
        const auto known = [&](const auto& other) {
            return other.second == found[k].second &&
                   std::abs(other.first.t - found[k].first.t) <= same;
        };
        const auto here = found.begin() + static_cast<std::ptrdiff_t>(k);
        if (std::none_of(found.begin(), here, known)) changes.push_back(found[k].first);
    }
}

void OccluderImage::add_crossing(const ModelCurve& curve, std::size_t i, const Chord& chord,
                                 std::vector<std::pair<CountChange, const void*>>& found) const {
    const CurveCourse& other = chord.curve->course;
    const double least = nearer_by * size_ + curve.reach;
    for (const CurveMeeting& near :
         chord_crossings(curve.course, i, other, chord.index, projection_,
                         {.bulge = image_error_,
                         .least = least - 2 * chord_error_,
                         .same = same_line * size_ * image_error_ / chord_error_})) {
        const auto exact = image_crossing(curve.course, other, near, projection_);
        if (!exact) continue;
        const double ahead = projection_.image(curve.course.at(exact->t)).depth -
                             projection_.image(other.at(exact->u)).depth;
        if (!(ahead > least)) continue;
        found.push_back(
            {{exact->t, crossing_change(curve, exact->t, *chord.curve, exact->u)}, chord.curve});
    }
}

int OccluderImage::crossing_change(const ModelCurve& curve, double t, const OccludingCurve& before,
                                   double u) const {
    const Vec3 place = curve.course.at(t), over = before.course.at(u);
    const Vec2 run = projection_.image_direction(place, curve.course.derivative(t));
    const Vec2 border = projection_.image_direction(over, before.course.derivative(u));
    const Vec2 inward = projection_.image_direction(over, before.inward_at(u));
    const double sheets = border.cross(inward) * border.cross(run);
    return sheets > 0 ? before.sheets : sheets < 0 ? -before.sheets : 0;
}

void OccluderImage::add_contacts(const ModelCurve& curve, std::vector<CountChange>& changes) const {
    if (curve.kind == CurveKind::outline) return;
    for (const PlacedFace& face : curve.faces) {
        const auto own = outlines_.find({face.instance, face.face});
        if (own == outlines_.end()) continue;
        for (const OccludingCurve* outline : own->second)
            if (is_border(curve.kind))
                add_ends_on(curve, *outline, changes);
            else
                add_meetings(curve, *outline, changes);
    }
}

void OccluderImage::add_ends_on(const ModelCurve& curve, const OccludingCurve& outline,
                                std::vector<CountChange>& changes) const {
    for (const bool last : {false, true}) {
        const double u = last ? outline.course.end() : 0;
        const Vec3 end = outline.course.at(u);
        const CurveMeeting nearest = nearest_on(curve.course, end);
        if (!(nearest.distance <= nearer_by * size_ + curve.reach)) continue;
        const Vec3 into = outline.course.derivative(u) * (last ? -1 : 1);
        changes.push_back({nearest.t, contact_change(curve.course.derivative(nearest.t), into,
                                                     projection_.sight(end), true)});
    }
}

void OccluderImage::add_meetings(const ModelCurve& curve, const OccludingCurve& outline,
                                 std::vector<CountChange>& changes) const {
    const double near = nearer_by * size_ + curve.reach;
    const std::size_t known = changes.size();
    for (std::size_t i = 0; i + 1 < curve.course.points.size(); ++i)
        for (std::size_t j = 0; j + 1 < outline.course.points.size(); ++j) {
            const CurveMeeting chords = chord_approach(curve.course, i, outline.course, j);
            if (!(chords.distance <= near + 2 * chord_error_)) continue;
            const CurveMeeting found = approach(curve.course, outline.course, chords);
            if (!(found.distance <= near)) continue;
            const bool again = std::any_of(
                changes.begin() + static_cast<std::ptrdiff_t>(known), changes.end(),
                [&](const CountChange& other) { return std::abs(other.t - found.t) <= 1e-3; });
            if (again) continue;
            const int change =
                contact_change(curve.course.derivative(found.t), outline.course.derivative(found.u),
                               projection_.sight(curve.course.at(found.t)), false);
            changes.push_back({found.t, change});
        }
}

void OccluderImage::add_cusps(const ModelCurve& curve, std::vector<CountChange>& changes) const {
    for (const double t : curve.cusps) {
        const Vec3 run = curve.course.derivative(t);
        const bool away = run.dot(projection_.sight(curve.course.at(t))) > 0;
        changes.push_back({t, away ? 1 : -1});
    }
}

void OccluderImage::add_piercings(const ModelCurve& curve,
                                  std::vector<CountChange>& changes) const {
    for (const Piercing& piercing : curve.piercings) {
        const Vec3 sight = projection_.sight(curve.course.at(piercing.t));
        const double through = curve.course.derivative(piercing.t).dot(piercing.normal);
        changes.push_back({piercing.t, through * sight.dot(piercing.normal) > 0 ? 1 : -1});
    }
}

} // namespace keiko
