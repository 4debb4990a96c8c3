#include "protocols/reading/read_face.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/json_text.hpp"
#include "stimuli/base/obstacle.hpp"

namespace bimodal::protocols {

namespace {

constexpr std::size_t kMostNames = 50;  ///< of parts in one list

template <typename Term>
std::vector<std::string_view> names_of(const std::vector<Term>& terms) {
  std::vector<std::string_view> names;
  for (const auto& term : terms) names.push_back(term.name);
  return names;
}

/// All parts that the names stand for.
std::uint32_t parts_of(const std::vector<FacePart>& known, const std::vector<std::string>& names) {
  std::uint32_t parts = 0;
  for (const auto& part : known) {
    if (std::ranges::find(names, part.name) != names.end()) parts |= part.parts;
  }
  return parts;
}

std::uint32_t all_parts(const std::vector<FacePart>& known) {
  std::uint32_t parts = 0;
  for (const auto& part : known) parts |= part.parts;
  return parts;
}

/// One of `names`; what cannot be read leaves `usual`.
std::string read_choice(ObjectReader& reader,
                        std::string_view key,
                        const std::vector<std::string_view>& names,
                        const std::string& usual) {
  const auto chosen = reader.choice(key, names);
  return chosen ? std::string{names[*chosen]} : usual;
}

bool looks_like_path(std::string_view text) {
  return text.ends_with(".json") || text.find('/') != std::string_view::npos;
}

std::string with_unit(double amount, const FaceControl& control) {
  if (control.unit == "ratio") return fmt::format("{:g}", amount);
  return fmt::format("{:g} {}", amount, control.unit);
}

double amount_of(const std::map<std::string, double>& amounts, std::string_view name) {
  const auto found = amounts.find(std::string{name});
  return found == amounts.end() ? 0.0 : found->second;
}

}  // namespace

Face FaceReader::read(ObjectReader& parent, const Face& usual) const {
  Face face = usual;
  auto reader = parent.object("face");
  if (!reader) return face;
  face.view = read_choice(*reader, "view", terms_.views, usual.view);
  face.material = read_material(*reader, usual.material);
  face.show = read_parts(*reader, "show", usual.show);
  face.hide = read_parts(*reader, "hide", usual.hide);
  if (const auto transparency = reader->number(
          "transparency", {0, 1, "how far the skin is seen through, 0 (opaque) to 1, e.g. 0.6"})) {
    face.transparency = *transparency;
  }
  face.points = read_choice(*reader, "points", terms_.points, usual.points);
  read_expression(*reader, face);
  read_controls(*reader, face);
  reader->refuse_unknown_keys();
  judge_parts(*reader, face);
  judge_ranges(*reader, face);
  return face;
}

std::string FaceReader::read_material(ObjectReader& reader, const std::string& usual) const {
  const auto written = reader.text("material",
                                   {.shortest = 1,
                                    .longest = 500,
                                    .meaning = "colours and light: the name of a preset, e.g. "
                                               "\"clay\", or the path of a file relative to the "
                                               "protocol"});
  if (!written) return usual;
  if (std::ranges::find(terms_.materials, *written) != terms_.materials.end()) return *written;
  const auto file = folder_ / *written;
  const auto reason = obstacle(file);
  if (!reason) return file.string();
  if (looks_like_path(*written)) {
    findings_.error(reader.pointer_to("material"),
                    fmt::format("cannot read the materials '{}': {}", file.string(), *reason),
                    "it is a path relative to the protocol, or the name of a preset");
    return usual;
  }
  const std::vector<std::string_view> presets{terms_.materials.begin(), terms_.materials.end()};
  findings_.error(reader.pointer_to("material"),
                  fmt::format("there are no materials {}", shown(nlohmann::json(*written))),
                  suggestion(*written, presets) + "; or give the path of a file");
  return usual;
}

std::vector<std::string> FaceReader::read_parts(ObjectReader& reader,
                                                std::string_view key,
                                                const std::vector<std::string>& usual) const {
  if (!reader.has(key)) return usual;
  const auto known = names_of(terms_.parts);
  const TextRule rule{.longest = 40, .meaning = "a part of the face, e.g. \"lips\""};
  const std::size_t fewest = key == "show" ? 1 : 0;  // to show nothing is never meant
  std::vector<std::string> parts;
  for (const auto& [item, pointer] : reader.items(key, fewest, kMostNames)) {
    auto name = reader.text_of(*item, pointer, rule);
    if (!name) continue;
    if (std::ranges::find(known, *name) == known.end()) {
      findings_.error(
          pointer, fmt::format("the face has no part {}", shown(*item)), suggestion(*name, known));
      continue;
    }
    parts.push_back(std::move(*name));
  }
  return parts;
}

void FaceReader::read_expression(ObjectReader& parent, Face& face) const {
  auto reader = parent.object("expression");
  if (!reader) return;
  face.expression.clear();
  for (const auto& expression : terms_.expressions) {
    const auto strength =
        reader->number(expression.name, {0, 1, "how strongly it is shown, 0 to 1, e.g. 0.7"});
    if (strength) face.expression[std::string{expression.name}] = *strength;
  }
  reader->refuse_unknown_keys();
}

void FaceReader::read_controls(ObjectReader& parent, Face& face) const {
  const auto* const written = parent.find("controls");
  if (written == nullptr) return;
  face.controls.clear();
  const auto pointer = parent.pointer_to("controls");
  const auto settable = without_speech_controls(*written, pointer);
  ObjectReader reader{settable, pointer, findings_};
  for (const auto& control : terms_.controls) {
    const auto meaning = fmt::format("where the control stays, {} to {}; 0 is at rest",
                                     control.lowest,
                                     with_unit(control.highest, control));
    const auto value = reader.number(control.name, {control.lowest, control.highest, meaning});
    if (value) face.controls[std::string{control.name}] = *value;
  }
  reader.refuse_unknown_keys();
}

nlohmann::json FaceReader::without_speech_controls(nlohmann::json written,
                                                   const std::string& pointer) const {
  for (const auto name : terms_.speech_controls) {
    if (!written.is_object() || written.erase(std::string{name}) == 0) continue;
    findings_.error(fmt::format("{}/{}", pointer, name),
                    fmt::format("speech moves \"{}\"", name),
                    fmt::format("set one that it leaves alone: {}",
                                fmt::join(names_of(terms_.controls), ", ")));
  }
  return written;
}

void FaceReader::judge_parts(ObjectReader& reader, const Face& face) const {
  if (findings_.faulty(reader.pointer())) return;
  const auto shown =
      face.show.empty() ? all_parts(terms_.parts) : parts_of(terms_.parts, face.show);
  if ((shown & ~parts_of(terms_.parts, face.hide)) != 0 || terms_.parts.empty()) return;
  findings_.error(reader.pointer_to(reader.has("hide") ? "hide" : "show"),
                  "nothing of the face is left to be seen",
                  "hide less, or show more");
}

void FaceReader::judge_ranges(ObjectReader& reader, const Face& face) const {
  if (findings_.faulty(reader.pointer())) return;
  for (const auto& control : terms_.controls) {
    double sum = amount_of(face.controls, control.name);
    for (const auto& expression : terms_.expressions) {
      const auto adds = expression.adds.find(control.name);
      if (adds == expression.adds.end()) continue;
      sum += amount_of(face.expression, expression.name) * adds->second;
    }
    if (sum >= control.lowest && sum <= control.highest) continue;
    findings_.error(
        reader.pointer_to(reader.has("expression") ? "expression" : "controls"),
        fmt::format(
            "controls and expressions together move \"{}\" to {}, and it goes from {} to {}",
            control.name,
            with_unit(sum, control),
            control.lowest,
            control.highest),
        "weaken one of them");
  }
}

}  // namespace bimodal::protocols
