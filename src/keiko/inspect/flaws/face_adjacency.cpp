#include "keiko/inspect/flaws/face_adjacency.h"

#include "keiko/base/job.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

bool is_smooth(const MeasuredSeam& seam) {
    const auto passes = [](const MeasuredValue& worst) { return worst.verdict == Verdict::pass; };
    return !seam.internal && seam.is_angle_judged() && passes(seam.gap) && seam.angle &&
           passes(*seam.angle) && (!seam.curvature || passes(seam.curvature->worst));
}

Vec2 flat(const Vec3& v) {
    return {v.x, v.y};
}

} // namespace

FaceAdjacency::FaceAdjacency(const SurfaceModel& model, std::span<const MeasuredSeam> seams,
                             std::span<const Seam> pieces, double spacing) {
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            if (model.faces[f].patch_count == 0) continue;
            index_[{i, f}] = faces_.size();
            faces_.emplace_back(model, i, f);
        }
    }
    crossings_.resize(faces_.size()), crossing_steps_.resize(faces_.size(), 0);
    DisjointSets sheets(faces_.size());
    const BoundaryCurves curves(model);
    for (const MeasuredSeam& seam : seams) {
        if (!is_smooth(seam)) continue;
        sheets.join(index_.at({seam.instance_a, seam.face_a}),
                    index_.at({seam.instance_b, seam.face_b}));
        for (const std::uint32_t piece : seam.pieces) add_crossings(curves, pieces[piece], spacing);
    }
    for (std::size_t i = 0; i < faces_.size(); ++i) sheets_.push_back(sheets.root(i));
    poles_ = SurfacePoles(faces_, sheets_);
}

void FaceAdjacency::add_crossings(const BoundaryCurves& curves, const Seam& piece, double spacing) {
    check_stop();
    const SurfaceCurve a = curves.curve(piece.a), b = curves.curve(piece.b);
    const std::size_t face_a = index_.at({piece.a.instance, piece.a.face});
    const std::size_t face_b = index_.at({piece.b.instance, piece.b.face});
    constexpr double most = 1000;
    const double parts =
        std::clamp(std::ceil(a.length(piece.a.begin, piece.a.end) / spacing), 2.0, most);
    for (double k = 0; k <= parts; ++k) {
        const double t = piece.a.begin + k / parts * (piece.a.end - piece.a.begin);
        const double s = piece.b.begin + k / parts * (piece.b.end - piece.b.begin);
        const Vec2 on_a = faces_[face_a].place_of(a.parameters(t));
        const Vec2 on_b = faces_[face_b].place_of(b.parameters(s));
        add_crossing(face_a, {a.at(t).position, {face_b, on_b}}, k > 0);
        add_crossing(face_b, {b.at(s).position, {face_a, on_a}}, k > 0);
    }
}

void FaceAdjacency::add_crossing(std::size_t face, const Crossing& crossing, bool goes_on) {
    std::vector<Crossing>& crossings = crossings_[face];
    if (goes_on) {
        const double step = (crossing.position - crossings.back().position).length();
        crossing_steps_[face] = std::max(crossing_steps_[face], step);
    }
    crossings.push_back(crossing);
}

std::optional<TangentFrame> FaceAdjacency::frame(const SheetPoint& at,
                                                 const Vec3& direction) const {
    const auto s = evaluate(at, 1);
    return s ? frame(at, *s, direction) : std::nullopt;
}

std::optional<TangentFrame> FaceAdjacency::frame(const SheetPoint& at, const SurfaceDerivatives& s,
                                                 const Vec3& direction) const {
    Vec3 z(0);
    if (const auto normal = faces_[at.face].normal(s))
        z = *normal;
    else if (const SurfacePole* pole = pole_at(at.face, s.position()))
        z = pole->normal;
    else
        return std::nullopt;
    const Vec3 x = (direction - z * direction.dot(z)).normalized();
    return TangentFrame{s.position(), x, z.cross(x), z};
}

