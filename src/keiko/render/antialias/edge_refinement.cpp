#include "keiko/render/antialias/edge_refinement.h"

#include "keiko/render/antialias/edge_detection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace keiko {
namespace {

class Refinement {
public:
    Refinement(const Integrator& integrator, const PreparedCamera& camera, double finest)
        : integrator_(integrator), camera_(camera), probes_(integrator, camera), finest_(finest) {}

    RefinedPixels run(std::vector<EdgeCell> cells) {
        while (!cells.empty()) {
            next_.clear();
            pass(cells);
            cells = std::move(next_);
        }
        shade_strips();
        return parts_.finish(probes_.paths());
    }

private:
    /// True for the finest cells, which stay whole regardless of their corners.
    bool is_finest(const EdgeCell& cell) const {
        return !(std::max(cell.size.x, cell.size.y) > finest_);
    }

    void pass(std::span<const EdgeCell> cells) {
        std::vector<SeenCell> whole, crossed;
        for (SeenCell& seen : looked_at(cells)) {
            const bool is_whole = is_finest(seen.cell) || is_plain(seen);
            (is_whole ? whole : crossed).push_back(std::move(seen));
        }
        std::vector<ClippedCell> cuts = straight_ones(cuts_of(std::move(crossed), whole));
        shade(whole, cuts);
    }

    /// True if no edge that could be visible runs through a cell.
    static bool is_plain(const SeenCell& seen) {
        const bool alike = seen.looks_like(*seen.corners[0]) &&
                           (!seen.cell.centre || seen.looks_like(*seen.cell.centre));
        return alike || seen.crossed_sides.empty();
    }

    /// Cells with the samples at the corners of those that are not the finest.
    std::vector<SeenCell> looked_at(std::span<const EdgeCell> cells) {
        std::vector<Vec2> places;
        places.reserve(4 * cells.size());
        for (const EdgeCell& cell : cells)
            if (!is_finest(cell))
                for (const Vec2& corner : cell.corners()) places.push_back(corner);
        const std::vector<const PixelSample*> samples = probes_.shared_at(places);
        std::vector<SeenCell> seen;
        seen.reserve(cells.size());
        std::span<const PixelSample* const> left = samples;
        for (const EdgeCell& cell : cells) {
            if (is_finest(cell)) {
                seen.emplace_back(cell);
                continue;
            }
            seen.emplace_back(cell, left.first<4>());
            left = left.subspan(4);
        }
        return seen;
    }

    void divide(const SeenCell& seen) {
        for (const EdgeCell& half : seen.cell.halves(seen.most_varied_axis(finest_)))
            next_.push_back(half);
    }

    /// Divides a cell at its centre, so that a thing at the centre alone, such as a tip, is at a
    /// corner of all parts.
    void divide_at_centre(const EdgeCell& cell) {
        for (const EdgeCell& half : cell.halves(0))
            for (const EdgeCell& quarter : half.halves(1)) next_.push_back(quarter);
    }

    /// Cells that one edge crosses, cut; the others are divided, or whole if they are only bent.
    std::vector<ClippedCell> cuts_of(std::vector<SeenCell> cells, std::vector<SeenCell>& whole) {
        const std::vector<EdgeCrossing> all = outline_crossings(probes_, cells);
        std::vector<ClippedCell> cuts;
        cuts.reserve(cells.size());
        auto begin = all.begin();
        for (SeenCell& seen : cells) {
            const auto end = begin + static_cast<std::ptrdiff_t>(seen.crossed_sides.size());
            const bool tangled = std::any_of(begin, end, [](const EdgeCrossing& side) {
                return side.state == EdgeCrossing::State::tangled;
            });
            InplaceVector<EdgeCrossing, 4> sharp;
            std::copy_if(begin, end, std::back_inserter(sharp), [](const EdgeCrossing& side) {
                return side.state == EdgeCrossing::State::crossed;
            });
            begin = end;
            if (!tangled && sharp.empty())
                whole.push_back(std::move(seen));
            else if (!tangled && sharp.size() == 2)
                cuts.emplace_back(seen, sharp[0], sharp[1]);
            else
                divide(seen);
        }
        return cuts;
    }

