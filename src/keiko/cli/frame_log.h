#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace keiko::cli {

/// Log of the frames of an animation that are complete, and of their inputs. It is a text file
/// beside their pictures, image-frames.txt for image-0000.png and on, with a line `frame key` for
/// each.
class FrameLog {
public:
    /// Reads the existing log. `picture` is the name of the pictures without their number.
    explicit FrameLog(const std::filesystem::path& picture);

    /// True if the frame is complete, with inputs of this key.
    bool holds(int frame, const std::string& key) const;
    /// Records that the frame is complete; its picture must be there. Throws Error if the file
    /// cannot be written.
    void note(int frame, const std::string& key);

private:
    std::filesystem::path file_;
    std::map<int, std::string> keys_;
};

} // namespace keiko::cli
