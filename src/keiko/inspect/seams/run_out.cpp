#include "keiko/inspect/seams/run_out.h"

#include "keiko/base/job.h"
#include "keiko/inspect/seams/seam_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

/// Window over which mean slopes are taken, and the samples' distance, in negligible lengths.
constexpr double window_width = 2, sample_step = 1;
/// Length within which the line turns by seam_corner at a corner, in negligible lengths.
constexpr double corner_length = 4;

/// The angle at one place of the path out of a crease.
struct FadeSample {
    double along = 0; ///< mm, from the end of the crease; negative inside it
    double angle = 0; ///< degrees, signed
    Vec3 place{0};
    Vec3 run{0};        ///< direction of the path out, of any length
    bool joint = false; ///< a patch or a part ends here: the slope may have a step
};

const SeamPoint& point_at(const SeamPart& part, bool last) {
    return last ? part.end : part.begin;
}

/// The mean slope between a sample and the first one at least `width` mm away from it, and their
/// distance.
struct MeanSlope {
    double slope = 0, width = 0;
};

MeanSlope mean_slope(std::span<const FadeSample> samples, std::size_t i, double width, bool after) {
    std::size_t k = i;
    while (after ? k + 1 < samples.size() : k > 0) {
        k = after ? k + 1 : k - 1;
        if (std::abs(samples[k].along - samples[i].along) >= width) break;
    }
    const double run = samples[k].along - samples[i].along;
    return {(samples[k].angle - samples[i].angle) / run, std::abs(run)};
}

/// A slope, and its largest possible error.
struct BoundedSlope {
    double slope = 0, bound = 0;
};

/// The slope extrapolated from two mean slopes, which deviate in proportion to their widths; the
/// third derivative remains as error.
double extrapolated(const MeanSlope& narrow, const MeanSlope& wide) {
    if (!(wide.width > narrow.width)) return narrow.slope;
    return (narrow.slope * wide.width - wide.slope * narrow.width) / (wide.width - narrow.width);
}

/// The slope on one side of a sample. The error by the third derivative is proportional to the
/// product of the two widths, and is estimated by the slopes of twice the widths.
BoundedSlope slope_beside(std::span<const FadeSample> samples, std::size_t i, double width,
                          bool after) {
    const MeanSlope half = mean_slope(samples, i, width / 2, after);
    const MeanSlope whole = mean_slope(samples, i, width, after);
    const MeanSlope twice = mean_slope(samples, i, 2 * width, after);
    const double slope = extrapolated(half, whole);
    const double change = std::abs(extrapolated(whole, twice) - slope);
    const bool wider = twice.width > half.width;
    return {slope, wider ? change * half.width / (twice.width - half.width) : change};
}

/// Parameters at which a part is sampled from one end to the other, and which of them are joints.
struct SampleStep {
    double t = 0;
    bool joint = false;
};

std::vector<SampleStep> sample_steps(const SeamProbe& probe, const SeamPart& part, bool forward,
                                     double step) {
    std::vector<double> stops = probe.part(part.begin, part.end).patch_changes();
    stops.push_back(part.end.t);
    std::vector<SampleStep> steps;
    const double span = part.end.t - part.begin.t;
    double from = part.begin.t;
    for (const double stop : stops) {
        if (!(stop > from)) continue;
        constexpr double most = 1e6;
        const int count =
            static_cast<int>(std::min(most, std::ceil(part.length * (stop - from) / span / step)));
        for (int i = 1; i < count; ++i) steps.push_back({from + (stop - from) * i / count, false});
        steps.push_back({stop, true});
        from = stop;
    }
    if (forward || steps.empty()) return steps;
    steps.insert(steps.begin(), {part.begin.t, true});
    steps.pop_back();
    std::reverse(steps.begin(), steps.end());
    return steps;
}

class FadeWalk {
public:
    FadeWalk(std::span<const SeamProbe> probes, std::span<const SeamPart> parts,
             const StretchLimits& limits)
        : probes_(probes), parts_(parts), limits_(limits), used_(parts.size()) {}

    std::optional<RunOut> run(std::size_t crease, bool forward) {
        used_[crease] = true;
        const std::optional<Entry> first = neighbour(crease, forward);
        if (!first || parts_[first->part].kind != SeamClass::smooth) return std::nullopt;
        sample_crease(crease, forward);
        std::optional<Entry> next = first;
        while (next && parts_[next->part].kind == SeamClass::smooth) {
            used_[next->part] = true;
            if (!follow(*next)) return std::nullopt;
            if (is_done() || ends_) break;
            next = neighbour(next->part, next->forward);
        }
        if (!faded_) return std::nullopt;
        if (!next || ends_) end_seam();
        result_.step = largest_step();
        return std::move(result_);
    }

private:
    /// A part, and whether it is entered at the begin of side a.
    struct Entry {
        std::size_t part = 0;
        bool forward = true;
    };

