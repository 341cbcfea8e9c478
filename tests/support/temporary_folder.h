#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace keiko::test {

/// A folder of its own that is gone at the end of its scope.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "keiko-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path file(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
        return path_ / name;
    }
    std::filesystem::path script(const std::string& name, const std::string& body) const {
        const auto result = file(name, "#!/bin/sh\n" + body + "\n");
        std::filesystem::permissions(result, std::filesystem::perms::owner_all);
        return result;
    }

private:
    std::filesystem::path path_;
};

} // namespace keiko::test
