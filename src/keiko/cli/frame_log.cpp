#include "keiko/cli/frame_log.h"

#include "keiko/base/output_file.h"

#include <fstream>

namespace keiko::cli {

FrameLog::FrameLog(const std::filesystem::path& picture)
    : file_(picture.parent_path() / (picture.stem().string() + "-frames.txt")) {
    std::ifstream lines(file_);
    int frame = 0;
    std::string key;
    while (lines >> frame >> key) keys_[frame] = key;
}

bool FrameLog::holds(int frame, const std::string& key) const {
    const auto found = keys_.find(frame);
    return found != keys_.end() && found->second == key;
}

void FrameLog::note(int frame, const std::string& key) {
    keys_[frame] = key;
    std::string text;
    for (const auto& [number, made_of] : keys_)
        text += std::to_string(number) + " " + made_of + "\n";
    write_text_file(file_, text);
}

} // namespace keiko::cli
