// materials in TOML
#include "keiko/files/scene/material_file.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    fuzz::accepts([&] {
        const auto materials = parse_materials(fuzz::text_of(data, size), "materials.toml");
        fuzz::require(!materials.empty(), "a file has a material");
        for (const Material& material : materials)
            fuzz::require(&find_material(material.name, materials) == &material,
                          "a material is found by its name");
    });
    return 0;
}