    /// True if a part on the path is shorter than counts.
    bool is_scrap(const SeamPart& part) const {
        return part.kind != SeamClass::smooth && part.length < limits_.negligible;
    }
    /// Direction of the path out at parameter t of a part that is traversed forward or backward.
    Vec3 way_out(const SeamPart& part, double t, bool forward) const {
        const Vec3 run = probes_[part.piece].run(t);
        return forward ? run : -run;
    }
    double step() const { return sample_step * limits_.negligible; }
    double window() const { return window_width * limits_.negligible; }
    /// True if samples reach far enough beyond the minimum of the angle for its slope's step there
    /// to be known.
    bool is_done() const { return faded_ && samples_.back().along > lowest_at_ + 4 * window(); }

    std::optional<Entry> neighbour(std::size_t part, bool forward) const;
    void sample_crease(std::size_t crease, bool forward);
    double sample_back(const Entry& entry, double along);
    bool follow(const Entry& entry);
    bool note(double along, const SeamPoint& to, const Vec3& way, bool joint);
    bool turns_corner(double along, const Vec3& way) const;
    void take(const Entry& entry, const SeamPoint& until);
    SeamPoint faded_between(const Entry& entry, SeamPoint over, SeamPoint under) const;
    void end_seam();
    MeasuredValue largest_step() const;

    std::span<const SeamProbe> probes_;
    std::span<const SeamPart> parts_;
    const StretchLimits& limits_;
    std::vector<bool> used_;
    std::vector<FadeSample> samples_;
    bool ends_ = false;        ///< at a corner
    bool faded_ = false;       ///< the angle is down to its limit
    double lowest_ = HUGE_VAL; ///< degrees, the smallest angle so far
    double lowest_at_ = 0;     ///< mm along
    double along_ = 0;         ///< mm along, of the last place
    RunOut result_;
};

/// The part that continues from the end of another: the next one of its piece, or the nearest one
/// of another piece.
std::optional<FadeWalk::Entry> FadeWalk::neighbour(std::size_t part, bool forward) const {
    std::size_t beside = part;
    do {
        beside = forward ? beside + 1 : beside - 1; // wraps around at the first
    } while (beside < parts_.size() && is_scrap(parts_[beside]));
    if (beside < parts_.size() && parts_[beside].piece == parts_[part].piece) {
        if (used_[beside]) return std::nullopt;
        return Entry{beside, forward};
    }
    const SeamEnd exit = end_of(probes_[parts_[part].piece], parts_[part], forward);
    std::optional<Entry> nearest;
    const double reach = std::max(limits_.join, limits_.negligible);
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        for (const bool from_begin : {true, false}) {
            if (used_[i] || is_scrap(parts_[i])) continue;
            const SeamEnd end = end_of(probes_[parts_[i].piece], parts_[i], !from_begin);
            const double apart = (end.place - exit.place).length();
            // A closed piece continues at its other end.
            if (parts_[i].piece == parts_[part].piece && apart > class_change_bound) continue;
            if (apart < least && goes_on(exit, end, reach))
                least = apart, nearest = Entry{i, from_begin};
        }
    return nearest;
}

/// Samples of the crease before its end, over as many of its parts as necessary, in the order of
/// the path out.
void FadeWalk::sample_crease(std::size_t crease, bool forward) {
    const SeamPart& part = parts_[crease];
    const SeamPoint& out = point_at(part, forward);
    samples_.push_back({0, out.signed_angle, out.place, way_out(part, out.t, forward), true});
    std::optional<Entry> back = Entry{crease, !forward};
    double along = 0;
    while (back && parts_[back->part].kind == SeamClass::crease && along <= 4 * window()) {
        used_[back->part] = true;
        along = sample_back(*back, along);
        back = neighbour(back->part, back->forward);
    }
    std::reverse(samples_.begin(), samples_.end());
}

/// Samples one part of the crease, entered `along` mm before its end; returns the distance reached.
double FadeWalk::sample_back(const Entry& entry, double along) {
    const SeamPart& part = parts_[entry.part];
    const SeamProbe& probe = probes_[part.piece];
    SeamPoint last = point_at(part, !entry.forward);
    for (const SampleStep& next : sample_steps(probe, part, entry.forward, step())) {
        const SeamPoint point = probe.at(next.t, last.s);
        along += (point.place - last.place).length();
        if (point.angle)
            samples_.push_back({-along, point.signed_angle, point.place,
                                way_out(part, next.t, !entry.forward), next.joint});
        if (along > 4 * window()) break;
        last = point;
    }
    return along;
}

