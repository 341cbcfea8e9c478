#pragma once

#include <string_view>

namespace keiko::viewer {

/// A file of the page, which is built into the program.
struct PageFile {
    std::string_view path; ///< in the address, "/viewer.js"
    std::string_view type; ///< as Content-Type
    std::string_view text; ///< its bytes
};

/// The file of the page at a path; null if there is none.
const PageFile* page_file(std::string_view path);

} // namespace keiko::viewer