    std::vector<ClippedCell> straight_ones(std::vector<ClippedCell> cuts) {
        std::vector<Vec2> places;
        places.reserve(2 * cuts.size());
        for (const ClippedCell& cut : cuts)
            for (const CutPart& part : cut.parts) places.push_back(part.beside_cut);
        const std::vector<const PixelSample*> seen = probes_.at(places);
        std::vector<ClippedCell> found;
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const auto& [first, second] = cuts[i].parts;
            if (cuts[i].holds_centre() && first.seen.shows(*seen[2 * i]) &&
                second.seen.shows(*seen[2 * i + 1]))
                found.push_back(std::move(cuts[i]));
            else
                divide(cuts[i].seen);
        }
        return found;
    }

    /// Traces the rays of the parts, and keeps the parts whose samples are as expected.
    void shade(std::span<const SeenCell> whole, std::span<const ClippedCell> cuts) {
        Rays rays;
        rays.reserve(whole.size() + 2 * cuts.size());
        for (const SeenCell& seen : whole)
            if (!seen.cell.centre)
                rays.push_back(ray_of(camera_, rectangle_part(seen.cell.corner, seen.cell.size)));
        for (const ClippedCell& cut : cuts)
            for (const CutPart& part : cut.parts)
                rays.push_back(ray_of(camera_, part.seen.whole()));
        parts_.open(integrator_.view(std::move(rays)));
        std::size_t sample = 0;
        for (const SeenCell& seen : whole) keep_whole(seen, sample);
        for (const ClippedCell& cut : cuts) {
            keep_cut(cut, sample);
            sample += 2;
        }
        parts_.close();
    }

    void keep_whole(const SeenCell& seen, std::size_t& sample) {
        const EdgeCell& cell = seen.cell;
        const PixelSample& centre = cell.centre ? *cell.centre : parts_.seen(sample);
        if (is_finest(cell) || seen.looks_like(centre) || is_told(seen, centre)) {
            if (!cell.centre) parts_.keep(sample, cell.pixel, cell.area());
        }
        if (!cell.centre) ++sample;
    }

    /// True if the centre represents all of a cell; otherwise the cell is divided.
    bool is_told(const SeenCell& seen, const PixelSample& centre) {
        const SampledPolygon part = seen.part();
        if (!part.shows(centre)) {
            divide_at_centre(seen.cell);
            return false;
        }
        const double uneven = part.unevenness(centre);
        if (!(uneven > 1)) return true;
        if (!add_strips(seen.cell.pixel, part, centre, uneven)) divide(seen);
        return false;
    }

    void keep_cut(const ClippedCell& cut, std::size_t sample) {
        for (std::size_t i = 0; i < 2; ++i)
            if (!cut.parts[i].seen.shows(parts_.seen(sample + i))) return divide(cut.seen);
        const std::size_t pixel = cut.seen.cell.pixel;
        for (std::size_t i = 0; i < 2; ++i) {
            const SampledPolygon& part = cut.parts[i].seen;
            const PixelSample& amid = parts_.seen(sample + i);
            const double uneven = part.unevenness(amid);
            if (!(uneven > 1) || !add_strips(pixel, part, amid, uneven))
                parts_.keep(sample + i, pixel, part.whole().area);
        }
    }

    /// Adds the strips of a part; false if there are none.
    bool add_strips(std::size_t pixel, const SampledPolygon& part, const PixelSample& amid,
                    double uneven) {
        const double narrowest = finest_ / 1.5; // one replaces several cells
        const std::vector<PixelArea> strips = part.strips(amid, uneven, narrowest);
        for (const PixelArea& strip : strips) strips_.push_back({pixel, strip});
        return !strips.empty();
    }

    void shade_strips() {
        Rays rays;
        rays.reserve(strips_.size());
        for (const Strip& strip : strips_) rays.push_back(ray_of(camera_, strip.part));
        parts_.open(integrator_.view(std::move(rays)));
        for (std::size_t i = 0; i < strips_.size(); ++i)
            parts_.keep(i, strips_[i].pixel, strips_[i].part.area);
        parts_.close();
        strips_.clear();
    }

    /// A part of a pixel whose ray is not traced yet.
    struct Strip {
        std::size_t pixel;
        PixelArea part;
    };

    const Integrator& integrator_;
    const PreparedCamera& camera_;
    EdgeSamples probes_;
    double finest_; ///< px
    std::vector<EdgeCell> next_;
    std::vector<Strip> strips_;
    Subpixels parts_;
};

} // namespace

RefinedPixels refined_pixels(const Integrator& integrator, const PreparedCamera& camera,
                             std::vector<EdgeCell> pixels, double finest) {
    return Refinement(integrator, camera, finest).run(std::move(pixels));
}

} // namespace keiko
