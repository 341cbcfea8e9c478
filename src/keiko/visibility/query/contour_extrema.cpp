#include "keiko/visibility/query/contour_extrema.h"

#include "keiko/geometry/bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {

namespace {

constexpr int most_halvings = 7;
/// Share of the permitted loss that lines too short to be followed may take.
constexpr double of_short = 0.25;

} // namespace

ContourExtrema::ContourExtrema(const Viewpoint& viewpoint, const ScanPlane& screen,
                               const ScanBounds& prism, const ViewVolume& volume,
                               const ParameterInterval& ends, const TurnRule& rule)
    : viewpoint_(viewpoint),
      screen_(screen),
      volume_(volume),
      prism_(prism),
      begin_(std::min(ends.begin, ends.end)),
      length_(std::abs(ends.length())),
      width_(prism.across_high - prism.across_low),
      spacing_(rule.spacing),
      missed_(rule.missed) {}

void ContourExtrema::add_border(const BoundaryPiece& border) {
    follow(border, {border.curve, true, true}, false, most_halvings);
}

void ContourExtrema::add_fold(const BoundaryPiece& line) {
    follow(line, {line.curve, true, true}, true, most_halvings);
}

void ContourExtrema::add_unclear(const ScanBounds& box) {
    const double run = std::min((box.along_high - box.along_low) / length_, 1.0);
    for (const double across : {box.across_low, box.across_high})
        add((across - prism_.across_low) / width_, run * spacing_ / 2, 0, true);
}

bool ContourExtrema::leaves_out(const ScanBounds& box) {
    const double missed = (box.along_high - box.along_low) / length_ * spacing_ / 2;
    if (!(left_out_ + missed <= of_short * missed_)) return false;
    left_out_ += missed;
    return true;
}

double ContourExtrema::most_slope() const {
    constexpr double few = 4;
    return missed_ / few / kink(1) * length_ / width_;
}

bool ContourExtrema::Run::steep() const {
    constexpr double most = 10; // from one side of a cut to the other it changes by 1e-5
    return std::abs(slope()) > most;
}

void ContourExtrema::add(double across, double weight, int dark, bool jump) {
    if (across > 0 && across < 1) turns_.push_back({across, weight, dark, jump});
}

/// Across and along in widths and lengths of the prism.
ScreenPlace ContourExtrema::place(const Vec3& x) const {
    ScreenPlace place = screen_.place(x);
    place.across = (place.across - prism_.across_low) / width_;
    place.along = (place.along - begin_) / length_;
    return place;
}

/// Side across on which the surface lies that ends or folds at a line.
int ContourExtrema::dark_side(const BoundaryPiece& line, const BoundaryPiece::Curve& curve) const {
    constexpr double sure = 0.01;
    if (!(line.inward_error < 1)) return 0;
    const Vec3 way = line.center + (curve.front() + curve.back()) * 0.5 - viewpoint_.place();
    const Vec3& inward = line.inward[1];
    const Vec3 z = screen_.way_at(0);
    const double rise =
        screen_.across().dot(inward) * z.dot(way) - screen_.across().dot(way) * z.dot(inward);
    if (!(std::abs(rise) > sure * z.dot(way))) return 0;
    return rise > 0 ? 1 : -1;
}

ContourExtrema::Shown ContourExtrema::shown(const BoundaryPiece& line,
                                            const BoundaryPiece::Curve& curve) const {
    Shown shown;
    std::array<ScreenPlace, BoundaryPiece::points> places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = place(line.center + curve[i]);
        shown.before = shown.before && places[i].depth > 0;
        shown.behind = shown.behind && places[i].depth < -line.error;
        shown.box.across_low = std::min(shown.box.across_low, places[i].across);
        shown.box.across_high = std::max(shown.box.across_high, places[i].across);
        shown.box.along_low = std::min(shown.box.along_low, places[i].along);
        shown.box.along_high = std::max(shown.box.along_high, places[i].along);
    }
    const ScreenPlace &a = places.front(), &b = places.back();
    const double up = b.across >= a.across ? 1 : -1, on = b.along >= a.along ? 1 : -1;
    for (std::size_t i = 1; i < places.size(); ++i) {
        shown.back_across += std::max((places[i - 1].across - places[i].across) * up, 0.0);
        shown.back_along += std::max((places[i - 1].along - places[i].along) * on, 0.0);
    }
    shown.run = {a.across, b.across, a.along, b.along};
    return shown;
}

