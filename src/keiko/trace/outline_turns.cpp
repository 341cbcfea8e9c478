#include "keiko/trace/outline_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

constexpr int most_halvings = 7;
/// Of a prism's width and of its length: what is one place.
constexpr double one_place = 1e-5, one_place_along = 1e-4;
/// Of what may be left out: what lines that are too short to be followed take.
constexpr double of_short = 0.25;

} // namespace

OutlineTurns::OutlineTurns(const Apex& apex, const ApexScreen& screen, const ScreenBox& prism,
                           const ViewVolume& volume, const ParameterInterval& ends, double gap,
                           double missed)
    : apex_(apex),
      screen_(screen),
      volume_(volume),
      prism_(prism),
      begin_(std::min(ends.begin, ends.end)),
      length_(std::abs(ends.length())),
      width_(prism.across_high - prism.across_low),
      gap_(gap),
      missed_(missed) {}

void OutlineTurns::add_border(const BorderPiece& border) {
    follow(border, {border.curve, true, true}, false, most_halvings);
}

void OutlineTurns::add_fold(const BorderPiece& line) {
    follow(line, {line.curve, true, true}, true, most_halvings);
}

void OutlineTurns::add_unclear(const ScreenBox& box) {
    const double run = std::min((box.along_high - box.along_low) / length_, 1.0);
    for (const double across : {box.across_low, box.across_high})
        add((across - prism_.across_low) / width_, run * gap_ / 2, 0);
}

bool OutlineTurns::leaves_out(const ScreenBox& box) {
    const double missed = (box.along_high - box.along_low) / length_ * gap_ / 2;
    if (!(left_out_ + missed <= of_short * missed_)) return false;
    left_out_ += missed;
    return true;
}

double OutlineTurns::most_slope() const {
    constexpr double few = 4;
    return missed_ / few / kink(1) * length_ / width_;
}

void OutlineTurns::add(double across, double weight, int dark) {
    if (across > 0 && across < 1) turns_.push_back({across, weight, dark});
}

/// Across and along in widths and lengths of the prism.
ScreenPlace OutlineTurns::place(const Vec3& x) const {
    ScreenPlace place = screen_.place(x);
    place.across = (place.across - prism_.across_low) / width_;
    place.along = (place.along - begin_) / length_;
    return place;
}

/// Where the surface lies that ends or folds at a line.
int OutlineTurns::dark_side(const BorderPiece& line, const BorderPiece::Curve& curve) const {
    constexpr double sure = 0.01;
    if (!(line.inward_error < 1)) return 0;
    const Vec3 way = line.center + (curve.front() + curve.back()) * 0.5 - apex_.place();
    const Vec3& inward = line.inward[1];
    const Vec3 z = screen_.way_at(0);
    const double rise =
        screen_.across().dot(inward) * z.dot(way) - screen_.across().dot(way) * z.dot(inward);
    if (!(std::abs(rise) > sure * z.dot(way))) return 0;
    return rise > 0 ? 1 : -1;
}

OutlineTurns::Shown OutlineTurns::shown(const BorderPiece& line,
                                        const BorderPiece::Curve& curve) const {
    Shown shown;
    std::array<ScreenPlace, BorderPiece::points> places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = place(line.center + curve[i]);
        shown.before = shown.before && places[i].depth > 0;
        shown.box.across_low = std::min(shown.box.across_low, places[i].across);
        shown.box.across_high = std::max(shown.box.across_high, places[i].across);
        shown.box.along_low = std::min(shown.box.along_low, places[i].along);
        shown.box.along_high = std::max(shown.box.along_high, places[i].along);
    }
    const ScreenPlace &a = places.front(), &b = places.back();
    const double up = b.across >= a.across ? 1 : -1, on = b.along >= a.along ? 1 : -1;
    constexpr double rounding = one_place;
    for (std::size_t i = 1; i < places.size(); ++i)
        shown.monotone = shown.monotone &&
                         (places[i].across - places[i - 1].across) * up >= -rounding &&
                         (places[i].along - places[i - 1].along) * on >= -rounding;
    shown.run = {a.across, b.across, a.along, b.along};
    shown.run.dark = dark_side(line, curve);
    return shown;
}

