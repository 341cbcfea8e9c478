#include "tests/bench/grid_choice.h"

#include "tests/bench/accuracy.h"
#include "tests/bench/mesh_contender.h"
#include "tests/bench/place_tolerance.h"
#include "tests/bench/span_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

namespace keiko::bench {
namespace {

constexpr double wanted = 0.1; // px, p99.9 of the zebra error
constexpr int coarsest = 4;
constexpr double close_enough = 1.15; // of n

double zebra_error(const Contender& grid, const RaySet& primary, const Box3& bounds) {
    const auto pass = grid.pass(primary, Mode::single);
    pass->run();
    const Accuracy accuracy =
        judged(primary, pass->answers(), 1, place_tolerance(grid.facts(), bounds));
    return accuracy.zebra ? accuracy.zebra->p999 : 0;
}

/// The error falls with the square of n, at best.
int finer(int n, double error) {
    const double factor = std::clamp(std::sqrt(error / wanted), 1.2, 4.0);
    return static_cast<int>(std::ceil(n * factor));
}

std::string remark(int n, double error) {
    char text[80];
    std::snprintf(text, sizeof text, "n = %d, zebra p99.9 %.2g px%s", n, error,
                  error <= wanted ? "" : " (0.1 not reached)");
    return text;
}

/// A grid and what it is worth.
struct Candidate {
    int n = 0;
    std::unique_ptr<MeshContender> grid;
    double error = std::numeric_limits<double>::infinity(); ///< px
};

Candidate candidate(const SurfaceModel& model, const Box3& bounds, const RaySet& primary, int n) {
    const ContenderFacts facts{.kind = Kind::grid, .name = "grid per span"};
    Candidate made{
        n, std::make_unique<MeshContender>(span_grid(model, n, bounds.center()), bounds, facts)};
    made.error = zebra_error(*made.grid, primary, bounds);
    made.grid->describe(remark(n, made.error), made.error <= wanted);
    return made;
}

} // namespace

std::unique_ptr<Contender> fitted_grid(const SurfaceModel& model, const Box3& bounds,
                                       const RaySet& primary, std::size_t most_triangles) {
    Candidate best = candidate(model, bounds, primary, coarsest);
    const int finest = finest_span_grid(model, most_triangles);
    int too_coarse = 0;
    while (best.error > wanted) {
        const int n = std::min(finer(best.n, best.error), finest);
        if (n <= best.n) return std::move(best.grid);
        too_coarse = best.n;
        const double last_error = best.error;
        best = candidate(model, bounds, primary, n);
        // What does not fall any more comes from creases and borders, which no grid resolves.
        if (best.error > wanted && best.error > 0.9 * last_error) return std::move(best.grid);
    }
    // The step may have been too long: the peer shall have the coarsest grid that will do.
    while (too_coarse > 0 && best.n > close_enough * too_coarse) {
        const int n = static_cast<int>(std::lround(std::sqrt(best.n * too_coarse)));
        Candidate between = candidate(model, bounds, primary, n);
        if (between.error <= wanted)
            best = std::move(between);
        else
            too_coarse = n;
    }
    return std::move(best.grid);
}

} // namespace keiko::bench
