#include "keiko/render/outline_refinement.h"

#include "keiko/render/cut_cell.h"
#include "keiko/render/outlines.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>

namespace keiko {
namespace {

/// How often the side of a pixel is halved to find where an outline crosses it.
constexpr int halvings = 5;

/// Halves sides again and again until the places of the outlines on them are known.
void close_in(EyeProbes& probes, std::span<CrossedSide> sides, int steps) {
    const auto crossed = [](const CrossedSide& side) {
        return side.state == CrossedSide::State::crossed;
    };
    for (int step = 0; step < steps; ++step) {
        std::vector<Vec2> middles;
        for (const CrossedSide& side : sides)
            if (crossed(side)) middles.push_back(side.middle());
        const std::vector<const EyeSample*> seen = probes.at(middles);
        auto next = seen.begin();
        for (CrossedSide& side : sides)
            if (crossed(side)) side.halve(**next++);
    }
}

class Refinement {
public:
    Refinement(const Integrator& integrator, const PreparedCamera& camera, int finest)
        : integrator_(integrator), camera_(camera), probes_(integrator, camera), finest_(finest) {}

    RefinedPixels run(std::vector<OutlineCell> cells) {
        while (!cells.empty()) {
            next_.clear();
            pass(cells);
            cells = std::move(next_);
        }
        finish();
        return std::move(result_);
    }

private:
    /// All cells are of one depth; the finest stay whole whatever is at their corners.
    void pass(std::span<const OutlineCell> cells) {
        std::vector<SeenCell> whole, crossed;
        if (cells[0].depth == finest_) {
            for (const OutlineCell& cell : cells) whole.push_back({cell});
            return shade(whole, {});
        }
        for (SeenCell& seen : looked_at(cells)) {
            const bool plain = seen.looks_like(*seen.corners[0]) &&
                               (!seen.cell.centre || seen.looks_like(*seen.cell.centre));
            (plain || seen.crossed_sides().empty() ? whole : crossed).push_back(std::move(seen));
        }
        std::vector<CutCell> cuts = straight_ones(cuts_of(std::move(crossed), whole));
        shade(whole, cuts);
    }

    std::vector<SeenCell> looked_at(std::span<const OutlineCell> cells) {
        std::vector<Vec2> places;
        for (const OutlineCell& cell : cells)
            for (const Vec2& corner : cell.corners()) places.push_back(corner);
        const std::vector<const EyeSample*> samples = probes_.shared_at(places);
        std::vector<SeenCell> seen;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            seen.push_back({cells[i]});
            std::copy_n(&samples[4 * i], 4, seen.back().corners.begin());
        }
        return seen;
    }

    void divide(const OutlineCell& cell) {
        for (const OutlineCell& quarter : cell.quarters()) next_.push_back(quarter);
    }

    /// The crossed sides of each cell in turn; cells side by side share what is found.
    std::vector<CrossedSide> crossings_of(std::span<const SeenCell> cells) {
        std::vector<CrossedSide> sides, found;
        std::map<std::array<double, 4>, std::size_t> known;
        std::vector<std::size_t> places;
        for (const SeenCell& seen : cells)
            for (const std::size_t i : seen.crossed_sides()) {
                sides.push_back(seen.side(i));
                const CrossedSide upright = sides.back().upright();
                const std::array key{upright.a.x, upright.a.y, upright.b.x, upright.b.y};
                const auto [place, is_new] = known.emplace(key, found.size());
                places.push_back(place->second);
                if (is_new) found.push_back(upright);
            }
        if (!cells.empty()) close_in(probes_, found, halvings - cells[0].cell.depth);
        for (std::size_t i = 0; i < sides.size(); ++i) sides[i].take(found[places[i]]);
        return sides;
    }

    /// Those of the cells that one outline crosses; the others are divided, or whole if they are
    /// only bent.
    std::vector<CutCell> cuts_of(std::vector<SeenCell> cells, std::vector<SeenCell>& whole) {
        const std::vector<CrossedSide> all = crossings_of(cells);
        std::vector<CutCell> cuts;
        auto begin = all.begin();
        for (SeenCell& seen : cells) {
            const auto end = begin + static_cast<std::ptrdiff_t>(seen.crossed_sides().size());
            const bool tangled = std::any_of(begin, end, [](const CrossedSide& side) {
                return side.state == CrossedSide::State::tangled;
            });
            std::vector<CrossedSide> sharp;
            std::copy_if(begin, end, std::back_inserter(sharp), [](const CrossedSide& side) {
                return side.state == CrossedSide::State::crossed;
            });
            begin = end;
            if (!tangled && sharp.empty())
                whole.push_back(std::move(seen));
            else if (!tangled && sharp.size() == 2)
                cuts.emplace_back(seen, sharp[0], sharp[1]);
            else
                divide(seen.cell);
        }
        return cuts;
    }

