#include "keiko/batch/part_names.h"

#include "keiko/base/error.h"

#include <map>
#include <set>

namespace keiko {
namespace fs = std::filesystem;
namespace {

std::string whole_name(const fs::path& file) {
    std::string name;
    for (const fs::path& step : file.lexically_normal().relative_path())
        if (step != "..") name += (name.empty() ? "" : "-") + step.string();
    return name;
}

void require_name(const std::string& name, const fs::path& file) {
    if (name.empty() || name.starts_with('.'))
        throw Error(file.string(), "", "has no name for a folder of results");
}

} // namespace

std::vector<std::string> part_names(std::span<const fs::path> files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) {
        names.push_back(file.stem().string());
        require_name(names.back(), file);
    }
    if (std::set(names.begin(), names.end()).size() == names.size()) return names;
    std::map<std::string, fs::path> known;
    for (std::size_t i = 0; i < files.size(); ++i) {
        names[i] = whole_name(files[i]);
        require_name(names[i], files[i]);
        const auto [at, added] = known.emplace(names[i], files[i]);
        if (!added) throw Error(files[i].string(), "", "has the name of " + at->second.string());
    }
    return names;
}

} // namespace keiko
