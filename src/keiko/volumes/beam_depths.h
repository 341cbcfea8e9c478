#pragma once

#include "keiko/base/job.h"
#include "keiko/volumes/scene_volumes.h"
#include "keiko/volumes/volume.h"

#include <array>
#include <functional>
#include <vector>

namespace keiko {

/// Distance in mm from a place, in a unit direction, to the first surface, which stops light;
/// infinite if there is none. Empty: none ever stops it.
using StopOfLight = std::function<double(const Vec3& from, const Vec3& direction)>;

/// How deep the places of a volume lie in the volumes of its scene, as seen from a parallel light.
/// Depths are accumulated along lines of the light, from layer to layer of the volume's grid, and
/// are trilinear between the lines and the layers (docs/theory/volumes.md#clouds).
class BeamDepths {
public:
    /// Depth that no light counts beyond.
    static constexpr double darkness = 20;

    /// Accumulates the depths, at about `most` places or, where the light is aslant, up to four
    /// times as many. `towards`: unit, to where the light comes from. Throws Cancelled.
    BeamDepths(const SceneVolumes& scene, const Volume& volume, const Vec3& towards, double most,
               const StopOfLight& stops, const Job& job);

    /// Depths in a uniform medium of an extinction, 1/mm, that fills the box of the volume: exact.
    static BeamDepths uniform(const Volume& volume, const Vec3& towards, double extinction);

    /// Optical depth between a place of the volume's grid and the light, at most about `darkness`.
    double operator()(const Vec3& place) const;

private:
    BeamDepths() = default;
    /// Place of the volume's grid of a node.
    Vec3 node(int i, int j, int layer) const;
    double in_uniform(const Vec3& place) const;
    /// Depths of the layers of a line, from the one where light arrives.
    std::vector<double> along_line(const SceneVolumes& scene, const Volume& volume, int i, int j,
                                   const Vec3& towards, const StopOfLight& stops) const;

    std::array<unsigned, 3> axes_{};   ///< of the volume's grid: two across the layers, and along
    double slant_u_ = 0, slant_v_ = 0; ///< steps of the lines across, by one along
    double first_u_ = 0, first_v_ = 0; ///< steps across where the lines begin, at the layer 0
    Vec3 steps_{1};                    ///< of the volume's grid between nodes
    std::array<int, 3> nodes_{2, 2, 2};
    bool from_last_ = false;    ///< light arrives at the last layer
    std::vector<float> depths_; ///< by line, then by layer; empty: `uniform_`
    /// A uniform medium in a box.
    struct Uniform {
        double extinction = 0;
        Vec3 last{1}, way{0, 0, 1}; ///< steps: the last nodes; and of the light's way, by mm
    };
    Uniform uniform_{};
};

} // namespace keiko
