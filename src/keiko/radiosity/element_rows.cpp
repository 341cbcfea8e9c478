#include "keiko/radiosity/element_rows.h"

#include "keiko/base/parallel.h"
#include "keiko/radiosity/hemisphere_directions.h"

#include <algorithm>

namespace keiko {
namespace {

/// Rays that find what a face can see at all.
constexpr int first_rays = 128;
/// Rays from one place of an element: enough for tracing them together.
constexpr int rays_of_place = 64;

} // namespace

ElementRows::ElementRows(const Elements& elements, const GatherRays& gather, int rays)
    : elements_(elements),
      gather_(gather),
      rays_(rays),
      rows_(2 * elements.size()),
      leaving_(rows_.size()),
      reached_(rows_.size(), true),
      complete_(rows_.size()) {}

void ElementRows::compute_row(std::size_t face, int rays) {
    const std::size_t own = face % elements_.size();
    std::vector<LightPoint> places;
    const HemisphereDirections spread(2 * rows_.size() + face);
    for (int i = 0; i < std::max(1, rays / rays_of_place); ++i) {
        places.push_back(elements_.point(own, spread.place(static_cast<std::uint32_t>(i))));
        if (face != own) places.back().normal = -places.back().normal;
    }
    std::vector<std::uint32_t> met;
    for (const MetElement& element : gather_.met(places, rays, face)) met.push_back(element.face);
    std::sort(met.begin(), met.end());
    std::vector<Entry> row;
    double leaving = 0;
    for (auto from = met.begin(); from != met.end();) {
        const auto to = std::upper_bound(from, met.end(), *from);
        const double share = static_cast<double>(to - from) / rays;
        if (*from == MetElement::leaves)
            leaving = share;
        else if (*from != MetElement::is_lost)
            row.push_back({*from, static_cast<float>(share)});
        from = to;
    }
    row.shrink_to_fit();
    rows_[face] = std::move(row);
    leaving_[face] = leaving;
}

/// A face is reached if it is lit, or sees one that is reached.
void ElementRows::find_reached(const std::vector<bool>& lit) {
    std::vector<std::vector<std::uint32_t>> seen_by(rows_.size());
    for (std::uint32_t face = 0; face < rows_.size(); ++face)
        for (const Entry& entry : rows_[face]) seen_by[entry.face].push_back(face);
    reached_ = lit;
    std::vector<std::uint32_t> todo;
    for (std::uint32_t face = 0; face < lit.size(); ++face)
        if (lit[face]) todo.push_back(face);
    while (!todo.empty()) {
        const std::uint32_t from = todo.back();
        todo.pop_back();
        for (const std::uint32_t face : seen_by[from])
            if (!reached_[face]) reached_[face] = true, todo.push_back(face);
    }
}

void ElementRows::compute(const std::vector<bool>& lit, const Job& job) {
    parallel_for(rows_.size(), job, "first form factors",
                 [&](std::size_t face) { compute_row(face, std::min(first_rays, rays_)); });
    find_reached(lit);
    parallel_for(rows_.size(), job, "form factors", [&](std::size_t face) {
        if (reached_[face]) compute_row(face, rays_), complete_[face] = 1;
    });
}

Rgb ElementRows::arriving(std::size_t face, std::span<const Rgb> radiosity) const {
    Rgb sum;
    for (const Entry& entry : rows_[face])
        sum += radiosity[entry.face] * static_cast<double>(entry.factor);
    return sum;
}

double ElementRows::form_factor(std::size_t from, std::size_t to) const {
    const auto found = std::find_if(rows_[from].begin(), rows_[from].end(),
                                    [&](const Entry& entry) { return entry.face == to; });
    return found == rows_[from].end() ? 0 : static_cast<double>(found->factor);
}

std::size_t ElementRows::computed() const {
    return static_cast<std::size_t>(std::count(complete_.begin(), complete_.end(), 1));
}

} // namespace keiko
