#include "keiko/viewer/page.h"

#include "keiko_viewer_page.h"

#include <algorithm>
#include <iterator>

namespace keiko::viewer {

const PageFile* page_file(std::string_view path) {
    const auto found = std::find_if(std::begin(page_files), std::end(page_files),
                                    [&](const PageFile& file) { return file.path == path; });
    return found == std::end(page_files) ? nullptr : &*found;
}

} // namespace keiko::viewer
