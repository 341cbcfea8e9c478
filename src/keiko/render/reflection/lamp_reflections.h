#pragma once

#include "keiko/render/reflection/lamp_kernels.h"
#include "keiko/render/reflection/pixel_mirror.h"
#include "keiko/render/reflection/reflected_grid.h"

#include <vector>

namespace keiko {

/// Lamps visible in the pixels of a grid by mirror_of(), to within rounding, for neighbours side by
/// side. It does not state whether stripes were too fine, MirroredLight::resolved. Places are best
/// requested in their order.
class LampReflections {
public:
    /// Keeps references to all; the grid's rays are set and joined. `tells_torn` as in mirror_of().
    LampReflections(const RigPlanes& planes, const ReflectedGrid& grid, const LampKernels& kernels,
                    bool tells_torn);

    /// Finds the lamps that the place's reflected ray meets up to `t_max`; stored in `mirror`,
    /// which is blank.
    void find(std::size_t place, double t_max, PixelMirror& mirror);

private:
    /// One pixel among those of the batch.
    struct Pixel {
        std::size_t place, lane;
        double t_max;
    };
    PixelMirror plainly(const Pixel& pixel) const;
    void look(std::size_t place);
    bool is_dark(std::size_t lane) const;
    /// The number of the nearest plane; the number of planes if none is met.
    std::size_t nearest(std::size_t lane) const;
    void set_hit(std::size_t number, const Pixel& pixel, RigPlaneHit& hit) const;
    /// Finds the lamps of a pixel of `parts` parts a side; false if several rows are visible or a
    /// footprint is a point.
    bool find_lamps(const Pixel& pixel, int parts, MirroredLight& light) const;

    const RigPlanes& planes_;
    const ReflectedGrid& grid_;
    const LampKernels& kernels_;
    bool tells_torn_, is_plain_;           ///< plain: rows of a kind that the kernels do not
                                           ///< support
    std::size_t first_;                    ///< of the pixels of the batch
    std::vector<LampCoverageBatch> looks_; ///< one a plane
};

} // namespace keiko
