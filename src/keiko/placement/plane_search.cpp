#include "keiko/placement/plane_search.h"

#include "keiko/base/units.h"
#include "keiko/placement/hit_histogram.h"
#include "keiko/placement/plane_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

/// Shares of the weight that a plane could serve for which rectangles are tested.
constexpr std::array<double, 5> shares{0.98, 0.95, 0.9, 0.8, 0.65};
constexpr int cells = 64;               ///< of the histogram, each way
constexpr double coarse_angle = 15;     ///< degrees
constexpr double fine_angle = 0.5;      ///< degrees
constexpr double worth_turning = 1.005; ///< gain below which lamps are not turned further
/// Gain below which lamps stay along or across the vehicle: surfacers read such stripes best.
constexpr double worth_being_aslant = 1.1;
constexpr double enough_stripes = 5; ///< on a face
/// Diagonal of the lamps, in sizes of the visible part, at which their worth is halved.
constexpr double unwieldy = 8;
constexpr int least_lamps = 3, most_lamps = 64;
/// Powers of the objective's factors; coverage counts most. With these the first plane reaches
/// about 0.8 of a bonnet, 0.8 of a fender and 0.6 of a deck; with 0.5, 0.5 and 1 it reached 0.66,
/// 0.65 and 0.52.
constexpr double stripes_power = 0.25, uniformity_power = 0.15, in_range_power = 0.5;
/// Share of the objective that is kept for lamps whose stripes are all too narrow or too wide, so
/// that a best one still exists.
constexpr double least_in_range = 0.05;
/// Bends of features, over the size of the visible part: the one that counts as much as the picture
/// as a whole, and the one beyond which a feature counts no more.
constexpr double plain_bend = 0.5, sharpest_bend = 20;

/// Sums over the samples that a rectangle serves.
struct Tally {
    double served = 0, lost = 0;
    double graded = 0, log_sum = 0, log_squares = 0, in_range = 0;
    double features = 0, crossed = 0;

    void grade(double weight, double log_gradient) {
        graded += weight;
        log_sum += weight * log_gradient;
        log_squares += weight * log_gradient * log_gradient;
    }
    /// The square of the sine between stripe and feature, whose `strength` weighs it.
    void cross(double weight, double strength, double sine_squared) {
        features += weight * strength;
        crossed += weight * strength * sine_squared;
    }
    double crossing(double plain) const {
        const double all = features + plain * served;
        return all > 0 ? (crossed + plain * served) / all : 1;
    }
    double uniformity() const {
        if (!(graded > 0)) return 1;
        const double mean = log_sum / graded;
        return std::exp(-std::sqrt(std::max(0.0, log_squares / graded - mean * mean)));
    }
};

double compactness(double sizes) {
    const double over = sizes / unwieldy;
    return 1 / (1 + over * over);
}

} // namespace

double PlacementScore::objective() const {
    return coverage * std::pow(stripes, stripes_power) * std::pow(uniformity, uniformity_power) *
           std::pow(std::max(in_range, least_in_range), in_range_power) * compactness;
}

CPlane LampRectangle::c_plane(double diameter, const Rgb& luminance) const {
    return {.origin = frame.at(extent.lower),
            .u = frame.u * extent.extent().x,
            .v = frame.v * extent.extent().y,
            .lamps = lamps,
            .pitch = pitch(),
            .diameter = diameter,
            .luminance = luminance};
}

PlaneSearch::PlaneSearch(const LampField& field, const PlaneFrame& frame, const LampDemand& demand)
    : field_(field),
      frame_(frame),
      own_image_(demand.mirror && is_own_image(frame, *demand.mirror)),
      demand_(demand) {
    const std::span<const ViewSample> samples = field.samples();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (crossing(frame, samples[i].eye, samples[i].position())) seen_through_.push_back(i);
        if (!field.waits(i) && !field.reached(i)) continue;
        const auto hit = meet(frame, samples[i].mirror);
        if (!hit || hit->cosine < grazing_cosine) continue;
        reached_.push_back({i, hit->place, hit->gradients.value_or(PlaneHit::Gradients{}),
                            std::numeric_limits<double>::quiet_NaN()});
    }
}

std::vector<PlaneSearch::Reached> PlaneSearch::turned(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    std::vector<Reached> result = reached_;
    for (Reached& r : result) {
        r.place = {r.place.x * c + r.place.y * s, r.place.y * c - r.place.x * s};
        r.gradients.v = r.gradients.v * c - r.gradients.u * s;
        if (const double length = r.gradients.v.length(); length > 0)
            r.log_gradient = std::log(length);
    }
    return result;
}

LampRectangle PlaneSearch::best_at(double angle) const {
    const std::vector<Reached> around = turned(angle);
    std::vector<WeightedPlace> waiting;
    for (const Reached& r : around)
        if (field_.waits(r.sample)) waiting.push_back({r.place, field_.samples()[r.sample].weight});
    LampRectangle best;
    best.frame = frame_.turned(angle);
    if (waiting.empty()) return best;
    for (const Box2& extent : HitHistogram(waiting, cells).rectangles(shares)) {
        const LampRectangle next = score(
            best.frame, own_image_ ? symmetric_extent(best.frame, extent, *demand_.mirror) : extent,
            around);
        if (next.score.objective() > best.score.objective()) best = next;
    }
    return best;
}