    std::vector<CutCell> straight_ones(std::vector<CutCell> cuts) {
        std::vector<Vec2> places;
        for (const CutCell& cut : cuts)
            for (const CutPart& part : cut.parts) places.push_back(part.beside_cut);
        const std::vector<const EyeSample*> seen = probes_.at(places);
        std::vector<CutCell> found;
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const auto& [first, second] = cuts[i].parts;
            if (cuts[i].holds_centre() && first.shows(*seen[2 * i]) &&
                second.shows(*seen[2 * i + 1]))
                found.push_back(std::move(cuts[i]));
            else
                divide(cuts[i].seen.cell);
        }
        return found;
    }

    /// Sends the rays that the parts are seen by, and keeps the parts that show what they should.
    void shade(std::span<SeenCell> whole, std::span<CutCell> cuts) {
        std::vector<Ray> rays;
        for (const SeenCell& seen : whole)
            if (!seen.cell.centre)
                rays.push_back(ray_of(camera_, square_part(seen.cell.corner, seen.cell.side)));
        for (const CutCell& cut : cuts)
            for (const CutPart& part : cut.parts) rays.push_back(ray_of(camera_, part.part));
        EyeView view = integrator_.view(rays);
        kept_.assign(view.samples.size(), {});
        std::size_t sample = 0;
        for (SeenCell& seen : whole) keep_whole(seen, view, sample);
        for (CutCell& cut : cuts) {
            keep_cut(cut, view, sample);
            sample += 2;
        }
        keep_spots(view);
        for (const EyeSample& seen : view.samples) result_.paths += seen.paths;
        result_.views.push_back(std::move(view));
    }

    void keep_whole(SeenCell& seen, const EyeView& view, std::size_t& sample) {
        const OutlineCell& cell = seen.cell;
        const bool known = cell.centre != nullptr;
        const EyeSample& centre = known ? *cell.centre : view.samples[sample];
        const bool told = cell.depth == finest_ || seen.is_told_by(centre);
        if (!told)
            divide(cell);
        else if (!known)
            keep(sample, cell.pixel, cell.side * cell.side, centre);
        if (!known) ++sample;
    }

    void keep_cut(CutCell& cut, const EyeView& view, std::size_t sample) {
        const OutlineCell& cell = cut.seen.cell;
        bool agrees = true;
        for (std::size_t i = 0; i < 2; ++i)
            agrees = agrees && cut.parts[i].is_told_by(view.samples[sample + i], cell.side);
        if (!agrees) return divide(cell);
        for (std::size_t i = 0; i < 2; ++i)
            keep(sample + i, cell.pixel, cut.parts[i].part.area, view.samples[sample + i]);
    }

    void keep(std::size_t sample, std::size_t pixel, double share, const EyeSample& seen) {
        kept_[sample] = result_.parts.size();
        result_.parts.push_back({pixel, share, seen});
    }

    void keep_spots(const EyeView& view) {
        for (LitSpot spot : view.spots)
            if (const auto part = kept_[spot.sample]) {
                spot.sample = *part;
                result_.spots.push_back(spot);
            }
    }

    void finish() {
        std::vector<std::size_t> order(result_.parts.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return result_.parts[a].pixel < result_.parts[b].pixel;
        });
        std::vector<PixelPart> parts;
        std::vector<std::size_t> place(order.size());
        for (const std::size_t i : order) {
            place[i] = parts.size();
            parts.push_back(result_.parts[i]);
        }
        result_.parts = std::move(parts);
        for (LitSpot& spot : result_.spots) spot.sample = place[spot.sample];
        result_.paths += probes_.paths();
    }

    const Integrator& integrator_;
    const PreparedCamera& camera_;
    EyeProbes probes_;
    int finest_;
    std::vector<OutlineCell> next_;
    std::vector<std::optional<std::size_t>> kept_; ///< parts of the samples of a view
    RefinedPixels result_;
};

} // namespace

RefinedPixels refined_pixels(const Integrator& integrator, const PreparedCamera& camera,
                             std::vector<OutlineCell> pixels, int finest) {
    return Refinement(integrator, camera, finest).run(std::move(pixels));
}

} // namespace keiko
