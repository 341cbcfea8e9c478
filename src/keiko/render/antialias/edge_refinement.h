#pragma once

#include "keiko/base/memory.h"
#include "keiko/render/antialias/subpixels.h"
#include "keiko/render/reflection/sample_batch.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/scene/camera.h"

#include <array>
#include <memory_resource>
#include <span>
#include <unordered_map>
#include <vector>

namespace keiko {

/// Unit direction in the picture along which the reflection in a convex part of it is bent most; 0
/// if the normal does not turn. Along it the normal turns least uniformly, by the normal and its
/// slopes at the part's corners and in its middle. All samples have hits with second derivatives.
/// `corners`: px.
Vec2 max_curvature_direction(std::span<const Vec2> corners,
                             std::span<const PixelSample* const> seen, const PixelSample& amid);

/// A convex part of the picture with the samples at its corners.
struct SampledPolygon {
    static constexpr std::size_t most_corners = 6; ///< a cell's four and two crossings

    InplaceVector<Vec2, most_corners> corners;            ///< px, of either sense
    InplaceVector<const PixelSample*, most_corners> seen; ///< one a corner, in order

    /// The polygon as the area of one camera ray.
    PixelArea whole() const { return polygon_part(corners); }
    /// True if a sample in the middle shows the same smooth thing as one of the corners.
    bool shows(const PixelSample& amid) const;
    /// Nonlinearity of the polygon: up to 1 the place in its middle represents all of it with a
    /// straight image on the lamps' plane. The image may be bent, or reach the plane's horizon. The
    /// surface may be visible at angles so different that the reflectance is not uniform, or show
    /// in the middle what no corner does. n strips divide it by n^2.
    double unevenness(const PixelSample& amid) const;
    /// Strips of one width along which the image is bent least. There are as many as make each
    /// nearly linear, and at least two. They are not divided beyond a width of `narrowest`, px.
    /// Empty if no surface is visible, or one that does not turn.
    std::vector<PixelArea> strips(const PixelSample& amid, double uneven, double narrowest) const;

private:
    /// True if it is brighter or darker than all corners: its sample shows something that theirs do
    /// not.
    bool is_outshone_by(const PixelSample& amid) const;
    // Shares of the limits for a whole pixel: the difference of cosines and the turn of normals,
    // the bend of the image on the lamps' plane, and the deviation of luminances from linear ones.
    double turn(const PixelSample& amid) const;
    double bend(const PixelSample& amid) const;
    double glare(const PixelSample& amid) const;
};

/// A side of a cell whose ends show different things, narrowed from both ends.
struct EdgeCrossing {
    std::size_t side = 0;              ///< of the cell, 0 to 3
    Vec2 a{0}, b{0};                   ///< ends of what is left of the side, px
    const PixelSample* at_a = nullptr; ///< sample at a
    const PixelSample* at_b = nullptr; ///< sample at b
    /// State of the search for an edge on the side.
    enum class State {
        crossed,              ///< by one edge
        bent,                 ///< by none: the normal turns fast
        tangled               ///< by several
    } state = State::crossed; ///< as long as no sample in the middle says otherwise

    /// Middle of what is left of the side, px.
    Vec2 middle() const { return (a + b) / 2; }
    /// Length of what is left of the side, px.
    double length() const { return (b - a).length(); }
    /// Copy of the crossing, from the end with the lower coordinates to the other.
    EdgeCrossing upright() const;
    /// Copies the result for the upright line; `side` and the sense stay as they are.
    void take(const EdgeCrossing& upright);
    /// Halves the side; `seen` is the sample in its middle. The half is kept whose ends differ. If
    /// the middle is like both ends the side becomes bent, if it is like neither tangled.
    void halve(const PixelSample& seen);
};

/// A rectangular cell of a pixel that may contain an edge, px.
struct EdgeCell {
    std::size_t pixel = 0;               ///< number of its pixel
    Vec2 corner{0};                      ///< the upper left
    Vec2 size{1};                        ///< width and height
    const PixelSample* centre = nullptr; ///< if known

