#include "runner/cli/calibration.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runner/cli/timing_json.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

constexpr int kFormat = 1;

/// Of what has been measured on any screen and loudspeaker.
bool is_plausible(const Moments& moments) {
  constexpr double kFarthestMs = 500.0;
  constexpr std::size_t kFewest = 2;
  constexpr std::size_t kMost = 1'000'000;
  const auto near = [](double value) { return std::abs(value) <= kFarthestMs; };  // NaN is not
  return moments.count >= kFewest && moments.count <= kMost && near(moments.mean_ms) &&
         near(moments.smallest_ms) && near(moments.largest_ms) && near(moments.deviation_ms) &&
         moments.deviation_ms >= 0.0 && moments.smallest_ms <= moments.mean_ms &&
         moments.mean_ms <= moments.largest_ms;
}

Moments moments_from(const nlohmann::json& json) {
  return {.count = json.at("trials").get<std::size_t>(),
          .mean_ms = json.at("mean_ms").get<double>(),
          .deviation_ms = json.at("sd_ms").get<double>(),
          .median_ms = json.at("median_ms").get<double>(),
          .smallest_ms = json.at("smallest_ms").get<double>(),
          .largest_ms = json.at("largest_ms").get<double>()};
}

nlohmann::ordered_json as_json(const Calibration& calibration) {
  return {{"bimodal_calibration", kFormat},
          {"name", calibration.name},
          {"made_utc", calibration.made_utc},
          {"display", calibration.display},
          {"audio", calibration.audio},
          {"input", calibration.input},
          {"audio_visual_offset", as_json(calibration.offset)},
          {"visual_true_minus_reported", as_json(calibration.visual)},
          {"auditory_true_minus_reported", as_json(calibration.auditory)}};
}

}  // namespace

std::string device_part(const std::string& description) {
  auto end = description.size();
  for (const auto* const mark : {", period ", ", stream of "}) {
    end = std::min(end, description.find(mark));
  }
  return description.substr(0, end);
}

std::filesystem::path calibration_file(const std::string& name) {
  if (name.empty()) throw Error{"a calibration needs a name; give e.g. --calibration booth-1"};
  if (name.find('/') != std::string::npos) return name;
  if (const char* const folder = std::getenv("BIMODAL_CONFIG")) {
    return std::filesystem::path{folder} / "timing" / (name + ".json");
  }
  const char* const home = std::getenv("HOME");
  if (home == nullptr) {
    throw Error{
        "cannot tell where calibrations are kept: neither BIMODAL_CONFIG nor HOME is set; "
        "set one, or give a path as ./" +
        name + ".json"};
  }
  return std::filesystem::path{home} / ".config" / "bimodal" / "timing" / (name + ".json");
}

void write_calibration(const Calibration& calibration, const std::filesystem::path& file) {
  std::error_code ignored;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  write_file(file, as_json(calibration).dump(2) + "\n");
}

Calibration read_calibration(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  if (!in || !std::filesystem::is_regular_file(file)) {
    throw Error{
        fmt::format("there is no calibration '{}'; make one by `bimodal timing --input "
                    "DEVICE --calibration NAME`, or leave --calibration out",
                    file.string())};
  }
  const std::string text{std::istreambuf_iterator<char>{in}, {}};
  const auto json = nlohmann::json::parse(text, nullptr, false);
  try {
    if (json.at("bimodal_calibration") != kFormat) {
      throw Error{
          fmt::format("'{}' is of a format that this program does not know; make it anew "
                      "by `bimodal timing`",
                      file.string())};
    }
    Calibration calibration{.name = json.at("name").get<std::string>(),
                            .made_utc = json.at("made_utc").get<std::string>(),
                            .display = json.at("display").get<std::string>(),
                            .audio = json.at("audio").get<std::string>(),
                            .input = json.at("input").get<std::string>(),
                            .offset = moments_from(json.at("audio_visual_offset")),
                            .visual = moments_from(json.at("visual_true_minus_reported")),
                            .auditory = moments_from(json.at("auditory_true_minus_reported"))};
    if (!is_plausible(calibration.offset) || !is_plausible(calibration.visual) ||
        !is_plausible(calibration.auditory)) {
      throw Error{fmt::format(
          "'{}' has numbers that no measurement gives; make it anew by `bimodal timing --input "
          "DEVICE --calibration NAME`",
          file.string())};
    }
    return calibration;
  } catch (const nlohmann::json::exception&) {
    throw Error{
        fmt::format("'{}' is no calibration, or is damaged; make it anew by `bimodal "
                    "timing --input DEVICE --calibration NAME`",
                    file.string())};
  }
}

std::string as_text(const Calibration& calibration) {
  return as_json(calibration).dump();
}

}  // namespace bimodal::runner
