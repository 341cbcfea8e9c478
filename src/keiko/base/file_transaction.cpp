#include "keiko/base/file_transaction.h"

#include "keiko/base/error.h"
#include "keiko/base/output_file.h"

#include <deque>
#include <system_error>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// Folders that are gone again, where nothing was put into them.
class MadeFolders {
public:
    MadeFolders() = default;
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;
    ~MadeFolders() {
        std::error_code ignored;
        for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
            fs::remove(*folder, ignored);
    }

    /// Makes a folder and the parents that are missing.
    void make(const fs::path& folder) {
        std::error_code code;
        if (folder.empty() || fs::is_directory(folder, code)) return;
        make(folder.parent_path());
        if (fs::create_directory(folder, code)) made_.push_back(folder);
        if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    }

private:
    std::vector<fs::path> made_;
};

} // namespace

void FileTransaction::add(fs::path path, std::string bytes) {
    files_.emplace_back(std::move(path), std::move(bytes));
}

void FileTransaction::add_folder(const fs::path& folder, FolderContent&& content) {
    folders_.push_back(folder);
    for (auto& [name, bytes] : content) add(folder / name, std::move(bytes));
}

void FileTransaction::write() const {
    MadeFolders made;
    for (const fs::path& folder : folders_) made.make(folder);
    std::deque<AtomicFile> pending;
    for (const auto& [path, bytes] : files_) pending.emplace_back(path).fill(bytes);
    for (AtomicFile& file : pending) file.put_in_place();
}

} // namespace keiko
