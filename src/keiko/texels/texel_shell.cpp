#include "keiko/texels/texel_shell.h"

#include "keiko/texels/fibre_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

constexpr std::array<std::array<unsigned, 3>, 6> orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

ShellCells cells_of(const TexelSpec& spec) {
    // A cell has a light of its own at each node.
    return {.longest = std::max(4 * spec.thickness, 2 * block_side(spec)),
            .deviation = spec.thickness / 100};
}

/// A line of a length in mm, which may meet boxes.
struct Line {
    Vec3 origin, unit;
    double length;

    bool meets(const Box3& box) const {
        double begin = 0, end = length;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const double low = box.lower[axis] - origin[axis];
            const double high = box.upper[axis] - origin[axis];
            if (unit[axis] == 0) {
                if (!(low <= 0 && high >= 0)) return false;
                continue;
            }
            const double a = low / unit[axis], b = high / unit[axis];
            begin = std::max(begin, std::min(a, b)), end = std::min(end, std::max(a, b));
        }
        return begin <= end;
    }
};

/// Run of a line of a length through a part; nullopt if it misses it.
std::optional<ShellRun> run_through(const ShellPart& part, const Vec3& origin, const Vec3& way,
                                    double length) {
    if (part.slopes[2] == Vec3(0)) return {};
    ShellRun run{0, length, &part, part.along(origin - part.corner), part.along(way)};
    const auto cut = [&](double value, double change) { // where it is above 0
        const double zero = -value / change;
        if (change > 0)
            run.begin = std::max(run.begin, zero);
        else if (change < 0)
            run.end = std::min(run.end, zero);
        else if (!(value >= 0))
            run.end = -1;
    };
    const auto [a, b, c] = part.order;
    cut(1 - run.first[a], -run.change[a]);
    cut(run.first[a] - run.first[b], run.change[a] - run.change[b]);
    cut(run.first[b] - run.first[c], run.change[b] - run.change[c]);
    cut(run.first[c], run.change[c]);
    if (!(run.begin < run.end)) return {};
    return run;
}

} // namespace

TexelShell::TexelShell(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                       const TexelSpec& spec, std::shared_ptr<const TexelBlock> block)
    : spec_(&spec),
      block_(std::move(block)),
      lattice_(shell_lattice(model, instance, face, spec.thickness, cells_of(spec))),
      region_(std::make_shared<const TrimRegion>(model, model.faces[face])) {
    const double side = block_side(spec);
    const Vec2 lengths = lattice_.lengths();
    repeats_ = Vec2(std::max(1.0, std::round(lengths.x / side)) / lattice_.cells_u,
                    std::max(1.0, std::round(lengths.y / side)) / lattice_.cells_v);
    std::vector<Box3> boxes;
    for (int i = 0; i < lattice_.cells_u; ++i)
        for (int j = 0; j < lattice_.cells_v; ++j) {
            const TrimSide trim =
                region_->classify({lattice_.parameters(i, j), lattice_.parameters(i + 1, j + 1)});
            if (trim == TrimSide::outside) continue;
            add_cell(i, j, trim == TrimSide::mixed);
            Box3 box;
            for (const int u : {i, i + 1})
                for (const int v : {j, j + 1})
                    box.extend(lattice_.foot[lattice_.index(u, v)]),
                        box.extend(lattice_.top[lattice_.index(u, v)]);
            bounds_.extend(box);
            boxes.push_back(box);
        }
    tree_ = std::make_shared<const BoxTree>(std::move(boxes));
}

