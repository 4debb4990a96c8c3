#include "runner/cli/control_list.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/base/nearest.hpp"

namespace bimodal::runner {

namespace {

// Of a face without further words: the mouth's, not the tongue's or the cheeks'.
constexpr std::string_view kWidth = "width";

/// "Mouth-Width" and "mouth width" are "mouth_width".
std::string with_underscores(std::string_view name) {
  std::string plain = lower_case(std::string{name});
  std::ranges::replace_if(
      plain, [](char letter) { return letter == ' ' || letter == '-'; }, '_');
  return plain;
}

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

double read_value(std::string_view setting, std::string_view text) {
  double number = 0.0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault == std::errc{} && end == text.data() + text.size() && std::isfinite(number)) {
    return number;
  }
  throw Error{fmt::format("--controls: '{}' does not give a number; write e.g. jaw=8,lip_width=-10",
                          setting)};
}

}  // namespace

synth::Control control_called(std::string_view name) {
  const std::string plain = with_underscores(without_blanks(name));
  if (const auto control = synth::control_from_name(plain)) return *control;
  if (plain == kWidth) return synth::Control::LipWidth;
  std::vector<std::string> known;
  for (const auto& row : synth::controls()) {
    known.emplace_back(row.name);
    const std::string in_the_paper = with_underscores(row.paper_name);
    if (in_the_paper == plain) return row.control;
    if (!in_the_paper.empty() && in_the_paper != row.name) known.push_back(in_the_paper);
  }
  const std::vector<std::string_view> names{known.begin(), known.end()};
  const auto near = nearest(plain, names);
  throw Error{fmt::format("--controls: the face has no control '{}'; {}see bimodal face --list",
                          name,
                          near ? fmt::format("did you mean {}? ", *near)
                               : fmt::format("there are {}; ", fmt::join(names, ", ")))};
}

AskedPose possible(const synth::Pose& wanted) {
  AskedPose asked{.pose = synth::within_range(wanted), .remarks = {}};
  for (const auto& row : synth::controls()) {
    const double drawn = synth::value(asked.pose, row.control);
    const double value = synth::value(wanted, row.control);
    if (drawn == value) continue;
    asked.remarks.push_back(fmt::format("{} {:g} is outside {:g} to {:g} {}; drawn at {:g}",
                                        row.name,
                                        value,
                                        row.lowest,
                                        row.highest,
                                        row.unit,
                                        drawn));
  }
  return asked;
}

synth::Pose read_controls(const std::vector<std::string>& settings) {
  synth::Pose pose = synth::neutral_pose();
  std::set<synth::Control> set;
  for (const std::string_view setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string_view::npos) {
      throw Error{fmt::format(
          "--controls: '{}' sets nothing; write NAME=VALUE, e.g. jaw=8,lip_width=-10", setting)};
    }
    const auto control = control_called(setting.substr(0, equals));
    const double wanted = read_value(setting, without_blanks(setting.substr(equals + 1)));
    const auto& row = synth::describe(control);
    if (!set.insert(control).second) {
      throw Error{fmt::format("--controls: {} is set twice; keep one of them", row.name)};
    }
    synth::value(pose, control) = wanted;
  }
  return pose;
}

}  // namespace bimodal::runner
