#include "keiko/radiosity/exchange_areas.h"

#include "keiko/base/parallel.h"

namespace keiko {

ExchangeAreas::ExchangeAreas(std::vector<double> areas, const OfPair& of_pair, const Job& job)
    : areas_(std::move(areas)), pairs_(place(areas_.size(), 0)) {
    parallel_for(size(), job, "form factors", [&](std::size_t i) {
        for (std::size_t j = 0; j <= i; ++j) pairs_[place(i, j)] = of_pair(i, j);
    });
}

double ExchangeAreas::row_sum(std::size_t i) const {
    double sum = 0;
    for (std::size_t j = 0; j < size(); ++j) sum += form_factor(i, j);
    return sum;
}

std::vector<double> ExchangeAreas::row(std::size_t i) const {
    std::vector<double> areas(size());
    for (std::size_t j = 0; j < size(); ++j) areas[j] = between(i, j);
    return areas;
}

} // namespace keiko