LampRectangle PlaneSearch::rated(const Box2& extent) const {
    return score(frame_, extent, turned(0));
}

LampRectangle PlaneSearch::best() const {
    LampRectangle along = best_at(0);
    if (demand_.direction == LampDirection::along) return along;
    LampRectangle across = best_at(std::numbers::pi / 2);
    if (demand_.direction == LampDirection::across) return across;
    LampRectangle best = across.score.objective() > along.score.objective() ? across : along;
    if (own_image_) return best;
    const double to_beat = best.score.objective() * worth_being_aslant;
    LampRectangle aslant;
    for (double degrees = coarse_angle; degrees < 180; degrees += coarse_angle) {
        if (degrees == 90) continue;
        const LampRectangle next = best_at(degrees_to_radians(degrees));
        if (next.score.objective() > aslant.score.objective()) aslant = next;
    }
    return aslant.score.objective() > to_beat ? refined(aslant) : best;
}

LampRectangle PlaneSearch::refined(LampRectangle best) const {
    double angle = std::atan2(best.frame.u.dot(frame_.v), best.frame.u.dot(frame_.u));
    for (double step = coarse_angle / 2; step >= fine_angle; step /= 2)
        for (const double turn : {-step, step}) {
            const LampRectangle next = best_at(angle + degrees_to_radians(turn));
            if (!(next.score.objective() > best.score.objective() * worth_turning)) continue;
            best = next;
            angle += degrees_to_radians(turn);
            break;
        }
    return best;
}

int PlaneSearch::lamp_count(const Box2& extent, const std::vector<Reached>& turned) const {
    if (demand_.lamps > 0) return demand_.lamps;
    std::vector<std::pair<double, double>> gradients;
    double total = 0;
    for (const Reached& r : turned)
        if (field_.waits(r.sample) && extent.contains(r.place) && !std::isnan(r.log_gradient)) {
            gradients.emplace_back(r.log_gradient, field_.samples()[r.sample].weight);
            total += gradients.back().second;
        }
    if (gradients.empty()) return least_lamps;
    std::sort(gradients.begin(), gradients.end());
    double sum = 0, median = 0;
    for (const auto& [log_gradient, weight] : gradients) {
        median = std::exp(log_gradient);
        if ((sum += weight) >= total / 2) break;
    }
    const double count = extent.extent().y / (demand_.spacing.wanted * median);
    return static_cast<int>(std::clamp(std::round(count), static_cast<double>(least_lamps),
                                       static_cast<double>(most_lamps)));
}

std::vector<bool> PlaneSearch::hidden_by(const PlaneFrame& frame, const Box2& extent) const {
    std::vector<bool> hidden(field_.samples().size(), false);
    for (const std::size_t i : seen_through_) {
        const ViewSample& s = field_.samples()[i];
        const auto place = crossing(frame, s.eye, s.position());
        hidden[i] = place && extent.contains(*place);
    }
    return hidden;
}

LampRectangle PlaneSearch::score(const PlaneFrame& frame, const Box2& extent,
                                 const std::vector<Reached>& turned) const {
    LampRectangle result{frame, extent, lamp_count(extent, turned), {}};
    const double low = std::log(result.pitch() / demand_.spacing.most);
    const double high = std::log(result.pitch() / demand_.spacing.least);
    const std::vector<bool> hidden = hidden_by(frame, extent);
    std::vector<Bounds<Vec2>> ranges(field_.region_count()); // of v (x) on each face
    std::vector<double> weights(field_.region_count());
    Tally tally;
    for (const Reached& r : turned) {
        const double weight = field_.samples()[r.sample].weight;
        const bool inside = extent.contains(r.place);
        if (field_.reached(r.sample)) {
            // Crossed stripes of two planes are as bad as none.
            if (hidden[r.sample] || inside) tally.lost += weight;
            continue;
        }
        if (!inside || hidden[r.sample]) continue;
        tally.served += weight;
        ranges[field_.region(r.sample)].extend({r.place.y, 0});
        weights[field_.region(r.sample)] += weight;
        if (std::isnan(r.log_gradient)) continue;
        tally.grade(weight, r.log_gradient);
        const FeatureDirection& feature = field_.samples()[r.sample].feature;
        const double along = r.gradients.v.dot(feature.along);
        tally.cross(weight, std::min(feature.strength, sharpest_bend / field_.size()),
                    along * along / r.gradients.v.length2());
        if (low <= r.log_gradient && r.log_gradient <= high) tally.in_range += weight;
    }
    if (!(tally.served > 0)) return result;

    double stripes = 0;
    for (std::size_t region = 0; region < ranges.size(); ++region)
        if (weights[region] > 0)
            stripes += weights[region] *
                       std::min(1.0, ranges[region].extent().x / result.pitch() / enough_stripes);
    result.score = {.coverage = std::max(0.0, tally.served - tally.lost) / field_.total_weight(),
                    .stripes = stripes / tally.served,
                    .uniformity = tally.uniformity(),
                    .in_range = tally.graded > 0 ? tally.in_range / tally.graded : 1,
                    .crossing = tally.crossing(plain_bend / field_.size()),
                    .compactness = compactness(extent.size() / field_.size())};
    return result;
}

} // namespace keiko
