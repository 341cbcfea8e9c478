#pragma once

#include "keiko/render/reflection/lamp_kernels.h"
#include "keiko/render/reflection/reflected_grid.h"

#include <vector>

namespace keiko {

/// What the pixels of a grid see of the lamps: mirror_of(), to within rounding, of neighbours side
/// by side; whether stripes were too fine, MirroredLight::resolved, is not told. Places are best
/// asked for in their order.
class LampReflections {
public:
    /// All are only looked at; the grid's rays are set and joined. `tells_torn` as in mirror_of().
    LampReflections(const RigPlanes& planes, const ReflectedGrid& grid, const LampKernels& kernels,
                    bool tells_torn);

    /// Of the place's reflected ray up to `t_max`; put into `mirror`, which is blank.
    void find(std::size_t place, double t_max, PixelMirror& mirror);

private:
    /// One pixel among those looked at.
    struct Pixel {
        std::size_t place, lane;
        double t_max;
    };
    PixelMirror plainly(const Pixel& pixel) const;
    void look(std::size_t place);
    bool is_dark(std::size_t lane) const;
    /// The number of the nearest plane; how many there are if none is met.
    std::size_t nearest(std::size_t lane) const;
    void set_hit(std::size_t number, const Pixel& pixel, RigPlaneHit& hit) const;
    /// Of so many parts a side; false where several rows show or a footprint is a point.
    bool find_lamps(const Pixel& pixel, int parts, MirroredLight& light) const;

    const RigPlanes& planes_;
    const ReflectedGrid& grid_;
    const LampKernels& kernels_;
    bool tells_torn_, is_plain_;           ///< plain: rows of a kind that the kernels do not know
    std::size_t first_;                    ///< of the pixels looked at
    std::vector<LampCoverageBatch> looks_; ///< one a plane
};

} // namespace keiko
