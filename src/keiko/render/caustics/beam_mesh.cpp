#include "keiko/render/caustics/beam_mesh.h"

#include "keiko/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace keiko {
namespace {

constexpr int most_halvings = 2;
/// Bend of a beam's sides at which its cell is halved, as a share of the cell's longest side.
constexpr double most_bend = 0.08;
/// Bend beyond which the rays of a cell that is not halved any more do not go side by side.
constexpr double torn = 1;

/// A ray of the grid: where it lands, and its light.
struct Node {
    Vec2 at{0};
    Rgb flux;
    std::vector<LightLanding> landings;
};
using Corners =
    std::array<const Node*, 4>; ///< of a cell: lower left and right, upper left and right

/// The landing of a node by a way on a surface; null if there is none.
const LightLanding* landing_like(const Node& node, const LightLanding& like) {
    for (const LightLanding& landing : node.landings)
        if (landing.way == like.way && landing.face == like.face &&
            landing.instance == like.instance)
            return &landing;
    return nullptr;
}

Vec3 moved(const LightLanding& landing, const Vec2& by) {
    return landing.dx * by.x + landing.dy * by.y;
}

/// How far the image of the side between two nodes is from straight, and its length, mm.
struct Side {
    double bend, length;
};
Side side_of(const Node& a, const Node& b, const LightLanding& from, const LightLanding& to) {
    const Vec2 step = b.at - a.at;
    const Vec3 begin = moved(from, step), end = moved(to, step),
               chord = to.position - from.position;
    // What the ends do not explain is a tear.
    const double gap = (chord - (begin + end) * 0.5).length();
    return {(end - begin).length() / 8 + gap, chord.length()};
}

/// Beams of the cells of a chart's grid.
class Cells {
public:
    Cells(const LightChart& chart, const LightPaths& paths) : chart_(chart), paths_(paths) {}

    Node node(const Vec2& at) const {
        check_stop();
        Node node{at, chart_.flux(at), {}};
        if (max_channel(node.flux) > 0) node.landings = paths_.landings(chart_, at);
        std::erase_if(node.landings,
                      [&](const LightLanding& landing) { return !chart_.reaches(landing.first); });
        return node;
    }

    void add(const Corners& cell, int halvings, std::vector<Beam>& beams) const {
        if (std::all_of(cell.begin(), cell.end(),
                        [](const Node* node) { return node->landings.empty(); }))
            return;
        if (halvings < most_halvings && !is_even(cell)) return add_halves(cell, halvings, beams);
        for (const auto& three :
             {std::array{cell[0], cell[1], cell[3]}, std::array{cell[0], cell[3], cell[2]}})
            for (const LightLanding& first : three[0]->landings) add_beam(three, first, beams);
    }

private:
    /// True if all four rays land alike and the images of the sides are nearly straight.
    static bool is_even(const Corners& cell) {
        const std::size_t count = cell[0]->landings.size();
        for (const Node* node : cell)
            if (node->landings.size() != count) return false;
        return std::all_of(
            cell[0]->landings.begin(), cell[0]->landings.end(),
            [&](const LightLanding& first) { return bend_of(cell, first) < most_bend; });
    }
    /// The largest bend of the sides and the diagonal as a share of their greatest length.
    template <std::size_t n>
    static double bend_of(const std::array<const Node*, n>& cell, const LightLanding& like) {
        double bend = 0, length = 0;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const LightLanding* from = landing_like(*cell[k], like);
                const LightLanding* to = landing_like(*cell[i], like);
                if (!from || !to) return torn;
                const Side side = side_of(*cell[k], *cell[i], *from, *to);
                bend = std::max(bend, side.bend), length = std::max(length, side.length);
            }
        return length > 0 ? bend / length : 0;
    }

    void add_halves(const Corners& cell, int halvings, std::vector<Beam>& beams) const {
        const auto between = [&](int a, int b) { return node((cell[a]->at + cell[b]->at) * 0.5); };
        const Node low = between(0, 1), left = between(0, 2), right = between(1, 3);
        const Node high = between(2, 3), middle = between(0, 3);
        add({cell[0], &low, &left, &middle}, halvings + 1, beams);
        add({&low, cell[1], &middle, &right}, halvings + 1, beams);
        add({&left, &middle, cell[2], &high}, halvings + 1, beams);
        add({&middle, &right, &high, cell[3]}, halvings + 1, beams);
    }

    void add_beam(const std::array<const Node*, 3>& three, const LightLanding& first,
                  std::vector<Beam>& beams) const {
        if (!(bend_of(three, first) < torn)) return;
        Beam beam{first.instance, first.face, first.way};
        for (std::size_t i = 0; i < 3; ++i) {
            const LightLanding& landing = *landing_like(*three[i], first);
            const Rgb flux = three[i]->flux * landing.weight;
            const double area = landing.dx.cross(landing.dy).length();
            beam.corners[i] = landing.position, beam.at[i] = three[i]->at;
            beam.density[i] = area > 0 ? luminance(flux) / area : 0;
            beam.normal += landing.normal, beam.direction += landing.direction;
            beam.flux += flux / 3;
        }
        const Vec2 u = beam.at[1] - beam.at[0], v = beam.at[2] - beam.at[0];
        beam.flux *= std::abs(u.cross(v)) / 2;
        beam.normal.normalize(), beam.direction.normalize();
        beams.push_back(beam);
    }

    const LightChart& chart_;
    const LightPaths& paths_;
};

} // namespace

std::vector<Beam> beams_of(const LightChart& chart, const LightPaths& paths,
                           const CausticSpec& spec, const Job& job) {
    const Cells cells(chart, paths);
    const auto count = static_cast<std::size_t>(spec.detail), width = count + 1;
    const Vec2 low = chart.range().lower, step = chart.range().extent() / spec.detail;
    std::vector<Node> nodes(width * width);
    parallel_for(width, job, "caustics", [&](std::size_t y) {
        for (std::size_t x = 0; x < width; ++x)
            nodes[y * width + x] =
                cells.node(low + step * Vec2(static_cast<double>(x), static_cast<double>(y)));
    });
    std::vector<std::vector<Beam>> rows(count);
    parallel_for(count, job, "caustics", [&](std::size_t y) {
        for (std::size_t x = 0; x < count; ++x) {
            const Node* corner = &nodes[y * width + x];
            cells.add({corner, corner + 1, corner + width, corner + width + 1}, 0, rows[y]);
        }
    });
    std::vector<Beam> beams;
    for (std::vector<Beam>& row : rows)
        beams.insert(beams.end(), std::make_move_iterator(row.begin()),
                     std::make_move_iterator(row.end()));
    return beams;
}

} // namespace keiko
