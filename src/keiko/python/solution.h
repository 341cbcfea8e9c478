#pragma once

#include "keiko/api/light.h"
#include "keiko/python/module.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace keiko::python {

/// Reflected light that has been solved or read.
struct OpenSolution {
    std::shared_ptr<const RadiositySolution> solution; ///< never null
    std::string source;                                ///< its file, or a word for one at hand
    std::vector<std::string> remarks;                  ///< what it leaves out
};

/// The reflected light that a verb is called with, if any.
class ChosenSolution {
public:
    /// A path, a keiko.Solution, or None. Throws Error for a file that is no solution.
    explicit ChosenSolution(const pybind11::object& solution);
    /// The scene with this light at the levels of a rig; the scene itself without any. Throws Error
    /// for a scene without shadows, and for light of another scene.
    std::shared_ptr<const Scene> lit(const OpenScene& open, const LightRig& rig) const;

private:
    std::optional<OpenSolution> open_;
};

/// The class Solution and the function solved_radiosity.
void add_radiosity(pybind11::module_& module);

} // namespace keiko::python
