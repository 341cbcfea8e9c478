#include "keiko/files/scene/transform_table.h"

#include "keiko/files/toml/toml_reader.h"

namespace keiko {
namespace {

/// Scales of a model: from nanometres that are taken for millimetres to kilometres.
constexpr TomlLimits scales{.low = 1e-6, .high = 1e6};

} // namespace

ModelTransform transform_from(const TomlTable& table) {
    ModelTransform transform;
    transform.scale = table.number("scale", scales).value_or(transform.scale);
    if (const auto turn = table.numbers("rotate", 4, TomlLimits::place())) {
        transform.axis = Vec3((*turn)[0], (*turn)[1], (*turn)[2]), transform.angle = (*turn)[3];
        if (!(transform.axis.length() > 0))
            throw table.error("rotate", "the axis must not be a zero vector");
    }
    transform.translation = table.vector("translate").value_or(transform.translation);
    table.finish();
    return transform;
}

} // namespace keiko
