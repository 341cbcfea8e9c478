#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/math/bounds.h"
#include "keiko/placement/best_view.h"
#include "keiko/placement/placement.h"
#include "keiko/scene/material.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A face as a viewer names it.
struct ViewedFace {
    std::uint32_t id = 0;       ///< as Face::id
    std::string name, layer;    ///< or empty
    std::uint32_t material = 0; ///< into ViewFacts::materials
    std::uint32_t part = 0;     ///< into ViewFacts::parts
};

/// Facts of a scene that a viewer needs beside its deep buffers.
struct ViewFacts {
    std::string tool_version;          ///< version of Keiko
    std::vector<std::string> inputs;   ///< names of the files, without their folders
    Camera camera;                     ///< of the view that was opened
    std::string view;                  ///< its name
    Box3 bounds;                       ///< of the body, world, mm
    std::optional<double> ground{};    ///< mm, its z
    Rgb background{0};                 ///< cd/m2 behind the body
    std::vector<ViewedFace> faces;     ///< of the body, in the order of the model
    std::vector<std::string> parts;    ///< names of the bodies of the model, or empty
    std::vector<Material> materials;   ///< each once
    std::uint32_t ground_material = 0; ///< into `materials`; with a ground alone
    int reflections = 3;               ///< followed along one ray, in pictures
    double min_weight = 1e-3;          ///< reflections of less weight than this end the path
    std::vector<NamedView> views;      ///< the standard ones, of the opened view's size
    std::vector<NamedView> own_views;  ///< of the report that was opened
    Diagnostics remarks;               ///< on files that are not those of the report
    bool against = false;              ///< an earlier revision is shown beside it
};

/// "keiko-view-facts/1" of docs/file-formats.md: the scene, and the rig as rig_json has it.
std::string view_json(const ViewFacts& facts, const LightRig& rig);

/// A rig in numbers, "keiko-view-rig/1" of docs/file-formats.md: rows of lamps, the number of other
/// lights, and what light there is besides.
std::string rig_json(const LightRig& rig);

/// Placed lamps, "keiko-view-placement/1" of docs/file-formats.md: coverage, remarks and rig.
std::string placed_rig_json(const Placement& placement);

} // namespace keiko