void OutlineTurns::follow(const BorderPiece& line, const Part& part, bool fold, int halvings) {
    const Shown seen = shown(line, part.curve);
    static constexpr ScreenBox whole{-0.1, 1.1, 0, 1}; // its ends are not quite straight
    if (seen.before && !seen.box.overlaps(whole)) return;
    ViewVolume::Sides sides = volume_.all_sides();
    if (!volume_.may_hold(part.curve, line.center, line.error, sides)) return;
    if (!fold && !line.may_be_edge_on(apex_, part.curve)) return;
    if (seen.before && (seen.monotone || halvings == 0))
        return add_run(clipped(line, part.curve, seen.run), part);
    if (halvings == 0) return;
    const auto [low, high] = halved(part.curve);
    follow(line, {low, part.begins, false}, fold, halvings - 1);
    follow(line, {high, false, part.ends}, fold, halvings - 1);
}

/// Across, where a line that runs past the place `along` once does so.
double OutlineTurns::where(const BorderPiece& line, const BorderPiece::Curve& curve,
                           double along) const {
    const auto at = [&](double t) { return place(line.center + point_on(curve, t)); };
    double low = 0, high = 1;
    const bool rises = at(1).along > at(0).along;
    constexpr int halvings = 30;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        ((at(middle).along > along) == rises ? high : low) = middle;
    }
    return at((low + high) / 2).across;
}

/// What of a run lies between the ends of the prism, at which it turns.
OutlineTurns::Run OutlineTurns::clipped(const BorderPiece& line, const BorderPiece::Curve& curve,
                                        Run run) {
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

/// What may be missed, of all the prism brings, between lines that a gap is between, if they do not
/// know of one end of a run.
double OutlineTurns::weight(const Run& run) const {
    const double all = std::abs(run.to - run.from), across = std::abs(run.b - run.a);
    const double inside = std::max(
        std::min(std::max(run.a, run.b), 1.0) - std::max(std::min(run.a, run.b), 0.0), 0.0);
    if (!(across > one_place)) return all * gap_ / 2;
    return std::min(kink(all / across), all * (inside / across) * gap_ / 2);
}

void OutlineTurns::add_run(const Run& run, const Part& part) {
    // Beside the ends of the prism.
    if (std::max(run.from, run.to) <= 0 || std::min(run.from, run.to) >= 1) return;
    const double weight = this->weight(run);
    if (!(std::abs(run.b - run.a) > one_place)) return add(run.a, weight, run.dark);
    const int rise = run.b > run.a ? 1 : -1;
    const auto add_end = [&](double across, double along, int sign, bool within, bool whole) {
        if (!within) return add(across, weight, run.dark);
        if (across > 0 && across < 1)
            ends_.push_back({across, along, sign, run.slope(), weight, whole, run.dark});
    };
    add_end(run.a, run.from, rise, run.begins, part.begins);
    add_end(run.b, run.to, -rise, run.ends, part.ends);
}

/// A line runs on where one part goes up from a place and one down, but for how it bends there.
std::vector<OutlineTurns::Turn> OutlineTurns::turning_ends() const {
    std::vector<Turn> turns;
    std::vector<End> ends = ends_;
    std::sort(ends.begin(), ends.end(),
              [](const End& a, const End& b) { return a.across < b.across; });
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (std::isnan(ends[i].along)) continue;
        int rise = 0;
        double bend = 0, weight = 0;
        bool whole = false;
        int dark = ends[i].dark;
        for (std::size_t k = i; k < ends.size() && ends[k].across <= ends[i].across + one_place;
             ++k) {
            if (!(std::abs(ends[k].along - ends[i].along) <= one_place_along)) continue;
            rise += ends[k].rise, bend += ends[k].rise * ends[k].slope;
            weight += ends[k].weight, whole = whole || ends[k].whole;
            if (ends[k].dark != dark) dark = 0;
            if (k > i) ends[k].along = std::nan("");
        }
        if (rise == 0) weight = std::min(weight, kink(std::abs(bend)));
        if (whole || std::abs(rise) != 1) turns.push_back({ends[i].across, weight, dark});
    }
    return turns;
}

/// Two faces of one edge have it twice.
std::vector<OutlineTurns::Turn> OutlineTurns::all_turns() const {
    std::vector<Turn> turns = turning_ends();
    turns.insert(turns.end(), turns_.begin(), turns_.end());
    std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
        return std::pair(a.across, a.missed) < std::pair(b.across, b.missed);
    });
    const auto is_same = [](const Turn& a, const Turn& b) {
        return b.across - a.across <= one_place && std::abs(a.missed - b.missed) <= 1e-3 * a.missed;
    };
    turns.erase(std::unique(turns.begin(), turns.end(), is_same), turns.end());
    return turns;
}

std::vector<OutlineTurns::Turn> OutlineTurns::found() const {
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
