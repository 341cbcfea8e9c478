#pragma once

#include "keiko/base/export.h"
#include "keiko/compare/alignment/closest_point_query.h"
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

} // namespace keiko
