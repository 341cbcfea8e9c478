#include "keiko/inspect/lines/line_sources.h"

#include "keiko/math/even_pitch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace keiko {
namespace {

/// mm within which corners are one, and share of 1 within which directions are.
constexpr double same_place = 1e-4, same_direction = 1e-6;

/// A side of a panel; viewed from its shining face the panel lies to its left.
struct PanelEdge {
    Segment side;
    Vec3 normal;
    const PolygonLight* panel;

    Vec3 direction() const { return (side.b - side.a).normalized(); }
    double length() const { return (side.b - side.a).length(); }
    /// Unit direction in the panel's plane, towards its inside.
    Vec3 inwards() const { return normal.cross(direction()); }
};

std::int64_t rounded(double value, double step) {
    return std::llround(value / step);
}

std::array<std::int64_t, 3> cell(const Vec3& v, double step) {
    return {rounded(v.x, step), rounded(v.y, step), rounded(v.z, step)};
}

std::vector<PanelEdge> edges_of(const LightRig& rig) {
    std::vector<PanelEdge> edges;
    for (const LightSource& source : rig.sources) {
        const auto* panel = std::get_if<PolygonLight>(&source);
        if (!panel || !panel->shown) continue;
        const Vec3 normal = panel->normal();
        for (std::size_t i = 0; i < panel->corners.size(); ++i) {
            const Vec3& next = panel->corners[(i + 1) % panel->corners.size()];
            edges.push_back({{panel->corners[i], next}, normal, panel});
        }
    }
    return edges;
}

/// The edges of panels that run along the same place the other way, by their ends.
class EdgePartners {
public:
    explicit EdgePartners(std::span<const PanelEdge> edges) : edges_(edges) {
        for (std::size_t i = 0; i < edges.size(); ++i) at_[key(edges[i].side)].push_back(i);
    }
    /// The partner where whose panel shines edge `i` is none: one of the same luminance, or an
    /// earlier one, so that each edge is found once. Null without any.
    const PanelEdge* of(std::size_t i) const {
        const Segment& side = edges_[i].side;
        const auto found = at_.find(key({side.b, side.a}));
        if (found == at_.end()) return nullptr;
        for (const std::size_t other : found->second)
            if (other < i || edges_[other].panel->luminance == edges_[i].panel->luminance)
                return &edges_[other];
        return nullptr;
    }

private:
    using Key = std::array<std::array<std::int64_t, 3>, 2>;
    static Key key(const Segment& side) {
        return {cell(side.a, same_place), cell(side.b, same_place)};
    }

    std::span<const PanelEdge> edges_;
    std::map<Key, std::vector<std::size_t>> at_;
};

/// True if a panel is dark wherever another one is, so that an edge between them is never one.
bool always_shines_with(const PanelEdge& other, const PanelEdge& own) {
    return other.panel->two_sided ||
           (!own.panel->two_sided && (other.normal - own.normal).length() < same_direction);
}

/// Numbers that edges of one source share.
using RowKey = std::array<std::int64_t, 10>;

RowKey row_key(const PanelEdge& edge) {
    const auto normal = cell(edge.normal, same_direction);
    const auto along = cell(edge.direction(), same_direction);
    return {normal[0],
            normal[1],
            normal[2],
            along[0],
            along[1],
            along[2],
            rounded(edge.normal.dot(edge.side.a), same_place),
            rounded(edge.direction().dot(edge.side.a), same_place),
            rounded(edge.length(), same_place),
            edge.panel->two_sided};
}

/// `count` edges, the first of them `first`, `pitch` mm apart across them.
LineSource source_of(const PanelEdge& first, int count, double pitch) {
    const Vec3 across = first.inwards() * pitch;
    CPlane row;
    row.origin = first.side.a - across / 2;
    row.u = first.side.b - first.side.a, row.v = across * count;
    row.lamps = count, row.pitch = pitch, row.diameter = 0;
    row.luminance = first.panel->luminance;
    LineSource source(row);
    source.of_panels = true, source.one_sided = !first.panel->two_sided;
    return source;
}

/// Appends the edges of one key, in one source if they are equally far apart.
void append_row(std::vector<PanelEdge> edges, std::vector<LineSource>& sources) {
    const Vec3 across = edges.front().inwards();
    const auto level = [&](const PanelEdge& edge) { return across.dot(edge.side.a); };
    std::sort(edges.begin(), edges.end(),
              [&](const PanelEdge& a, const PanelEdge& b) { return level(a) < level(b); });
    std::vector<double> levels;
    for (const PanelEdge& edge : edges) levels.push_back(level(edge));
    if (const auto pitch = even_pitch(levels, same_place))
        return sources.push_back(source_of(edges.front(), static_cast<int>(edges.size()), *pitch));
    for (const PanelEdge& edge : edges) sources.push_back(source_of(edge, 1, edge.length()));
}

void append_edges(std::span<const PanelEdge> edges, std::vector<LineSource>& sources) {
    const EdgePartners partners(edges);
    std::vector<std::vector<PanelEdge>> rows;
    std::map<RowKey, std::size_t> row_of;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const PanelEdge* partner = partners.of(i);
        if (partner && always_shines_with(*partner, edges[i])) continue;
        if (partner) {
            sources.push_back(source_of(edges[i], 1, edges[i].length()));
            sources.back().beyond = partner->normal;
            continue;
        }
        const auto [row, is_new] = row_of.try_emplace(row_key(edges[i]), rows.size());
        if (is_new) rows.emplace_back();
        rows[row->second].push_back(edges[i]);
    }
    for (std::vector<PanelEdge>& row : rows) append_row(std::move(row), sources);
}

} // namespace

Segment LineSource::line(int number) const {
    const CPlaneFrame frame(row);
    return {frame.at(0, frame.axis(number)), frame.at(frame.length, frame.axis(number))};
}

bool LineSource::is_visible_from(const Vec3& place) const {
    if (!of_panels) return true;
    const Vec3 way = place - line(0).a;
    if (one_sided && !(row.u.cross(row.v).dot(way) > 0)) return false;
    return !beyond || !(beyond->dot(way) > 0);
}

std::vector<LineSource> line_sources(const LightRig& rig, LineLook look) {
    std::vector<LineSource> sources;
    for (const LightSource& source : rig.sources)
        if (const auto* tubes = std::get_if<CPlane>(&source)) sources.emplace_back(*tubes);
    if (look != LineLook::isophote) append_edges(edges_of(rig), sources);
    return sources;
}

} // namespace keiko
