#include "keiko/radiosity/progressive_refinement.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Sum over elements of a colour, weighted by their areas.
Rgb power(std::span<const double> areas, std::span<const Rgb> radiosity) {
    Rgb sum;
    for (std::size_t i = 0; i < areas.size(); ++i) sum += radiosity[i] * areas[i];
    return sum;
}

} // namespace

ProgressiveRefinement::ProgressiveRefinement(std::vector<double> areas,
                                             std::vector<Reflector> reflectors, RowOf row)
    : areas_(std::move(areas)), reflectors_(std::move(reflectors)), row_(std::move(row)) {
    assert(areas_.size() == reflectors_.size());
    for (const Reflector& reflector : reflectors_) unshot_.push_back(reflector.exitance);
    arriving_.resize(unshot_.size());
}

std::vector<Rgb> ProgressiveRefinement::radiosity() const {
    std::vector<Rgb> all;
    for (std::size_t i = 0; i < areas_.size(); ++i)
        all.push_back(reflectors_[i].exitance + reflectors_[i].reflectance * arriving_[i]);
    return all;
}

EnergyBalance ProgressiveRefinement::balance() const {
    return energy_balance(areas_, reflectors_, arriving_, escaped_);
}

std::size_t ProgressiveRefinement::brightest() const {
    constexpr double rounding = 1e-9;
    std::size_t found = 0;
    double most = 0;
    for (std::size_t i = 0; i < areas_.size(); ++i) {
        const double flux = luminance(unshot_[i]) * areas_[i];
        if (flux > most * (1 + rounding)) most = flux, found = i;
    }
    return found;
}

std::size_t ProgressiveRefinement::shoot() {
    const std::size_t from = brightest();
    const std::vector<double> row = row_(from);
    const Rgb shot = unshot_[from];
    unshot_[from] = {};
    double received = 0;
    for (std::size_t j = 0; j < areas_.size(); ++j) {
        const Rgb light = shot * (row[j] / areas_[j]);
        arriving_[j] += light;
        unshot_[j] += reflectors_[j].reflectance * light;
        received += row[j];
    }
    escaped_ += shot * (areas_[from] - received);
    return from;
}

int ProgressiveRefinement::refine(double allowed, int most_steps, const Job& job) {
    const double first = remaining();
    int steps = 0;
    for (; steps < most_steps; ++steps) {
        job.check();
        const double left = remaining();
        if (!(left > allowed)) break;
        const double done = std::log(first / left) / std::log(first / allowed);
        job.report("radiosity", std::isfinite(done) ? std::clamp(done, 0.0, 1.0) : 0);
        shoot();
    }
    return steps;
}

Rgb ProgressiveRefinement::ambient() const {
    double area = 0;
    Rgb reflected;
    for (std::size_t i = 0; i < areas_.size(); ++i) {
        area += areas_[i];
        reflected += reflectors_[i].reflectance * areas_[i];
    }
    const Rgb unshot = power(areas_, unshot_), lost = Rgb(area) - reflected;
    return {unshot.r / lost.r, unshot.g / lost.g, unshot.b / lost.b};
}

std::vector<Rgb> ProgressiveRefinement::with_ambient() const {
    std::vector<Rgb> all = radiosity();
    const Rgb light = ambient();
    for (std::size_t i = 0; i < all.size(); ++i) all[i] += reflectors_[i].reflectance * light;
    return all;
}

double ProgressiveRefinement::remaining() const {
    double most = 0;
    for (const Reflector& reflector : reflectors_)
        most = std::max(most, max_channel(reflector.reflectance));
    const double unshot = max_channel(power(areas_, unshot_));
    if (unshot == 0) return 0;
    if (!(most < 1)) return std::numeric_limits<double>::infinity();
    return most / (1 - most) * unshot / max_channel(power(areas_, radiosity()));
}

} // namespace keiko
