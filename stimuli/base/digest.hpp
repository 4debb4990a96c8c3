#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace bimodal {

/// SHA-256 (FIPS 180-4) of the bytes, as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256(std::span<const std::byte> bytes);
[[nodiscard]] std::string sha256(std::string_view text);

/// SHA-256 of a file's content. Throws Error if the file cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& file);

/// The whole content of a file. Throws Error, naming the file, if it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& file);

}  // namespace bimodal
