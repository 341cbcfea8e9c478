#pragma once

#include "tests/bench/frame_benchmark.h"
#include "tests/bench/hidden_benchmark.h"
#include "tests/bench/inspect_benchmark.h"
#include "tests/bench/load_benchmark.h"
#include "tests/bench/panel_benchmark.h"
#include "tests/bench/penumbra_benchmark.h"
#include "tests/bench/raster_benchmark.h"
#include "tests/bench/stripe_benchmark.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keiko::bench {

struct TraceOptions {
    std::vector<std::string> scenes{};        ///< names or model files; none: all
    std::size_t rays = 100000;                ///< of each class
    std::size_t slow_rays = 1000;             ///< of each class for OpenCASCADE
    int rounds = 5;                           ///< interleaved; medians are taken
    double finest = 0;                        ///< mm, one more mesh; 0: none
    std::size_t most_triangles = 8000000;     ///< of a grid that looks for a zebra error
    bool alone = false;                       ///< Keiko without its peers, rates only
    std::filesystem::path json{}, markdown{}; ///< files to write; empty: none
};

struct PictureOptions {
    std::filesystem::path output{};
};

struct LightsOptions {
    std::filesystem::path output{}; ///< picture; empty: none
    std::filesystem::path markdown{};
};

struct ShaftsOptions {
    std::size_t rays = 192;           ///< that are marched
    std::filesystem::path plot{};     ///< SVG; empty: none
    std::filesystem::path output{};   ///< picture of a cut shaft; empty: none
    std::filesystem::path markdown{}; ///< page; empty: none
};

enum class Group {
    trace,
    picture,
    load,
    lights,
    shafts,
    penumbra,
    panels,
    stripes,
    frames,
    inspect,
    raster,
    hidden,
    help
};

struct Command {
    Group group = Group::trace;
    TraceOptions trace{};
    PictureOptions picture{};
    LoadOptions load{};
    LightsOptions lights{};
    ShaftsOptions shafts{};
    PenumbraOptions penumbra{};
    PanelOptions panels{};
    StripeOptions stripes{};
    FrameOptions frames{};
    InspectBenchmarkOptions inspect{};
    RasterOptions raster{};
    HiddenOptions hidden{};
    int exit_code = 0; ///< of help and usage errors
};

/// Reads the command line; reports on stderr what it cannot use. Without a group: trace.
Command parse_command_line(int argc, char** argv);

} // namespace keiko::bench
