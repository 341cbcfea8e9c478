#include "keiko/import/subdivision/cage_statements.h"

#include <map>
#include <numeric>
#include <unordered_map>

namespace keiko::subdivision {

namespace {

/// One side of an edge: the corner (into Cage::corners) from which its face runs to the next.
using HalfEdges = std::unordered_map<std::uint64_t, std::uint32_t>;

std::uint64_t key(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t{from} << 32 | to;
}

std::string edge_name(std::uint32_t a, std::uint32_t b) {
    return "the edge between vertices " + std::to_string(a + 1) + " and " + std::to_string(b + 1);
}

class Manifold {
public:
    Manifold(Cage& cage, const CageLines& lines) : cage_(cage), lines_(lines) {}

    void make() {
        collect_half_edges();
        find_creases();
        split_vertices();
        for (std::size_t i = 0; i < crease_corners_.size(); ++i) {
            cage_.creases[i].a = cage_.corners[crease_corners_[i]];
            cage_.creases[i].b = cage_.corners[next_[crease_corners_[i]]];
        }
    }

private:
    void collect_half_edges();
    /// Tells why the edge from a to b cannot be: too many faces, or one turned over.
    [[noreturn]] void refuse(std::uint32_t a, std::uint32_t b, std::uint32_t line) const;
    /// Drops creases that are no edges; remembers the others by a corner that splitting keeps.
    void find_creases();
    /// A copy for every fan of faces around a vertex but the first.
    void split_vertices();
    std::vector<std::uint32_t> fan_of_corners() const;

    Cage& cage_;
    const CageLines& lines_;
    HalfEdges half_edges_;
    std::vector<std::uint32_t> next_, previous_, face_line_; ///< a corner
    std::vector<std::uint32_t> crease_corners_;              ///< a crease
};

void Manifold::collect_half_edges() {
    for (const CageFace& face : cage_.faces) {
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const std::uint32_t corner = face.first_corner + k;
            next_.push_back(face.first_corner + (k + 1) % face.corner_count);
            previous_.push_back(face.first_corner +
                                (k + face.corner_count - 1) % face.corner_count);
            face_line_.push_back(face.line);
            const std::uint32_t a = cage_.corners[corner], b = cage_.corner(face, k + 1);
            const auto [known, fresh] = half_edges_.try_emplace(key(a, b), corner);
            if (!fresh) refuse(a, b, face.line);
        }
    }
}

void Manifold::refuse(std::uint32_t a, std::uint32_t b, std::uint32_t line) const {
    std::size_t count = 0;
    std::string lines;
    for (const CageFace& face : cage_.faces)
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const std::uint32_t from = cage_.corner(face, k), to = cage_.corner(face, k + 1);
            if (!(from == a && to == b) && !(from == b && to == a)) continue;
            constexpr std::size_t most_told = 8;
            if (++count <= most_told)
                lines += (lines.empty() ? "" : ", ") + std::to_string(face.line);
        }
    const std::string edge = edge_name(a, b);
    lines_.fail(line, count > 2 ? edge + " has " + std::to_string(count) + " faces (lines " +
                                      lines + "): a surface has two there at most"
                                : "the faces of lines " + lines + " run the same way along " +
                                      edge + ": one of them is turned over");
}

void Manifold::find_creases() {
    std::vector<CageCrease> kept;
    for (const CageCrease& crease : cage_.creases) {
        auto side = half_edges_.find(key(crease.a, crease.b));
        if (side == half_edges_.end()) side = half_edges_.find(key(crease.b, crease.a));
        if (side == half_edges_.end()) {
            cage_.diagnostics.push_back({Severity::warning, "line " + std::to_string(crease.line),
                                         "the crease between vertices " + std::to_string(crease.a) +
                                             " and " + std::to_string(crease.b) +
                                             " (from 0) is no edge: ignored"});
            continue;
        }
        kept.push_back(crease);
        crease_corners_.push_back(side->second);
    }
    cage_.creases = std::move(kept);
}

