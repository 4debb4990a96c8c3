#include "synth/face/obj_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

constexpr std::string_view kBlanks = " \t\r";

/// Takes the next word off the front of `line`; empty at its end.
std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  const auto word = line.substr(0, line.find_first_of(kBlanks));
  line.remove_prefix(word.size());
  return word;
}

template <typename Number>
std::optional<Number> number(std::string_view word) {
  Number result{};
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), result);
  if (problem != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return result;
}

class ObjFile {
 public:
  explicit ObjFile(const std::filesystem::path& file) : file_{file} {}

  std::vector<Cage> read() {
    std::ifstream stream{file_};
    if (!stream) {
      throw Error{fmt::format(
          "cannot open the head's mesh '{}'; it belongs to the program's assets", file_.string())};
    }
    std::string line;
    while (std::getline(stream, line)) {
      ++line_;
      read_line(line);
    }
    if (cages_.empty()) fail("the file has no part (a line 'o NAME')");
    return std::move(cages_);
  }

 private:
  void read_line(std::string_view line) {
    const auto keyword = next_word(line);
    if (keyword == "o") {
      if (!cages_.empty()) first_vertex_ += cages_.back().vertices.size();
      cages_.push_back({.name = std::string{next_word(line)}, .vertices = {}, .faces = {}});
    } else if (keyword == "v") {
      current().vertices.push_back(vertex(line));
    } else if (keyword == "f") {
      auto corners = face(line);
      current().faces.push_back(std::move(corners));
    }
  }

  Cage& current() {
    if (cages_.empty()) fail("a vertex or face stands before the first part (a line 'o NAME')");
    return cages_.back();
  }

  glm::dvec3 vertex(std::string_view line) const {
    std::array<double, 3> xyz{};
    for (double& coordinate : xyz) {
      const auto word = next_word(line);
      const auto value = number<double>(word);
      if (!value || !std::isfinite(*value)) {
        fail(fmt::format("'{}' is not a coordinate; a vertex is 'v X Y Z'", word));
      }
      coordinate = *value;
    }
    return {xyz[0], xyz[1], xyz[2]};
  }

  Face face(std::string_view line) {
    const auto vertices = current().vertices.size();
    Face corners;
    for (auto word = next_word(line); !word.empty(); word = next_word(line)) {
      const auto index = number<std::uint32_t>(word);
      if (!index || *index <= first_vertex_ || *index > first_vertex_ + vertices) {
        fail(fmt::format("'{}' is not a vertex of this part, whose vertices are {} to {}",
                         word,
                         first_vertex_ + 1,
                         first_vertex_ + vertices));
      }
      corners.push_back(static_cast<std::uint32_t>(*index - first_vertex_ - 1));
    }
    if (corners.size() < 3) fail("a face needs at least three vertices");
    return corners;
  }

  [[noreturn]] void fail(std::string_view finding) const {
    throw Error{fmt::format("{}:{}: {}", file_.string(), line_, finding)};
  }

  std::filesystem::path file_;
  std::size_t line_ = 0;
  std::size_t first_vertex_ = 0;  ///< vertices of all earlier parts
  std::vector<Cage> cages_;
};

}  // namespace

std::vector<Cage> read_obj(const std::filesystem::path& file) {
  return ObjFile{file}.read();
}

const Cage& part(const std::vector<Cage>& cages,
                 std::string_view name,
                 const std::filesystem::path& file) {
  const auto found = std::ranges::find(cages, name, &Cage::name);
  if (found == cages.end()) {
    throw Error{fmt::format("{}: the part 'o {}' is missing; regenerate the file with tools/head",
                            file.string(),
                            name)};
  }
  return *found;
}

}  // namespace bimodal::synth
