#pragma once

#include "keiko/geometry/model/primitive.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/math/affine.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/caustic_spec.h"
#include "keiko/scene/environment_spec.h"
#include "keiko/scene/material.h"
#include "keiko/scene/radiosity_spec.h"
#include "keiko/scene/volume_spec.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keiko {

/// Another paint for some faces of a model.
struct PaintOverride {
    std::vector<std::string> faces; ///< names, with * and ? as in file names
    Material material;              ///< of those faces
};

/// Placement of a model: scaled, then turned about an axis through the origin, then moved.
struct ModelTransform {
    double scale = 1;    ///< above 0
    Vec3 axis{0, 0, 1};  ///< of any length but 0
    double angle = 0;    ///< degrees, right-handed
    Vec3 translation{0}; ///< mm

    /// Map of the model's points to the scene, mm.
    Affine affine() const;
};

/// A model of a scene and how it is placed and painted.
struct ModelSpec {
    std::filesystem::path file;             ///< absolute, or relative to the working directory
    ModelTransform transform{};             ///< placement in the scene
    Material material{};                    ///< of the faces that no override names
    std::vector<PaintOverride> overrides{}; ///< later ones win
};

/// A primitive of a scene: a body, or a lamp if its material emits light.
struct PrimitiveSpec {
    PrimitiveShape shape; ///< in the scene's coordinates
    std::string name;     ///< of its faces
    Material material;    ///< of all of it
};

/// The floor that a scene stands on.
struct GroundSpec {
    double z = 0;      ///< mm
    Material material; ///< of the whole floor
};

/// Value of a number, or of three, of a scene at a frame.
struct KeyFrame {
    double frame = 0;          ///< number of the frame, which need not be whole
    std::vector<double> value; ///< one or three numbers, or the four of a rotation

    bool operator==(const KeyFrame&) const = default;
};

/// Motion of a part of a scene: between key frames in a straight line, before the first and after
/// the last not at all.
struct Animation {
    /// Its place in the scene, as its file names it, tables that repeat with their number from 0:
    /// "spotlight.0.aim".
    std::string target;
    std::vector<KeyFrame> keys; ///< rising, at least one

    /// The value at a frame.
    std::vector<double> at(double frame) const;

    bool operator==(const Animation&) const = default;
};

/// A scene file's content (keiko-scene/1), every path resolved.
struct SceneSpec {
    std::vector<ModelSpec> models;                ///< in the order of the file
    std::vector<PrimitiveSpec> primitives{};      ///< bodies, in the order of the file
    std::optional<Camera> camera;                 ///< nullopt: `view`, or neither
    std::optional<std::string> view;              ///< a named view instead of a camera
    int width = 960, height = 540;                ///< picture size, for named views
    std::optional<LightRig> rig;                  ///< none: to be placed
    std::optional<GroundSpec> ground;             ///< nullopt: no floor
    Rgb background{0};                            ///< cd/m2 where the camera ray meets nothing
    std::optional<int> max_depth;                 ///< mirror reflections followed along one ray
    std::optional<double> min_weight;             ///< reflections that count less end the path
    std::optional<EnvironmentSpec> environment{}; ///< surroundings at infinity
    std::optional<CausticSpec> caustics{};        ///< none: without
    std::optional<RadiositySpec> radiosity{};     ///< none: the defaults, if it is solved
    std::vector<VolumeSpec> volumes{};            ///< voxels, in the order of the file
    std::vector<Animation> animations{};          ///< without fault; see at_frame
};

} // namespace keiko
