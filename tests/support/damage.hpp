#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace bimodal {

/// Damages files as bad disks, editors and hands do: bytes are flipped, lost, repeated or brought
/// together. The same seed gives the same damage.
class Damage {
 public:
  explicit Damage(std::uint32_t seed) : random_{seed} {}

  /// Up to four times.
  std::string operator()(std::string bytes) {
    const auto times = 1 + below(4);
    for (std::size_t i = 0; i < times && !bytes.empty(); ++i) once(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t bound) { return random_() % bound; }

  void once(std::string& bytes) {
    using namespace std::string_view_literals;
    static constexpr std::string_view kSpecial = "\"'\\!<>#-+.,;eE09 \n\r\t\0\xFF\xFE\xD8"sv;
    const auto at = below(bytes.size());
    switch (below(6)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[at] = kSpecial[below(kSpecial.size())];
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.erase(at, 1 + below(8));
        break;
      case 4:
        bytes.insert(below(bytes.size()), bytes.substr(at, 1 + below(40)));
        break;
      default:
        bytes.insert(at, std::to_string(random_()));
        break;
    }
  }

  std::mt19937 random_;
};

}  // namespace bimodal