bool ContourExtrema::is_even(const Shown& seen) const {
    return seen.before && seen.back_across <= one_place && seen.back_along <= one_place;
}

/// The ways by which a line runs back hide no more than their boxes.
bool ContourExtrema::is_nearly_even(const Shown& seen) {
    if (!seen.before) return false;
    const auto inside = [](double low, double high) {
        return std::max(std::min(high, 1.0) - std::max(low, 0.0), 0.0);
    };
    const double missed = seen.back_across * inside(seen.box.along_low, seen.box.along_high) +
                          seen.back_along * inside(seen.box.across_low, seen.box.across_high);
    if (!(left_out_ + missed <= of_short * missed_)) return false;
    left_out_ += missed;
    return true;
}

/// Parameter where a line turns back, by the parabola through its ends and its middle.
double ContourExtrema::turn_of(const BoundaryPiece& line, const BoundaryPiece::Curve& curve,
                               const Shown& seen) const {
    constexpr double middle = 0.5, nearest_to_end = 1e-3;
    if (!seen.before) return middle;
    const ScreenPlace half = place(line.center + point_on(curve, middle));
    const bool across = seen.back_across > one_place;
    const double a = across ? seen.run.a : seen.run.from, c = across ? seen.run.b : seen.run.to;
    const double b = across ? half.across : half.along;
    const double turn = (3 * a - 4 * b + c) / (4 * (a - 2 * b + c));
    return turn > nearest_to_end && turn < 1 - nearest_to_end ? turn : middle;
}

void ContourExtrema::follow(const BoundaryPiece& line, const Part& part, bool fold, int halvings) {
    Shown seen = shown(line, part.curve);
    if (seen.behind) return;
    static constexpr ScanBounds whole{-0.1, 1.1, 0, 1}; // its ends are not quite straight
    if (seen.before && !seen.box.overlaps(whole)) return;
    const bool even = is_even(seen);
    if (even && seen.within_ends() && !seen.run.ends_inside()) return;
    ViewVolume::Sides sides = volume_.all_sides();
    if (!volume_.may_hold(part.curve, line.center, line.error, sides)) return;
    const bool known_edge_on = fold || (part.begins && part.ends);
    if (!known_edge_on && !line.may_be_edge_on(viewpoint_, part.curve)) return;
    if (even || is_nearly_even(seen) || (seen.before && halvings == 0)) {
        seen.run.dark = dark_side(line, part.curve);
        return add_run(clipped(line, part.curve, seen.run), part);
    }
    if (halvings == 0) return;
    const auto [low, high] = bernstein_parts(part.curve, turn_of(line, part.curve, seen));
    follow(line, {low, part.begins, false}, fold, halvings - 1);
    follow(line, {high, false, part.ends}, fold, halvings - 1);
}

/// Across, where a line that runs past the place `along` once does so: false position with the
/// Illinois weight [DowellJarratt1971].
double ContourExtrema::where(const BoundaryPiece& line, const BoundaryPiece::Curve& curve,
                             double along) const {
    const auto at = [&](double t) { return place(line.center + point_on(curve, t)); };
    double low = 0, high = 1;
    double off_low = at(low).along - along, off_high = at(high).along - along;
    constexpr int most_steps = 40;
    constexpr double settled = 1e-9;
    double across = at(0.5).across;
    int last = 0;
    for (int i = 0; i < most_steps && off_low != off_high; ++i) {
        const double t = low + (high - low) * std::clamp(off_low / (off_low - off_high), 0.0, 1.0);
        const ScreenPlace next = at(t);
        across = next.across;
        const double off = next.along - along;
        if (!(std::abs(off) > settled)) break;
        const bool is_low = (off < 0) == (off_low < 0);
        (is_low ? low : high) = t;
        (is_low ? off_low : off_high) = off;
        const int side = is_low ? -1 : 1;
        if (side == last) (is_low ? off_high : off_low) /= 2;
        last = side;
    }
    return across;
}