/// Traverses one smooth part. Returns false if the angle does not fade.
bool FadeWalk::follow(const Entry& entry) {
    const SeamPart& part = parts_[entry.part];
    const SeamProbe& probe = probes_[part.piece];
    const SeamPoint &from = point_at(part, !entry.forward), &to = point_at(part, entry.forward);
    SeamPoint last = from;
    if (from.angle && *from.angle <= limits_.angle) faded_ = true;
    for (const SampleStep& next : sample_steps(probe, part, entry.forward, step())) {
        check_stop();
        const SeamPoint point = probe.at(next.t, last.s);
        const double along = along_ + (point.place - last.place).length();
        const Vec3 way = way_out(part, next.t, entry.forward);
        ends_ = turns_corner(along, way);
        if (ends_) return faded_;
        const bool was_faded = faded_;
        if (!note(along, point, way, next.joint)) return false;
        if (!was_faded && faded_) take(entry, faded_between(entry, last, point));
        if (is_done()) return true;
        last = point;
    }
    if (!faded_) take(entry, to);
    return true;
}

/// True if the line has turned a corner on its way to `along` mm.
bool FadeWalk::turns_corner(double along, const Vec3& way) const {
    const double least = along - corner_length * limits_.negligible;
    for (std::size_t i = samples_.size(); i > 0 && samples_[i - 1].along >= least; --i)
        if (is_corner(samples_[i - 1].run, way)) return true;
    return false;
}

/// Adds a sample. Returns false if the angle rises again or takes too long to fade.
bool FadeWalk::note(double along, const SeamPoint& to, const Vec3& way, bool joint) {
    along_ = along;
    if (!to.angle) return true;
    if (along > samples_.back().along)
        samples_.push_back({along, to.signed_angle, to.place, way, joint});
    const bool falls = *to.angle < lowest_ - 16 * angle_rounding;
    if (falls) lowest_ = *to.angle, lowest_at_ = along;
    if (faded_) return true;
    if (*to.angle > lowest_ + limits_.angle || along > limits_.longest_run_out) return false;
    faded_ = *to.angle <= limits_.angle;
    return true;
}

SeamPoint FadeWalk::faded_between(const Entry& entry, SeamPoint over, SeamPoint under) const {
    const SeamProbe& probe = probes_[parts_[entry.part].piece];
    while ((under.place - over.place).length() > class_change_bound) {
        check_stop();
        const double t = (over.t + under.t) / 2;
        if (t == over.t || t == under.t) break;
        const SeamPoint middle = probe.at(t, (over.s + under.s) / 2);
        (middle.angle.value_or(0) <= limits_.angle ? under : over) = middle;
    }
    return under;
}

/// Adds a part to the run-out, from its entry to `until`.
void FadeWalk::take(const Entry& entry, const SeamPoint& until) {
    const SeamPart& part = parts_[entry.part];
    SeamPart taken = part, left = part;
    taken.kind = SeamClass::run_out;
    (entry.forward ? taken.end : taken.begin) = until;
    (entry.forward ? left.begin : left.end) = until;
    for (SeamPart* each : {&taken, &left})
        each->length = probes_[part.piece].part(each->begin, each->end).length();
    RunOut::Piece piece{entry.part, taken, std::nullopt};
    if (left.begin.t < left.end.t) piece.left = left;
    result_.pieces.push_back(std::move(piece));
}

void FadeWalk::end_seam() {
    const FadeSample last = samples_.back();
    for (double beyond = step(); beyond <= 4 * window(); beyond += step())
        samples_.push_back({last.along + beyond, last.angle, last.place, last.run, false});
}

MeasuredValue FadeWalk::largest_step() const {
    std::optional<MeasuredValue> worst;
    for (std::size_t i = 1; i + 1 < samples_.size(); ++i) {
        const FadeSample& sample = samples_[i];
        if (!sample.joint || sample.along < 0 || sample.along > lowest_at_ + 2 * window()) continue;
        const BoundedSlope before = slope_beside(samples_, i, window(), false);
        const BoundedSlope after = slope_beside(samples_, i, window(), true);
        const double here = std::abs(after.slope - before.slope);
        const double bound = before.bound + after.bound + 16 * angle_rounding / window();
        const MeasuredValue step{here, bound, limits_.fading, sample.place,
                                 judge(here, bound, limits_.fading)};
        worst = worst ? worse_of(*worst, step) : step;
    }
    return worst.value_or(
        MeasuredValue{0, 0, limits_.fading, samples_.back().place, Verdict::pass});
}

} // namespace

std::optional<RunOut> follow_run_out(std::span<const SeamProbe> probes,
                                     std::span<const SeamPart> parts, std::size_t crease,
                                     bool forward, const StretchLimits& limits) {
    return FadeWalk(probes, parts, limits).run(crease, forward);
}

} // namespace keiko
