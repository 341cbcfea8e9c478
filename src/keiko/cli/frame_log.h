#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace keiko::cli {

/// Which frames of an animation are made, and of what: a text file beside their pictures,
/// image-frames.txt for image-0000.png and on, with a line `frame key` for each.
class FrameLog {
public:
    /// Reads what is there. `picture` is the name that the pictures have but for their number.
    explicit FrameLog(const std::filesystem::path& picture);

    /// Whether the frame is made, of what has this key.
    bool holds(int frame, const std::string& key) const;
    /// The frame is made; its picture must be there. Throws Error where the file cannot be written.
    void note(int frame, const std::string& key);

private:
    std::filesystem::path file_;
    std::map<int, std::string> keys_;
};

} // namespace keiko::cli
