#pragma once

#include "keiko/maps/projection.h"
#include "keiko/maps/texture.h"
#include "keiko/math/affine.h"
#include "keiko/scene/material_map.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A place of a surface that maps are asked about, world, mm.
struct MapPlace {
    Vec3 position{0};
    Vec3 normal{0};              ///< unit, on the side of the viewer
    ProjectedPlace parameters{}; ///< of the face, 0 to 1 over it
    Vec3 dx{0}, dy{0};           ///< change of the position by the pixel's coordinates
    bool from_inside = false;    ///< the viewer is behind the face, where the body would be
};

/// Factors that maps give a material at a place.
struct MapValues {
    Rgb diffuse{1};       ///< of the reflectance of the base
    double roughness = 1; ///< of the width of the border's lobe
    Rgb gloss{1};         ///< 0 to 1, of what the border mirrors
    Rgb transmission{1};  ///< 0 to 1, of what passes glass
    Rgb emission{1};      ///< of the luminance that the material emits
};

/// The maps of a material, prepared.
class SurfaceMaps {
public:
    /// Reads the pictures of maps. Throws Error.
    explicit SurfaceMaps(std::span<const MaterialMap> maps);

    /// Factors at a place. Maps of one quantity multiply.
    MapValues values(const MapPlace& place) const;
    /// Sum of the heights at a place, mm, with derivatives; nullopt without such maps.
    std::optional<HeightJet> height(const MapPlace& place) const;
    /// Unit normal that normal maps make of that of the place, one after the other; nullopt without
    /// such maps.
    std::optional<Vec3> normal(const MapPlace& place) const;
    /// True if some map drives a quantity.
    bool drives(MappedQuantity quantity) const;

private:
    struct Prepared {
        MaterialMap map;
        Affine to_model; ///< of world places
        Texture texture;
    };
    static double share(const Prepared& prepared, const MapPlace& place);
    static Rgb factor(const Prepared& prepared, const MapPlace& place);

    std::vector<Prepared> maps_;
};

} // namespace keiko
