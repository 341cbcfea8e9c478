#include "keiko/radiosity/element_rows.h"

#include "keiko/base/parallel.h"
#include "keiko/radiosity/triangle_cubature.h"

#include <algorithm>
#include <utility>

namespace keiko {
namespace {

/// Rows computed side by side.
constexpr std::size_t at_once = 32;

} // namespace

ElementRows::ElementRows(const ElementMesh& elements, int cells, std::vector<std::size_t> order,
                         const Job& job)
    : elements_(elements),
      cube_(cells),
      order_(std::move(order)),
      job_(job),
      rows_(2 * elements.size()) {}

std::vector<ElementRows::Entry> ElementRows::computed_row(std::size_t face) const {
    const std::size_t triangle = face % elements_.size();
    const Vec3 front = elements_.normal(triangle).normalized();
    const Vec3 normal = face < elements_.size() ? front : -front;
    Job alone;
    alone.threads = 1;
    std::vector<double> sum(rows_.size());
    for (const TriangleCorners& quarter :
         quarters({elements_.corner(triangle, 0), elements_.corner(triangle, 1),
                   elements_.corner(triangle, 2)})) {
        const auto factors = cube_.form_factors(elements_.mesh, middle_of(quarter), normal, alone);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factors[i] / 4;
    }
    std::vector<Entry> row;
    for (std::size_t i = 0; i < sum.size(); ++i)
        if (sum[i] > 0) row.push_back({static_cast<std::uint32_t>(i), static_cast<float>(sum[i])});
    return row;
}

void ElementRows::compute(std::span<const std::size_t> faces) {
    parallel_for(faces.size(), job_, "",
                 [&](std::size_t i) { rows_[faces[i]] = computed_row(faces[i]); });
    computed_ += faces.size();
}

std::vector<double> ElementRows::row(std::size_t face) {
    if (!rows_[face]) {
        std::vector<std::size_t> faces{face};
        for (; next_ < order_.size() && faces.size() < at_once; ++next_)
            if (order_[next_] != face && !rows_[order_[next_]]) faces.push_back(order_[next_]);
        compute(faces);
    }
    std::vector<double> areas(rows_.size());
    for (const Entry& entry : *rows_[face])
        areas[entry.face] = static_cast<double>(entry.factor) * area(face);
    return areas;
}

void ElementRows::compute_missing(std::span<const std::size_t> faces) {
    std::vector<std::size_t> missing;
    for (const std::size_t face : faces)
        if (!rows_[face]) missing.push_back(face);
    for (std::size_t i = 0; i < missing.size(); i += at_once) {
        job_.report("gathering", static_cast<double>(i) / static_cast<double>(missing.size()));
        compute(std::span(missing).subspan(i, std::min(at_once, missing.size() - i)));
    }
}

std::vector<Rgb> ElementRows::gathered(std::span<const Rgb> radiosity,
                                       std::span<const std::size_t> faces) {
    compute_missing(faces);
    std::vector<Rgb> light(rows_.size());
    for (const std::size_t face : faces)
        for (const Entry& entry : *rows_[face])
            light[face] += radiosity[entry.face] * static_cast<double>(entry.factor);
    return light;
}

Rgb ElementRows::escaped(std::span<const Rgb> radiosity, std::span<const std::size_t> faces) {
    compute_missing(faces);
    Rgb sum;
    for (const std::size_t face : faces) {
        double lacking = 1;
        for (const Entry& entry : *rows_[face]) lacking -= static_cast<double>(entry.factor);
        sum += radiosity[face] * (lacking * area(face));
    }
    return sum;
}

} // namespace keiko
