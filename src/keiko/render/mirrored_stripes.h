#pragma once

#include "keiko/render/mirrored_grid.h"
#include "keiko/render/stripe_kernels.h"

#include <vector>

namespace keiko {

/// What the pixels of a grid see of the lamps: mirror_of(), to within rounding, of neighbours side
/// by side. Places are best asked for in their order.
class MirroredStripes {
public:
    /// All are only looked at; the grid's rays are set and joined. `tells_torn` as in mirror_of().
    MirroredStripes(const RigPlanes& planes, const MirroredGrid& grid, const StripeKernels& kernels,
                    bool tells_torn);

    /// Of the place with the mirrored ray `centre`.
    PixelMirror at(std::size_t place, const Ray& centre, double t_max);

private:
    /// One pixel among those looked at.
    struct Pixel {
        std::size_t place, lane;
        const Ray& centre;
        double t_max;
    };
    PixelMirror plainly(const Pixel& pixel) const;
    void look(std::size_t place);
    bool is_dark(std::size_t lane) const;
    std::optional<std::size_t> nearest(std::size_t lane) const;
    RigPlaneHit hit_on(std::size_t number, const Pixel& pixel) const;
    /// Nothing where several rows show or a footprint is a point.
    std::optional<MirroredLight> lamps(const Pixel& pixel, int parts) const;

    const RigPlanes& planes_;
    const MirroredGrid& grid_;
    const StripeKernels& kernels_;
    bool tells_torn_, is_plain_;     ///< plain: rows of a kind that the kernels do not know
    std::size_t first_;              ///< of the pixels looked at
    std::vector<StripeLooks> looks_; ///< one a plane
};

} // namespace keiko
