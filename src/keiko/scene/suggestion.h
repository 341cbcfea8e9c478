#pragma once

#include <span>
#include <string>
#include <string_view>

namespace keiko {

/// " (did you mean 'pitch'?)" when one of the `candidates` is about what was typed, else "".
/// Of equally near ones the first.
std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates);

/// "a, b, c"; of very many words the beginning.
std::string comma_list(std::span<const std::string> words);

} // namespace keiko
