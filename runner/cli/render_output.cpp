#include "runner/cli/render_output.hpp"

#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"

namespace bimodal::runner {

namespace {

/// Where "%04d" stands in a name, and how many digits it asks for.
struct NumberPlace {
  std::size_t at = std::string::npos;
  std::size_t length = 0;
  int digits = 1;
};

std::optional<NumberPlace> number_place(const std::string& name) {
  NumberPlace place{.at = name.find('%')};
  if (place.at == std::string::npos) return std::nullopt;
  auto end = place.at + 1;
  if (end + 1 < name.size() && name[end] == '0' && name[end + 1] >= '1' && name[end + 1] <= '9') {
    place.digits = name[end + 1] - '0';
    end += 2;
  }
  if (end >= name.size() || name[end] != 'd' || name.find('%', end) != std::string::npos) {
    throw Error{
        fmt::format("'{}': the number of a frame is written %04d, once; e.g. stew%04d.png", name)};
  }
  place.length = end + 1 - place.at;
  return place;
}

std::string ending_of(const std::string& name) {
  return lower_case(std::filesystem::path{name}.extension().string());
}

bool is_folder(const std::string& name) {
  std::error_code ignored;
  return name.ends_with('/') || std::filesystem::is_directory(name, ignored);
}

}  // namespace

std::filesystem::path RenderOutput::frame_file(std::int64_t number) const {
  const auto place = number_place(name);
  if (!place) return std::filesystem::path{name} / fmt::format("frame{:04}.png", number);
  auto file = name;
  return file.replace(place->at, place->length, fmt::format("{:0{}}", number, place->digits));
}

RenderOutput render_output(const std::string& name, bool has_instant) {
  using Kind = RenderOutput::Kind;
  RenderOutput output{.kind = Kind::Frames, .name = name};
  if (is_folder(name)) return output;
  const auto ending = ending_of(name);
  if (number_place(name)) {
    if (ending == ".png") return output;
    throw Error{
        fmt::format("'{}': numbered frames are written as PNG; end the name with .png", name)};
  }
  output.form = video_form_of(name);
  if (output.form != nullptr) {
    output.kind = Kind::Film;
  } else if (ending == ".png") {
    output.kind = has_instant ? Kind::Still : Kind::Strip;
  } else if (ending == ".wav") {
    output.kind = Kind::Sound;
  } else {
    throw Error{fmt::format(
        "'{}': what is to be written is not clear; end the name with .mp4, .webm or .gif for a "
        "film, .png for pictures side by side, %04d.png or / for one picture a frame, .wav for the "
        "voice",
        name)};
  }
  return output;
}

void require_place_for(const RenderOutput& output) {
  const auto refuse = [&](std::string_view finding) {
    throw Error{fmt::format(
        "cannot write '{}': {}; make the folder, or choose another", output.name, finding)};
  };
  std::error_code fault;
  std::filesystem::path folder{output.name};
  if (output.kind == RenderOutput::Kind::Frames && !number_place(output.name)) {
    std::filesystem::create_directories(folder, fault);
    if (fault) refuse(fault.message());
  } else {
    folder = std::filesystem::absolute(folder).parent_path();
  }
  if (!std::filesystem::is_directory(folder, fault)) {
    refuse(fmt::format("there is no folder {}", folder.string()));
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse(fmt::format("you may not write in {}", folder.string()));
  }
}

}  // namespace bimodal::runner