const SurfacePole* FaceAdjacency::pole_at(std::size_t face, const Vec3& position) const {
    constexpr double close = 0.01; // mm
    for (const std::size_t pole : poles_.of(face))
        if ((poles_.at(pole).position - position).length() < close) return &poles_.at(pole);
    return nullptr;
}

std::optional<SecondForm> FaceAdjacency::bend(const SheetPoint& at, const SurfaceDerivatives& there,
                                              const TangentFrame& frame, double aside) const {
    if (faces_[at.face].normal(there)) return second_form(there, frame.z, frame.x);
    const auto beside = moved(frame, at, Vec2(aside, 0));
    const auto s = beside ? evaluate(*beside, 2) : std::nullopt;
    if (!s || !faces_[beside->face].normal(*s)) return std::nullopt;
    return second_form(*s, frame.z, frame.x);
}

std::optional<SheetPoint> FaceAdjacency::moved(const TangentFrame& over, const SheetPoint& from,
                                               const Vec2& to) const {
    constexpr int most_crossings = 6; // a corner of several faces, or a strip
    return moved(over, from, to, no_index, most_crossings);
}

std::optional<SheetPoint> FaceAdjacency::moved(const TangentFrame& over, const SheetPoint& from,
                                               const SurfaceDerivatives& there,
                                               const Vec2& to) const {
    const auto seen = [&](const Vec3& v) { return Vec2(v.dot(over.x), v.dot(over.y)); };
    const Vec2 u = seen(there.du()), v = seen(there.dv());
    const double area = u.cross(v);
    const auto step = [&](const Vec2& off) { return Vec2(off.cross(v), u.cross(off)) / area; };
    const Vec2 first = step(to);
    const Vec3 bend = there.duu() * (first.x * first.x) + there.duv() * (2 * first.x * first.y) +
                      there.dvv() * (first.y * first.y);
    const Vec2 guess = from.place + step(to - seen(bend) / 2);
    const auto place = solved(over, {from.face, guess}, to);
    if (place && faces_[from.face].has_material(*place)) return SheetPoint{from.face, *place};
    return moved(over, from, to);
}

/// Newton's method on the surface beyond its trims.
std::optional<Vec2> FaceAdjacency::solved(const TangentFrame& over, const SheetPoint& from,
                                          const Vec2& to) const {
    constexpr int most_steps = 20;
    constexpr double close = 1e-5; // mm: the step from there leaves less than 1e-8
    Vec2 place = from.place;
    for (int i = 0; i < most_steps; ++i) {
        const auto s = faces_[from.face].evaluate_beyond(place, 1);
        if (!s) return std::nullopt;
        const Vec2 off = to - flat(over.local(s->position()));
        const Vec2 u(s->du().dot(over.x), s->du().dot(over.y));
        const Vec2 v(s->dv().dot(over.x), s->dv().dot(over.y));
        const double area = u.cross(v);
        Vec2 step(off.cross(v) / area, u.cross(off) / area);
        if (!(step.length2() < 1e6)) return std::nullopt;
        constexpr double longest = 0.7; // of a span: the next may run at another speed
        step *= std::min(1.0, longest / std::max(step.length(), 1e-300));
        place += step;
        if (std::abs(off.x) < close && std::abs(off.y) < close) return place;
    }
    return std::nullopt;
}

std::optional<SheetPoint> FaceAdjacency::moved(const TangentFrame& over, const SheetPoint& from,
                                               const Vec2& to, std::size_t barred,
                                               int crossings_left) const {
    const auto there = solved(over, from, to);
    if (there && faces_[from.face].has_material(*there)) return SheetPoint{from.face, *there};
    if (crossings_left == 0) return std::nullopt;
    if (auto across = across_pole(over, from, to, crossings_left)) return across;
    const Vec3 here = evaluate(from, 0)->position();
    constexpr double slope = 2; // a trace along the surface is longer than in the plane
    if (!has_crossing_near(from.face, here, slope * (to - flat(over.local(here))).length()))
        return std::nullopt;
    const SheetPoint last = border(over, from, to, there);
    const Vec3 gone = evaluate(last, 0)->position() - here;
    constexpr double nowhere = 1e-6; // mm: at a corner it does not lead back
    const auto next = beyond(over, last, gone.length() < nowhere ? barred : no_index);
    if (!next) return std::nullopt;
    return moved(over, *next, to, from.face, crossings_left - 1);
}

