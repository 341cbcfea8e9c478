#include "keiko/inspect/seams/seam_profile.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/seams/profile_samples.h"
#include "keiko/inspect/seams/seam_quantities.h"
#include "keiko/inspect/seams/stretch_probes.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double chord_share = 0.01; ///< of a quantity, by which it may leave the chord of a step
constexpr double step_share = 1e-3;  ///< of the length: longest step that crosses a limit

using Value = std::optional<double> (*)(const ProfileSample&);

/// The limits that hold for a stretch, and which of them its verdict depends on.
struct Limits {
    std::optional<double> gap, angle, curvature, slope;
    bool judges_curvature = false, judges_slope = false;

    Limits(const MeasuredSeam& seam, const CriteriaPreset& preset) {
        if (seam.scrap) return;
        gap = preset.gap;
        if (seam.is_angle_judged()) angle = preset.angle;
        const auto has_limits = [](const KnotPiece& piece) { return piece.has_limits; };
        if (seam.kind != SeamClass::smooth ||
            !std::all_of(seam.knots.begin(), seam.knots.end(), has_limits))
            return;
        if (preset.curvature) curvature = preset.curvature->limit;
        slope = preset.curvature_slope;
        judges_curvature = curvature && seam.curvature, judges_slope = slope && seam.slope;
    }
};

/// Measures one stretch.
class Profiler {
public:
    Profiler(const SurfaceModel& model, const MeasuredSeam& seam,
             const std::vector<PlacedProbe>& probes, const CriteriaPreset& preset)
        : model_(model),
          seam_(seam),
          probes_(probes),
          preset_(preset),
          quantities_(preset),
          limits_(seam, preset) {
        for (const PlacedProbe& placed : probes) {
            const StretchExtremes along = extremes_along(placed.probe, preset);
            first_.push_back(first_samples(placed.probe, along));
            all_ = larger_of(all_, along);
            length_ += placed.probe.length();
        }
    }

    SeamProfile run() {
        profile_.length = length_;
        const std::vector<SampledQuantity> sampled = sampled_quantities();
        for (std::uint32_t i = 0; i < probes_.size(); ++i)
            add_piece(i, refined_samples(probes_[i].probe, std::move(first_[i]), sampled,
                                         step_share * length_));
        add_quantities();
        return std::move(profile_);
    }

private:
    std::vector<SampledQuantity> sampled_quantities() const;
    void add_piece(std::uint32_t piece, const std::vector<SeamPoint>& points);
    ProfileSample sample(std::uint32_t piece, double along, const SeamPoint& point) const;
    void add_quantities();
    std::optional<ProfileQuantity> quantity(const std::optional<SeamExtreme>& extreme,
                                            double rounding, const std::optional<double>& limit,
                                            bool judged, Value value) const;
    ProfileShare beyond(double limit, Value value) const;

    const SurfaceModel& model_;
    const MeasuredSeam& seam_;
    const std::vector<PlacedProbe>& probes_;
    const CriteriaPreset& preset_;
    SeamQuantities quantities_;
    Limits limits_;
    std::vector<std::vector<SeamPoint>> first_;
    StretchExtremes all_;
    double length_ = 0, reached_ = 0; ///< mm: of the stretch, of the pieces added
    SeamProfile profile_;
};

std::vector<SampledQuantity> Profiler::sampled_quantities() const {
    double bend = 1 / preset_.flat_radius;
    for (const std::vector<SeamPoint>& points : first_)
        for (const SeamPoint& p : points)
            if (p.angle) bend = std::max({bend, std::abs(p.curvature_a), std::abs(p.curvature_b)});
    const auto tolerance = [](double limit, const std::optional<SeamExtreme>& most) {
        return chord_share * std::max(limit, most ? most->value : 0.0);
    };
    const auto if_known = [](const SeamPoint& p, double value) -> std::optional<double> {
        if (!p.angle) return std::nullopt;
        return value;
    };
    return {
        {[](const SeamPoint& p) { return p.gap; }, tolerance(preset_.gap, all_.gap), limits_.gap},
        {[](const SeamPoint& p) { return p.angle; }, tolerance(preset_.angle, all_.angle),
         limits_.angle},
        {[=](const SeamPoint& p) { return if_known(p, p.curvature_a); }, chord_share * bend},
        {[=](const SeamPoint& p) { return if_known(p, p.curvature_b); }, chord_share * bend},
        {[this](const SeamPoint& p) { return quantities_.mismatch(p); },
         tolerance(quantities_.curvature_limit().limit, all_.curvature), limits_.curvature},
        {[this](const SeamPoint& p) { return quantities_.slope(p); },
         tolerance(preset_.curvature_slope.value_or(unjudged_slope), all_.slope), limits_.slope}};
}

