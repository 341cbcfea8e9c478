#include "keiko/radiosity/gauss_seidel.h"

#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace keiko {
namespace {

/// Largest change of a radiosity, and largest radiosity.
struct Sweep {
    double change = 0, largest = 0;
};

Rgb arriving_light(const ExchangeAreas& areas, std::span<const Rgb> radiosity,
                   std::size_t element) {
    Rgb sum;
    for (std::size_t j = 0; j < areas.size(); ++j) sum += radiosity[j] * areas.between(element, j);
    return sum / areas.area(element);
}

Rgb reflected(const ExchangeAreas& areas, std::span<const Reflector> reflectors,
              std::span<const Rgb> radiosity, std::size_t i) {
    return reflectors[i].exitance + reflectors[i].reflectance * arriving_light(areas, radiosity, i);
}

Sweep sweep(const ExchangeAreas& areas, std::span<const Reflector> reflectors,
            std::vector<Rgb>& radiosity) {
    Sweep all;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const Rgb next = reflected(areas, reflectors, radiosity, i);
        all.change = std::max(all.change, largest_part(next - radiosity[i]));
        all.largest = std::max(all.largest, largest_part(next));
        radiosity[i] = next;
    }
    return all;
}

/// Sets what follows from the radiosities. The inverse of 1 - rho F has the largest norm 1 / (1 -
/// q), q the largest share of its light that an element returns of what arrives from all.
void judge(const ExchangeAreas& areas, std::span<const Reflector> reflectors,
           SweptRadiosity& swept) {
    double residual = 0, returned = 0;
    std::vector<double> sizes;
    Rgb escaped;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const Rgb arriving = arriving_light(areas, swept.radiosity, i);
        const Rgb next = reflectors[i].exitance + reflectors[i].reflectance * arriving;
        const double row_sum = areas.row_sum(i);
        residual = std::max(residual, largest_part(next - swept.radiosity[i]));
        returned = std::max(returned, max_channel(reflectors[i].reflectance) * row_sum);
        escaped += swept.radiosity[i] * (areas.area(i) * (1 - row_sum));
        sizes.push_back(areas.area(i));
        swept.arriving.push_back(arriving);
    }
    swept.error =
        returned < 1 ? residual / (1 - returned) : std::numeric_limits<double>::infinity();
    swept.balance = energy_balance(sizes, reflectors, swept.arriving, escaped);
}

} // namespace

SweptRadiosity solve_by_gauss_seidel(const ExchangeAreas& areas,
                                     std::span<const Reflector> reflectors,
                                     const SweepOptions& options, const Job& job) {
    assert(reflectors.size() == areas.size());
    SweptRadiosity swept;
    for (const Reflector& reflector : reflectors) swept.radiosity.push_back(reflector.exitance);
    while (swept.sweeps < options.most_sweeps) {
        job.check();
        const Sweep last = sweep(areas, reflectors, swept.radiosity);
        ++swept.sweeps;
        if (!(last.change > options.change * last.largest)) break;
    }
    judge(areas, reflectors, swept);
    return swept;
}

} // namespace keiko
