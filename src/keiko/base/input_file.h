#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

namespace keiko {

/// The most bytes that a file of text may have, 1 GiB.
constexpr std::uintmax_t largest_text = std::uintmax_t{1} << 30;

/// The whole content of a file. Throws Error naming the path when it is missing, a directory, a
/// device, unreadable or empty.
/// It also throws Error, before reading, for a text of more than `most` bytes.
std::string read_file(const std::filesystem::path& path,
                      std::uintmax_t most = std::numeric_limits<std::uintmax_t>::max());

/// The whole content of a text file, without a byte order mark. Throws the errors of read_file, and
/// Error for UTF-16, UTF-32 and more than `largest_text`.
std::string read_text_file(const std::filesystem::path& path);

/// A byte order mark of UTF-8 taken off the front of a text. Throws Error naming `path` for a text
/// in UTF-16 or UTF-32.
std::string without_byte_order_mark(std::string text, const std::filesystem::path& path);

/// Throws the same errors as read_file, without reading.
void require_readable_file(const std::filesystem::path& path);

} // namespace keiko