std::optional<SheetPoint> FaceAdjacency::across_pole(const TangentFrame& over,
                                                     const SheetPoint& from, const Vec2& to,
                                                     int crossings_left) const {
    const Vec2 begin = flat(over.local(evaluate(from, 0)->position())), way = to - begin;
    for (const std::size_t index : poles_.of(from.face)) {
        const SurfacePole& pole = poles_.at(index);
        const Vec2 middle = flat(over.local(pole.position)), out = to - middle;
        const double share = std::clamp((middle - begin).dot(way) / way.length2(), 0.0, 1.0);
        if (!((begin + way * share - middle).length() < way.length() / 2)) continue;
        constexpr double close = 1e-5; // mm
        if (out.length() < close) return pole.spokes.front().begin;
        const auto seen = [&](const SurfacePole::Spoke& spoke) {
            return Vec2(spoke.way.dot(over.x), spoke.way.dot(over.y));
        };
        const auto cosine = [&](const SurfacePole::Spoke& spoke) {
            return seen(spoke).dot(out) / seen(spoke).length();
        };
        const auto spoke =
            std::max_element(pole.spokes.begin(), pole.spokes.end(),
                             [&](const auto& a, const auto& b) { return cosine(a) < cosine(b); });
        constexpr double most = 0.5; // of a span
        const double steps = std::min(out.length() / seen(*spoke).length(),
                                      most / std::max(spoke->step.length(), 1e-300));
        const SheetPoint start{spoke->begin.face, spoke->begin.place + spoke->step * steps};
        // The way on may cross one more seam, not the pole again.
        if (auto at = moved(over, start, to, no_index, std::min(crossings_left - 1, 1))) return at;
    }
    return std::nullopt;
}

bool FaceAdjacency::has_crossing_near(std::size_t face, const Vec3& position, double reach) const {
    const double most = reach + crossing_steps_[face];
    const std::vector<Crossing>& crossings = crossings_[face];
    return std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& crossing) {
        return (crossing.position - position).length2() <= most * most;
    });
}

SheetPoint FaceAdjacency::border(const TangentFrame& over, const SheetPoint& from, const Vec2& to,
                                 const std::optional<Vec2>& there) const {
    SheetPoint last = from;
    const Vec2 begin = flat(over.local(evaluate(from, 0)->position()));
    double near = 0, far = 1;
    constexpr int halvings = 12; // only to find the adjacent face
    for (int i = 0; i < halvings; ++i) {
        const double middle = (near + far) / 2;
        const std::optional<Vec2> next = there ? from.place + (*there - from.place) * middle
                                               : solved(over, last, begin + (to - begin) * middle);
        const bool on = next && faces_[from.face].has_material(*next);
        (on ? near : far) = middle;
        if (on) last.place = *next;
    }
    return last;
}

std::optional<SheetPoint> FaceAdjacency::beyond(const TangentFrame& over, const SheetPoint& border,
                                                std::size_t barred) const {
    const Vec3 here = evaluate(border, 0)->position();
    const Crossing* nearest = nullptr;
    for (const Crossing& crossing : crossings_[border.face])
        if (crossing.beyond.face != barred &&
            (!nearest ||
             (crossing.position - here).length2() < (nearest->position - here).length2()))
            nearest = &crossing;
    if (!nearest) return std::nullopt;
    const auto place = solved(over, nearest->beyond, flat(over.local(here)));
    if (!place) return std::nullopt;
    const SheetPoint there{nearest->beyond.face, *place};
    constexpr double apart = 0.1; // mm: of another part of the border
    if (!((evaluate(there, 0)->position() - here).length() < apart)) return std::nullopt;
    return there;
}

} // namespace keiko