ProfileSample Profiler::sample(std::uint32_t piece, double along, const SeamPoint& point) const {
    ProfileSample sample{piece, along, point};
    if (!point.angle) return sample;
    sample.alias = quantities_.mismatch(CurvatureFormula::alias, point);
    sample.catia = quantities_.mismatch(CurvatureFormula::catia, point);
    sample.mismatch = quantities_.mismatch(point), sample.slope = quantities_.slope(point);
    return sample;
}

void Profiler::add_piece(std::uint32_t piece, const std::vector<SeamPoint>& points) {
    const auto& [probe, backwards] = probes_[piece];
    std::vector<double> along{0};
    for (std::size_t i = 1; i < points.size(); ++i)
        along.push_back(along.back() + probe.length(points[i - 1].t, points[i].t));
    std::vector<ProfileSample> samples;
    for (std::size_t i = 0; i < points.size(); ++i)
        samples.push_back(
            sample(piece, reached_ + (backwards ? along.back() - along[i] : along[i]), points[i]));
    if (backwards) std::reverse(samples.begin(), samples.end());
    profile_.samples.insert(profile_.samples.end(), samples.begin(), samples.end());
    reached_ += along.back();
}

void Profiler::add_quantities() {
    const double at_gap =
        all_.gap ? position_error(model_, seam_.face_a, seam_.face_b, all_.gap->point.place) : 0;
    profile_.gap = quantity(all_.gap, at_gap, limits_.gap, !seam_.scrap,
                            [](const ProfileSample& s) { return std::optional(s.point.gap); });
    profile_.angle = quantity(all_.angle, angle_rounding, limits_.angle, seam_.is_angle_judged(),
                              [](const ProfileSample& s) { return s.point.angle; });
    profile_.curvature = quantity(all_.curvature, 0, limits_.curvature, limits_.judges_curvature,
                                  [](const ProfileSample& s) { return s.mismatch; });
    profile_.slope = quantity(all_.slope, 0, limits_.slope, limits_.judges_slope,
                              [](const ProfileSample& s) { return s.slope; });
}

std::optional<ProfileQuantity> Profiler::quantity(const std::optional<SeamExtreme>& extreme,
                                                  double rounding,
                                                  const std::optional<double>& limit, bool judged,
                                                  Value value) const {
    if (!extreme) return std::nullopt;
    ProfileQuantity quantity{extreme->value, extreme->bound + rounding, extreme->point.place};
    const auto is_there = [&](const ProfileSample& s) {
        return s.point.t == extreme->point.t && s.point.place == extreme->point.place;
    };
    const auto at = std::find_if(profile_.samples.begin(), profile_.samples.end(), is_there);
    if (at != profile_.samples.end()) quantity.along = at->along;
    quantity.limit = limit, quantity.judged = judged;
    if (limit) quantity.beyond = beyond(*limit, value);
    return quantity;
}

ProfileShare Profiler::beyond(double limit, Value value) const {
    ProfileShare share;
    for (std::size_t i = 1; i < profile_.samples.size(); ++i) {
        const ProfileSample &a = profile_.samples[i - 1], &b = profile_.samples[i];
        if (a.piece != b.piece || !(length_ > 0)) continue;
        const double step = (b.along - a.along) / length_;
        const auto x = value(a), y = value(b);
        if (!x || !y) {
            share.bound += step;
            continue;
        }
        const auto [low, high] = std::minmax(*x, *y);
        if (low > limit) share.value += step;
        if (low > limit || high <= limit) continue;
        share.value += step * (high - limit) / (high - low);
        share.bound += step;
    }
    // The steps add up to the length within its rounding.
    return {std::min(1.0, share.value), std::min(1.0, share.bound)};
}

} // namespace

std::vector<SeamProfile> seam_profiles(const ModelBorders& borders,
                                       std::span<const MeasuredSeam> seams,
                                       std::span<const Seam> pieces,
                                       std::span<const std::uint32_t> indices,
                                       const FaceLimits& limits, const Job& job) {
    std::vector<SeamProfile> profiles(indices.size());
    parallel_for(indices.size(), job, "profiles", [&](std::size_t i) {
        const std::uint32_t index = indices[i];
        const MeasuredSeam& seam = seams[index];
        const StretchProbes probes(borders, seams, index, pieces);
        profiles[i] = Profiler(borders.model, seam, probes.probes(),
                               limits.between(seam.side_a(), seam.side_b()))
                          .run();
        profiles[i].seam = index;
    });
    return profiles;
}

} // namespace keiko