/// Part of a run between the ends of the prism, at which it turns.
ContourExtrema::Run ContourExtrema::clipped(const BoundaryPiece& line,
                                            const BoundaryPiece::Curve& curve, Run run) {
    const Run whole = run;
    for (const double end : {0.0, 1.0}) {
        if ((whole.from < end) == (whole.to < end)) continue;
        const double across = where(line, curve, end);
        if ((whole.from < end) == (end == 0))
            run.a = across, run.from = end, run.begins = false;
        else
            run.b = across, run.to = end, run.ends = false;
    }
    return run;
}

/// Share of the prism's light that lines one spacing apart may miss if they do not know one end of
/// a run.
double ContourExtrema::weight(const Run& run) const {
    const double all = std::abs(run.to - run.from), across = std::abs(run.b - run.a);
    const double inside = std::max(
        std::min(std::max(run.a, run.b), 1.0) - std::max(std::min(run.a, run.b), 0.0), 0.0);
    if (!(across > one_place)) return all * spacing_ / 2;
    return std::min(kink(all / across), all * (inside / across) * spacing_ / 2);
}

void ContourExtrema::add_run(const Run& run, const Part& part) {
    // Beside the ends of the prism.
    if (std::max(run.from, run.to) <= 0 || std::min(run.from, run.to) >= 1) return;
    const double weight = this->weight(run);
    if (!(std::abs(run.b - run.a) > one_place)) return add(run.a, weight, run.dark, true);
    const int rise = run.b > run.a ? 1 : -1;
    const auto add_end = [&](double across, double along, int sign, bool within, bool whole) {
        if (!within) return add(across, weight, run.dark, run.steep());
        if (across > 0 && across < 1)
            ends_.push_back(
                {across, along, sign, run.slope(), weight, whole, run.dark, run.steep()});
    };
    add_end(run.a, run.from, rise, run.begins, part.begins);
    add_end(run.b, run.to, -rise, run.ends, part.ends);
}

/// A line runs on where one part goes up from a place and one down, except for its bend there.
std::vector<ContourExtrema::Turn> ContourExtrema::turning_ends() const {
    std::vector<Turn> turns;
    std::vector<End> ends = ends_;
    std::sort(ends.begin(), ends.end(),
              [](const End& a, const End& b) { return a.across < b.across; });
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (std::isnan(ends[i].along)) continue;
        int rise = 0;
        double bend = 0, weight = 0;
        bool whole = false, jump = false;
        int dark = ends[i].dark;
        for (std::size_t k = i; k < ends.size() && ends[k].across <= ends[i].across + one_place;
             ++k) {
            if (!(std::abs(ends[k].along - ends[i].along) <= one_place_along)) continue;
            rise += ends[k].rise, bend += ends[k].rise * ends[k].slope;
            weight += ends[k].weight, whole = whole || ends[k].whole;
            jump = jump || ends[k].jump;
            if (ends[k].dark != dark) dark = 0;
            if (k > i) ends[k].along = std::nan("");
        }
        if (rise == 0) weight = std::min(weight, kink(std::abs(bend)));
        if (whole || std::abs(rise) != 1) turns.push_back({ends[i].across, weight, dark, jump});
    }
    return turns;
}

/// Two faces of one edge have it twice.
std::vector<ContourExtrema::Turn> ContourExtrema::all_turns() const {
    std::vector<Turn> turns = turning_ends();
    turns.insert(turns.end(), turns_.begin(), turns_.end());
    std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
        return std::pair(a.across, a.missed) < std::pair(b.across, b.missed);
    });
    const auto is_same = [](const Turn& a, const Turn& b) {
        return b.across - a.across <= one_place && a.jump == b.jump &&
               std::abs(a.missed - b.missed) <= 1e-3 * a.missed;
    };
    turns.erase(std::unique(turns.begin(), turns.end(), is_same), turns.end());
    return turns;
}

std::vector<ContourExtrema::Turn> ContourExtrema::found() const {
    std::vector<Turn> turns = all_turns();
    std::sort(turns.begin(), turns.end(),
              [](const Turn& a, const Turn& b) { return a.missed < b.missed; });
    double missed = left_out_;
    const auto matters = [&](const Turn& turn) { return (missed += turn.missed) > missed_; };
    turns.erase(turns.begin(), std::find_if(turns.begin(), turns.end(), matters));
    for (Turn& turn : turns) turn.across = prism_.across_low + turn.across * width_;
    return turns;
}

} // namespace keiko