    /// Corners, around it.
    std::array<Vec2, 4> corners() const {
        return {corner, corner + Vec2(size.x, 0), corner + size, corner + Vec2(0, size.y)};
    }
    /// Area, px2.
    double area() const { return size.x * size.y; }
    /// Its parts on both sides of the middle of its width, `axis` 0, or of its height, 1.
    std::array<EdgeCell, 2> halves(unsigned axis) const;
};

/// A cell with the samples at its corners, around it.
struct SeenCell {
    EdgeCell cell;                               ///< the cell itself
    std::array<const PixelSample*, 4> corners{}; ///< null for a cell whose corners are not sampled
    /// The sides, i between the corners i and i + 1, whose ends show different things.
    InplaceVector<std::size_t, 4> crossed_sides{};

    /// Cell without samples at its corners, and without crossed sides.
    explicit SeenCell(const EdgeCell& unseen) : cell(unseen) {}
    /// Cell with the samples at its corners; a side is crossed if its ends differ_closely().
    SeenCell(const EdgeCell& seen, std::span<const PixelSample* const, 4> around);

    /// Side i, from corner i to the next one, not narrowed yet.
    EdgeCrossing side(std::size_t i) const;
    /// True if all corners equal a sample, to 1 % of a pixel, on a surface that does not turn:
    /// lamps fit into the turn of one that does.
    bool looks_like(const PixelSample& sample) const;
    /// The cell as a polygon with the samples at its corners.
    SampledPolygon part() const;
    /// Axis with the larger variation along the sides that are longer than `finest`, px: the width,
    /// 0, or the height, 1. Of equal ones it is the longer.
    unsigned most_varied_axis(double finest) const;
};

/// Part of a cell on one side of an edge.
struct CutPart {
    SampledPolygon seen; ///< the part, with samples of the cell's corners and the crossings' ends
    Vec2 beside_cut{0};  ///< a place in it by the middle of the cut, px
};

/// A cell that one edge cuts along a straight line.
struct ClippedCell {
    SeenCell seen;                ///< the cell as it was
    std::array<CutPart, 2> parts; ///< from the first crossing to the second, and back to the first

    /// Cell with its crossings by rising side.
    ClippedCell(const SeenCell& cell, const EdgeCrossing& first, const EdgeCrossing& second);

    /// True if the centre, if known, shows the same as its part.
    bool holds_centre() const;
};

/// Single camera rays through places of the picture, px, that sample the visible surface; their
/// samples are kept.
class EdgeSamples {
public:
    /// No samples yet; keeps references to both.
    EdgeSamples(const Integrator& integrator, const PreparedCamera& camera)
        : integrator_(integrator), camera_(camera) {}

    /// One sample a place, in order.
    std::vector<const PixelSample*> at(std::span<const Vec2> places);
    /// One sample a place, in order; places that were requested before get no ray again.
    std::vector<const PixelSample*> shared_at(std::span<const Vec2> places);

    /// Statistics of the hits of all rays traced so far.
    HitStatistics paths() const;

private:
    const Integrator& integrator_;
    const PreparedCamera& camera_;
    std::vector<SampleBatch> views_;
    struct PlaceHash {
        std::size_t operator()(const Vec2& place) const;
    };
    std::pmr::monotonic_buffer_resource memory_; ///< of the samples: none is discarded
    std::pmr::unordered_map<Vec2, const PixelSample*, PlaceHash> known_{&memory_};
};

/// The sides that edges cross of each cell in turn, halved until the place is accurate to a
/// sixty-fourth of a pixel or no edge is found there. Neighbouring cells share the result.
std::vector<EdgeCrossing> outline_crossings(EdgeSamples& probes, std::span<const SeenCell> cells);

/// Divides `pixels`, adaptively. Cells whose corners and centre see one smooth thing stay whole;
/// those that one straight edge crosses are split along it, where it is found by halving. Others
/// are halved across the largest variation, down to sides of `finest`, px. They are quartered if
/// their centre alone shows something, which may halve a side of `finest` once more. Cells of one
/// surface whose image on the lamps' plane is bent are cut into strips. Pixels that turn out to be
/// whole and have a `centre` are left out of the result.
RefinedPixels refined_pixels(const Integrator& integrator, const PreparedCamera& camera,
                             std::vector<EdgeCell> pixels, double finest);

} // namespace keiko
