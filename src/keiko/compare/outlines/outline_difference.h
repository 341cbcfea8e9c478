#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/compare/outlines/film_difference.h"
#include "keiko/compare/outlines/outline_finder.h"

namespace KEIKO_API keiko {

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
