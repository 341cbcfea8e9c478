#include "keiko/light/luminance/front_to_back.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

TEST(Compositing, AgreesWithOracle) {
    const test::OracleTable table("compositing");
    test::WorstError light("C"), opacity("A"), seen("I");
    for (const auto& row : table) {
        FrontToBack layers;
        const std::vector<double> own = row.list("in.i"), alpha = row.list("in.alpha");
        for (std::size_t i = 0; i < own.size(); ++i) layers.add(Rgb(own[i]), alpha[i]);
        light.compare(row, layers.light.g, row.number("out.C"), 1e-11);
        opacity.compare(row, layers.opacity, row.number("out.A"), 1e-11);
        layers.add(Rgb(row.number("in.bg")), 1);
        seen.compare(row, layers.light.g, row.number("out.I"), 1e-11);
    }
}