/// Corners of one vertex that share an edge have the same representative.
std::vector<std::uint32_t> Manifold::fan_of_corners() const {
    std::vector<std::uint32_t> parent(cage_.corners.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto find = [&](std::uint32_t x) {
        while (parent[x] != x) x = parent[x] = parent[parent[x]];
        return x;
    };
    for (std::uint32_t c = 0; c < cage_.corners.size(); ++c) {
        const auto twin = half_edges_.find(key(cage_.corners[next_[c]], cage_.corners[c]));
        if (twin == half_edges_.end()) continue;
        // The twin runs back: its end is the vertex where this one begins.
        const std::uint32_t here = find(c), there = find(next_[twin->second]);
        parent[std::max(here, there)] = std::min(here, there);
    }
    for (std::uint32_t c = 0; c < parent.size(); ++c) parent[c] = find(c);
    return parent;
}

void Manifold::split_vertices() {
    const std::vector<std::uint32_t> fans = fan_of_corners();
    std::vector<std::uint32_t> first_fan(cage_.vertices.size(), ~0u);
    std::map<std::uint32_t, std::uint32_t> copies; // of a fan
    std::size_t split = 0;
    const auto sharpen = [&](std::uint32_t vertex) {
        cage_.sharp_corners.push_back({vertex, infinite_sharpness});
    };
    for (std::uint32_t c = 0; c < fans.size(); ++c) {
        const std::uint32_t vertex = cage_.corners[c];
        if (first_fan[vertex] == ~0u) first_fan[vertex] = fans[c];
        if (first_fan[vertex] == fans[c]) continue;
        const auto [copy, fresh] =
            copies.try_emplace(fans[c], static_cast<std::uint32_t>(cage_.vertices.size()));
        if (fresh) {
            cage_.vertices.push_back(cage_.vertices[vertex]);
            first_fan.push_back(fans[c]);
            sharpen(vertex), sharpen(copy->second);
            ++split;
        }
        cage_.corners[c] = copy->second;
    }
    if (split > 0)
        cage_.diagnostics.push_back(
            {Severity::note, "",
             std::to_string(split) +
                 " times fans of faces touch in one vertex only: sharp corners"});
}

} // namespace

void make_manifold(Cage& cage, const CageLines& lines) {
    Manifold(cage, lines).make();
}

namespace {

/// Whether all corners lie on one line, to within rounding.
bool on_a_line(const Cage& cage, const CageFace& face) {
    const Vec3& origin = cage.vertices[cage.corner(face, 0)];
    Vec3 longest(0);
    for (std::uint32_t k = 1; k < face.corner_count; ++k) {
        const Vec3 way = cage.vertices[cage.corner(face, k)] - origin;
        if (way.dot(way) > longest.dot(longest)) longest = way;
    }
    constexpr double rounding = 1e-12;
    const double square = longest.dot(longest);
    for (std::uint32_t k = 1; k < face.corner_count; ++k) {
        const Vec3 way = cage.vertices[cage.corner(face, k)] - origin;
        if (way.cross(longest).length() > rounding * square) return false;
    }
    return true;
}

} // namespace

void check_areas(Cage& cage, const CageLines& lines) {
    std::size_t flat = 0;
    std::string told;
    for (const CageFace& face : cage.faces) {
        if (!on_a_line(cage, face)) continue;
        constexpr std::size_t most_told = 8;
        if (++flat <= most_told) told += (told.empty() ? "" : ", ") + std::to_string(face.line);
    }
    if (flat == cage.faces.size())
        throw Error(lines.file(), "", "no face of the cage has an area: it is no surface");
    if (flat > 0)
        cage.diagnostics.push_back({Severity::warning, "",
                                    std::to_string(flat) + (flat == 1 ? " face" : " faces") +
                                        " of the cage without area (lines " + told +
                                        (flat > 8 ? ", ...)" : ")")});
}

} // namespace keiko::subdivision
