#include "keiko/placement/bar_rows.h"

#include "keiko/math/even_pitch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace keiko {
namespace {

/// mm within which lengths and places are the same, and share of 1 within which directions are.
constexpr double same_length = 1e-4, same_direction = 1e-6;

/// A rectangular panel with its long sides along u.
struct Bar {
    Vec3 middle, u, v; ///< u and v from side to side
    Vec3 normal;       ///< unit, of the face that shines
    Rgb luminance;

    Vec3 along() const { return u.normalized(); }
    Vec3 across() const { return normal.cross(along()); }
};

/// The direction or its opposite, whose first coordinate that counts is above 0.
Vec3 upwards(const Vec3& direction) {
    const double size = same_direction * direction.length();
    for (const double coordinate : {direction.x, direction.y, direction.z})
        if (std::abs(coordinate) > size) return coordinate > 0 ? direction : -direction;
    return direction;
}

std::optional<Bar> bar_of(const PolygonLight& panel) {
    const std::vector<Vec3>& c = panel.corners;
    if (c.size() != 4) return {};
    Vec3 u = c[1] - c[0], v = c[3] - c[0];
    const bool parallel = (c[2] - c[1] - v).length() < same_length;
    if (!parallel || std::abs(u.dot(v)) > same_direction * u.length() * v.length()) return {};
    if (u.length() < v.length()) std::swap(u, v);
    return Bar{(c[0] + c[2]) / 2, upwards(u), upwards(v), panel.normal(), panel.luminance};
}

/// Numbers that bars of one row share.
using RowKey = std::array<std::int64_t, 10>;

RowKey row_key(const Bar& bar) {
    RowKey key{};
    const Vec3 along = bar.along();
    for (unsigned i = 0; i < 3; ++i) {
        key[i] = std::llround(bar.normal[i] / same_direction);
        key[i + 3] = std::llround(along[i] / same_direction);
    }
    const std::array<double, 4> lengths{bar.normal.dot(bar.middle), along.dot(bar.middle),
                                        bar.u.length(), bar.v.length()};
    for (std::size_t i = 0; i < 4; ++i) key[i + 6] = std::llround(lengths[i] / same_length);
    return key;
}

/// `count` bars from the first one on, `pitch` mm apart across them.
CPlane row_from(const Bar& first, int count, double pitch) {
    const Vec3 across = first.across() * pitch;
    CPlane row;
    row.origin = first.middle - (first.u + across) / 2;
    row.u = first.u, row.v = across * count;
    row.lamps = count, row.diameter = 0;
    row.luminance = first.luminance;
    return row;
}

/// Appends bars of one key, as one row if they are equally far apart.
void append_row(std::vector<Bar> bars, std::vector<CPlane>& rows) {
    const Vec3 across = bars.front().across();
    std::sort(bars.begin(), bars.end(), [&](const Bar& a, const Bar& b) {
        return across.dot(a.middle) < across.dot(b.middle);
    });
    std::vector<double> levels;
    for (const Bar& bar : bars) levels.push_back(across.dot(bar.middle - bars.front().middle));
    if (const auto pitch = even_pitch(levels, same_length))
        return rows.push_back(row_from(bars.front(), static_cast<int>(bars.size()), *pitch));
    for (const Bar& bar : bars) rows.push_back(row_from(bar, 1, bar.v.length()));
}

std::vector<Bar> bars_of(const LightRig& rig, const Vec3& body) {
    std::vector<Bar> bars;
    for (const LightSource& source : rig.sources) {
        const auto* panel = std::get_if<PolygonLight>(&source);
        if (!panel || !panel->shown || !panel->shines_at(body)) continue;
        if (const auto bar = bar_of(*panel)) bars.push_back(*bar);
    }
    return bars;
}

} // namespace

std::vector<CPlane> rows_of(const LightRig& rig, const Vec3& body) {
    std::vector<CPlane> rows;
    for (const LightSource& source : rig.sources)
        if (const auto* tubes = std::get_if<CPlane>(&source)) rows.push_back(*tubes);
    std::vector<std::vector<Bar>> groups;
    std::map<RowKey, std::size_t> group_of;
    for (const Bar& bar : bars_of(rig, body)) {
        const auto [group, is_new] = group_of.try_emplace(row_key(bar), groups.size());
        if (is_new) groups.emplace_back();
        groups[group->second].push_back(bar);
    }
    for (std::vector<Bar>& group : groups) append_row(std::move(group), rows);
    return rows;
}

LampKind kind_of(const LightRig& rig, const std::vector<CPlane>& rows) {
    const auto is_tube = [](const LightSource& light) {
        return std::holds_alternative<CPlane>(light);
    };
    if (std::any_of(rig.sources.begin(), rig.sources.end(), is_tube)) return LampKind::tube;
    const bool several =
        std::any_of(rows.begin(), rows.end(), [](const CPlane& row) { return row.lamps > 1; });
    return several ? LampKind::screen : LampKind::panel;
}

} // namespace keiko
