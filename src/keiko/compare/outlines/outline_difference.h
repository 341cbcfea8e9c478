#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/compare/outlines/film_difference.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/material.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// One of two bodies as its picture shows it. Faces that lie on each other in both bodies have one
/// name, which SharedFaces gives them.
struct OutlineBody {
    const Tracer& tracer;                   ///< of what is visible: the body, then the ground
    const ClosestPointQuery& feet;          ///< of the body alone
    std::span<const Material> paints;       ///< by Hit::face
    std::vector<std::size_t> visible_names; ///< by Hit::face
    std::vector<std::size_t> placed_names;  ///< by face of the PlacedModel
    std::optional<double> ground{};         ///< mm, z of the ground, where there is one
};

/// The distance of a place that one body shows to the faces of the same name of the other, mm;
/// infinity where none is within `reach` mm. A hit that bridges the gap of a seam is moved to the
/// border of its face first: the bridge is no material.
double distance_to_same(const OutlineBody& body, const Hit& hit, const OutlineBody& other,
                        double reach);

/// First hit of the camera ray through a place of a picture.
struct Sighting {
    Vec2 place{0};          ///< px
    std::optional<Hit> hit; ///< nullopt: the background
    std::size_t name = 0;   ///< of the face; only with a hit
};

/// The length that a pixel of a picture covers at a place, mm, square to the camera ray. In a
/// perspective picture it is that along the radius, where it is shortest.
double pixel_length(const Camera& camera, const Vec3& place);

/// Finds outlines of a body in a picture: where what is visible changes to another face, to the
/// background or to another sheet of the same face. So borders, seams between faces of different
/// names and contours are outlines; lines inside a face are not.
class OutlineFinder {
public:
    /// Finder for one body; keeps a reference to it.
    OutlineFinder(const OutlineBody& body, const Camera& camera);

    /// One sighting a place, in order.
    std::vector<Sighting> look(std::span<const Vec2> places) const;
    /// The hits on both sides of every outline that runs between two neighbours of a square grid
    /// of sightings, `side` of them in a row: within a two thousandth of their spacing of it.
    std::vector<Hit> outlines(std::span<const Sighting> grid, std::size_t side) const;

private:
    struct Crossing {
        Sighting a, b;
    };
    bool differ(const Sighting& a, const Sighting& b) const;
    std::vector<Crossing> crossings(std::span<const Sighting> grid, std::size_t side) const;
    /// The halves in which the outlines run; what turns out to be smooth is left out.
    std::vector<Crossing> halved(std::vector<Crossing> crossings) const;
    double facing(const Hit& hit) const;

    const OutlineBody& body_;
    Camera camera_;
    PreparedCamera prepared_;
};

/// Tolerances within which two pictures are the same.
struct OutlineTolerance {
    double distance = 0.01; ///< mm on the part that an outline may move, or
    double pixels = 0.05;   ///< of the picture, whichever is more
    double surface = 5e-4;  ///< mm between two surfaces, along their normals
    double normal = 0.01;   ///< degrees between their normals
};

/// How far an outline of one body lies from the other body.
struct OutlineShift {
    double distance = 0; ///< mm from a place of the outline to the same faces of the other body
    double pixels = 0;   ///< the most that is in the picture
    double excess = 0;   ///< the distance over what is allowed there
    Vec3 place{0};       ///< world, mm

    /// True if it has moved by no more than the tolerance.
    bool within() const { return excess <= 1; }
};

/// Outlines of two bodies in a pixel.
struct PixelOutline {
    bool found = false;   ///< one of them has an outline there
    bool alike = false;   ///< both show the same surface in the same paint all over
    OutlineShift worst{}; ///< by excess
};

/// Measures how far the outlines of two bodies lie apart in a picture, on the bodies themselves:
/// docs/decisions/0017-outlines-of-revisions.md. Immutable; any thread may ask.
class OutlineComparison {
public:
    /// Distances are sought up to `reach` mm. Keeps references to the bodies.
    OutlineComparison(const OutlineBody& before, const OutlineBody& after, const Camera& camera,
                      const OutlineTolerance& tolerance, double reach);

    /// The worst of the outlines in a pixel and of what the bodies show otherwise there. Rays go
    /// through a grid of 5 x 5 places, of 17 x 17 if `finely`, and close in on outlines between
    /// them. A pixel whose centre is beyond what is allowed is searched no further.
    PixelOutline in_pixel(int x, int y, bool finely = false) const;

private:
    bool alike(const Sighting& before, const Sighting& after) const;
    /// Takes over what a body shows at a place if that is worse.
    void measure(const OutlineBody& body, const Hit& hit, const OutlineBody& other,
                 OutlineShift& worst) const;
    void measure_both(const Sighting& before, const Sighting& after, OutlineShift& worst) const;
    double allowed(const Vec3& place) const;

    const OutlineBody &before_, &after_;
    Camera camera_;
    OutlineFinder finder_before_, finder_after_;
    OutlineTolerance tolerance_;
    double reach_;
};

/// Part of the bodies themselves in the difference of two pictures of them.
struct OutlineDifference {
    std::size_t excused = 0; ///< pixels that differ, whose outlines moved within the tolerance
    std::size_t moved = 0;   ///< pixels whose outlines moved farther, or that show something else
    std::size_t alike = 0;   ///< pixels that differ, in which both show the same surface and paint
    OutlineShift worst{};    ///< of the excused and the moved ones, by excess
    int x = 0, y = 0;        ///< pixel of the worst, the first of equals
    Image left_out{};        ///< 1 channel: 1 in the excused and the alike pixels

    /// True if no outline has moved.
    bool within() const { return moved == 0; }
};

/// Inspects every pixel in which two pictures are found to differ: silhouette flips, and pixels
/// beyond the tolerance of a layer. Where the bodies have no outline and show the same, the
/// pictures differ by how they are rendered, or by what is mirrored, which is compared where it is.
/// The same for any number of threads. Reports stage "outlines". Throws Cancelled.
OutlineDifference outline_difference(const OutlineComparison& outlines, const Film& before,
                                     const Film& after, const FilmDifference& difference,
                                     const Camera& camera, const Job& job = {});

} // namespace keiko
