#include "stimuli/base/digest.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

std::string sha256(std::span<const std::byte> bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw Error{"cannot compute SHA-256: OpenSSL refused"};
  }
  std::string hexadecimal;
  for (unsigned int i = 0; i < length; ++i) hexadecimal += fmt::format("{:02x}", digest.at(i));
  return hexadecimal;
}

std::string sha256(std::string_view text) {
  return sha256(std::as_bytes(std::span{text}));
}

std::string sha256_of_file(const std::filesystem::path& file) {
  return sha256(read_file(file));
}

std::string read_file(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) {
    throw Error{fmt::format("cannot read '{}': it is a folder; name a file", file.string())};
  }
  std::ifstream stream{file, std::ios::binary};
  if (!stream) {
    const auto why = std::error_code{errno, std::generic_category()}.message();
    throw Error{fmt::format(
        "cannot read '{}': {}; check the path and its permissions", file.string(), why)};
  }
  std::string content;
  std::vector<char> part(std::size_t{1} << 16U);
  do {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    content.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  if (stream.bad()) throw Error{fmt::format("cannot read '{}' to its end", file.string())};
  return content;
}

}  // namespace bimodal
