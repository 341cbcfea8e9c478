#pragma once

#include "keiko/api/scene.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace keiko::python {

/// An open scene, and what opens it again in another process.
struct OpenScene {
    std::vector<std::filesystem::path> paths;
    std::string unit, axes, material;
    bool shadows = false;
    std::shared_ptr<const Scene> scene;
};

} // namespace keiko::python