void TexelShell::add_cell(int i, int j, bool trimmed) {
    for (const auto& order : orders) {
        ShellPart part{i, j, order, lattice_.foot[lattice_.index(i, j)]};
        part.trimmed = trimmed;
        std::array<int, 3> at{};
        std::array<Vec3, 3> edges{Vec3(0), Vec3(0), Vec3(0)};
        const auto node = [&] {
            const auto& nodes = at[2] == 0 ? lattice_.foot : lattice_.top;
            return nodes[lattice_.index(i + at[0], j + at[1])];
        };
        for (const unsigned axis : order) {
            const Vec3 before = node();
            at[axis] = 1;
            edges[axis] = node() - before;
            part.axes[axis] = edges[axis].normalized();
        }
        const double volume = edges[0].dot(edges[1].cross(edges[2]));
        constexpr double rounding = 1e-9; // a part at a pole has no more volume
        const double box = edges[0].length() * edges[1].length() * edges[2].length();
        const bool flat =
            !(std::abs(volume) > rounding * box) ||
            std::min(edges[0].length(), edges[1].length()) < rounding * edges[2].length();
        for (unsigned axis = 0; axis < 3; ++axis) {
            const Vec3 across = edges[(axis + 1) % 3].cross(edges[(axis + 2) % 3]);
            part.slopes[axis] = flat ? Vec3(0) : across / volume;
        }
        parts_.push_back(part);
    }
}

std::vector<ShellRun> TexelShell::runs(const Segment& segment) const {
    const Vec3 way = segment.b - segment.a;
    const double length = way.length();
    std::vector<ShellRun> runs;
    if (!(length > 0)) return runs;
    const Vec3 unit = way / length;
    const Line line{segment.a, unit, length};
    tree_->any_of([&](const Box3& box) { return line.meets(box); },
                  [&](std::uint32_t cell) {
                      for (std::size_t part = 6 * std::size_t(cell); part < 6 * (cell + 1); ++part)
                          if (const auto run = run_through(parts_[part], segment.a, unit, length))
                              runs.push_back(*run);
                      return false;
                  });
    std::sort(runs.begin(), runs.end(),
              [](const ShellRun& a, const ShellRun& b) { return a.begin < b.begin; });
    return runs;
}

std::vector<bool> TexelShell::used_nodes() const {
    std::vector<bool> used(lattice_.foot.size());
    for (const ShellPart& part : parts_)
        for (const int u : {part.cell_u, part.cell_u + 1})
            for (const int v : {part.cell_v, part.cell_v + 1}) used[lattice_.index(u, v)] = true;
    return used;
}

bool TexelShell::is_material(const ShellPart& part, const Vec3& in_cell) const {
    return !part.trimmed ||
           region_->contains(lattice_.parameters(part.cell_u + in_cell.x, part.cell_v + in_cell.y));
}

Fibres TexelShell::fibres(const ShellPart& part, const Vec3& in_cell, int level) const {
    Fibres found = block_->at(block_place(part, in_cell), level);
    const Vec3& way = found.direction;
    found.direction = part.axes[0] * way.x + part.axes[1] * way.y + part.axes[2] * way.z;
    return found;
}

double TexelShell::depth_outwards(const ShellPart& part, const Vec3& in_cell, const Vec3& towards,
                                  int level, double most) const {
    const Vec3 change = part.along(towards);
    if (!(change.z > 0)) return most; // into the body
    double length = (1 - in_cell.z) / change.z;
    const auto end_at_side = [&](double place, double way, int cells) {
        if (way != 0) length = std::min(length, ((way > 0 ? cells : 0) - place) / way);
    };
    end_at_side(part.cell_u + in_cell.x, change.x, lattice_.cells_u);
    end_at_side(part.cell_v + in_cell.y, change.y, lattice_.cells_v);
    if (!(length > 0)) return 0;
    constexpr double most_steps = 256; // longer ones for light that grazes a face
    const double count = std::min(std::ceil(length / step(level)), most_steps);
    const double part_step = length / count;
    double depth = 0;
    for (double i = 0; i < count && depth < most; ++i) {
        const Vec3 at = in_cell + change * ((i + 0.5) * part_step);
        depth += block_->at(block_place(part, at), level).extinction * part_step;
    }
    return std::min(depth, most);
}

} // namespace keiko
