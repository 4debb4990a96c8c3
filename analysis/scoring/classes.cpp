#include "analysis/scoring/classes.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "analysis/scoring/phone_features.hpp"
#include "analysis/statistics/information.hpp"
#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/utf8.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

namespace {

using Classes = std::map<std::string, std::string>;

constexpr std::string_view kForm =
    "begin with a line like label,class and let one line per label follow, like p,labial";

Classes owens_blazek() {
  const std::vector<std::vector<Phone>> visemes{
      {Phone::P, Phone::B, Phone::M},
      {Phone::F, Phone::V},
      {Phone::TH, Phone::DH},
      {Phone::W, Phone::R},
      {Phone::SH, Phone::ZH, Phone::CH, Phone::JH},
      {Phone::T, Phone::D, Phone::N, Phone::S, Phone::L, Phone::K, Phone::G}};
  Classes classes;
  for (const auto& members : visemes) {
    for (const Phone member : members) classes.emplace(symbol(member), spell(members));
  }
  return classes;
}

template <typename Feature>
Classes consonants_by(Feature feature) {
  Classes classes;
  for (const Phone phone : all_phones()) {
    if (is_consonant(phone)) classes.emplace(symbol(phone), feature(consonant_features(phone)));
  }
  return classes;
}

struct Preset {
  std::string_view name;
  std::string_view source;
  std::function<Classes()> make;
};

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all{
      {"owens-blazek",
       "Owens & Blazek (1985), J. Speech Hear. Res. 28, 381-393",
       [] { return owens_blazek(); }},
      {"place",
       "place of articulation",
       [] { return consonants_by([](const auto& features) { return name(features.place); }); }},
      {"manner",
       "manner of articulation",
       [] { return consonants_by([](const auto& features) { return name(features.manner); }); }},
      {"voicing",
       "voicing",
       [] {
         return consonants_by([](const auto& features) -> std::string_view {
           return features.voiced ? "voiced" : "voiceless";
         });
       }},
  };
  return all;
}

std::vector<std::string> classes_of(const std::vector<std::string>& labels,
                                    const ClassMap& classes) {
  std::vector<std::string> found;
  for (const auto& label : labels) found.push_back(classes.class_of(label));
  return found;
}

/// Labels that belong to a class, in their order.
std::vector<std::string> members(const std::vector<std::string>& labels,
                                 const std::string& name,
                                 const ClassMap& classes) {
  std::vector<std::string> found;
  for (const auto& label : labels) {
    if (classes.class_of(label) == name) found.push_back(label);
  }
  return found;
}

/// The labels themselves where they belong to a class, and nothing where they do not.
std::vector<std::string> only(const std::vector<std::string>& labels,
                              const std::string& name,
                              const ClassMap& classes) {
  auto kept = labels;
  for (auto& label : kept) {
    if (classes.class_of(label) != name) label.clear();
  }
  return kept;
}

std::size_t count_different(std::vector<std::string> labels, const std::vector<std::string>& more) {
  labels.insert(labels.end(), more.begin(), more.end());
  std::ranges::sort(labels);
  return static_cast<std::size_t>(std::unique(labels.begin(), labels.end()) - labels.begin());
}

}  // namespace

const std::string& ClassMap::class_of(const std::string& label) const {
  auto found = classes.find(label);
  if (found == classes.end() && of_phones) {
    if (const auto phone = phone_from_symbol(label))
      found = classes.find(std::string{symbol(*phone)});
  }
  return found == classes.end() ? label : found->second;
}

std::vector<std::string_view> preset_class_names() {
  std::vector<std::string_view> names;
  for (const auto& preset : presets()) names.push_back(preset.name);
  return names;
}

std::optional<ClassMap> preset_classes(std::string_view name) {
  const auto found = std::ranges::find(presets(), name, &Preset::name);
  if (found == presets().end()) return std::nullopt;
  return ClassMap{.name = std::string{found->name},
                  .source = std::string{found->source},
                  .classes = found->make(),
                  .of_phones = true};
}

ClassMap parse_classes(std::string_view text, std::string_view file) {
  CsvReader csv{text, file};
  if (!is_utf8(text)) csv.refuse("the file is not UTF-8 text", "save it as CSV, UTF-8");
  const auto header = csv.next();
  if (!header || *header != std::vector<std::string>{"label", "class"}) {
    csv.refuse("the first line does not name the columns label and class", kForm);
  }
  ClassMap map{.name = std::string{file}, .source = {}, .classes = {}};
  while (auto fields = csv.next()) {
    if (fields->size() != 2) {
      csv.refuse(fmt::format("{} fields, not 2", fields->size()), "write a label and its class");
    }
    if (fields->front().empty() || fields->back().empty()) {
      csv.refuse("the label or its class is empty",
                 "write both; leave out the line of a label that is alone");
    }
    if (map.classes.emplace(fields->front(), fields->back()).second) continue;
    csv.refuse(fmt::format("the label \"{}\" occurs twice", fields->front()), "give it once");
  }
  if (map.classes.empty()) csv.refuse("there are no labels after the first line", kForm);
  return map;
}

ClassMap read_classes(const std::filesystem::path& file) {
  return parse_classes(read_file(file), file.string());
}

ConfusionMatrix matrix_of_classes(const ConfusionMatrix& matrix, const ClassMap& classes) {
  return grouped(
      matrix, classes_of(matrix.stimuli(), classes), classes_of(matrix.responses(), classes));
}

std::vector<WithinClass> within_class_confusions(const ConfusionMatrix& matrix,
                                                 const ClassMap& classes) {
  std::vector<WithinClass> found;
  for (const auto& stimulus : matrix.stimuli()) {
    const auto& name = classes.class_of(stimulus);
    if (std::ranges::find(found, name, &WithinClass::name) != found.end()) continue;
    const auto size = count_different(members(matrix.stimuli(), name, classes),
                                      members(matrix.responses(), name, classes));
    if (size < 2) continue;
    auto& within = found.emplace_back();
    within.name = name;
    within.matrix = grouped(
        matrix, only(matrix.stimuli(), name, classes), only(matrix.responses(), name, classes));
    within.chance = 1.0 / static_cast<double>(size);
    const double total = within.matrix.total();
    if (total > 0) within.correct = within.matrix.correct() / total;
  }
  return found;
}

}  // namespace bimodal::analysis
