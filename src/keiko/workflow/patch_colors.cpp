#include "keiko/workflow/patch_colors.h"

#include <array>
#include <set>

namespace keiko {
namespace {

const std::array<Rgb, 12> palette{
    Rgb(0.55, 0.75, 0.9),  Rgb(0.98, 0.75, 0.45), Rgb(0.62, 0.83, 0.55), Rgb(0.95, 0.6, 0.6),
    Rgb(0.78, 0.68, 0.88), Rgb(0.96, 0.9, 0.5),   Rgb(0.5, 0.8, 0.76),   Rgb(0.88, 0.7, 0.55),
    Rgb(0.7, 0.78, 0.4),   Rgb(0.95, 0.72, 0.85), Rgb(0.72, 0.75, 0.8),  Rgb(0.45, 0.62, 0.8)};

using Neighbours = std::map<int, std::set<int>>;

/// The patch of the body; -1 without one.
int patch_at(const FilmSight& sight, int x, int y) {
    return sight.is_body(x, y) ? static_cast<int>(*sight.layer(Aov::patch, x, y)) : -1;
}

/// Patches that pixels side by side show.
Neighbours neighbours_in(const FilmSight& sight) {
    Neighbours all;
    const auto note = [&](int a, int b) {
        if (a != b && a >= 0 && b >= 0) all[a].insert(b), all[b].insert(a);
    };
    for (int y = 0; y < sight.height(); ++y)
        for (int x = 0; x < sight.width(); ++x) {
            const int patch = patch_at(sight, x, y);
            if (patch >= 0) all[patch];
            if (x + 1 < sight.width()) note(patch, patch_at(sight, x + 1, y));
            if (y + 1 < sight.height()) note(patch, patch_at(sight, x, y + 1));
        }
    return all;
}

} // namespace

std::map<int, Rgb> patch_colors(const FilmSight& sight) {
    constexpr std::size_t count = palette.size(), spread = 5; // neighbours often follow in the file
    std::map<int, std::size_t> chosen;
    for (const auto& [patch, beside] : neighbours_in(sight)) {
        std::set<std::size_t> taken;
        for (const int other : beside)
            if (const auto found = chosen.find(other); found != chosen.end())
                taken.insert(found->second);
        const std::size_t own = static_cast<std::size_t>(patch) * spread % count;
        std::size_t color = own;
        for (std::size_t i = 0; i < count && taken.contains(color); ++i) color = (own + i) % count;
        chosen[patch] = color;
    }
    std::map<int, Rgb> colors;
    for (const auto& [patch, color] : chosen) colors[patch] = palette[color];
    return colors;
}

} // namespace keiko
