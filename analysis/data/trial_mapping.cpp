#include "analysis/data/trial_mapping.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/located_reading.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostValues = 100'000;
constexpr TextRule kText{.longest = 1'000, .one_line = false, .meaning = "a text"};
constexpr TextRule kColumn{.shortest = 1, .longest = 1'000, .meaning = "the name of a column"};

/// Keys that are no field of a trial are mistakes.
bool is_field(const std::string& key, const std::string& pointer, Findings& findings) {
  if (std::ranges::find(kTrialFields, key) != kTrialFields.end()) return true;
  findings.error(pointer + "/" + escape_pointer(key),
                 fmt::format("\"{}\" is no field of a trial", key),
                 suggestion(key, kTrialFields));
  return false;
}

class MappingReader {
 public:
  explicit MappingReader(Findings& findings) : findings_{findings} {}

  TrialMapping read(const Json& tree) {
    ObjectReader root{tree, "", findings_};
    read_columns(root);
    read_values(root);
    read_constants(root);
    if (const auto index = root.choice("delimiter", kDelimiters)) {
      mapping_.delimiter = kDelimiters.at(*index).front();
    }
    root.refuse_unknown_keys();
    return std::move(mapping_);
  }

 private:
  static constexpr std::array<std::string_view, 3> kDelimiters{",", ";", "\t"};

  void read_columns(ObjectReader& root) {
    const auto* const columns = object_at(root, "columns");
    if (columns == nullptr) return;
    ObjectReader reader{*columns, "/columns", findings_};
    for (const auto& [field, value] : columns->items()) {
      if (!is_field(field, "/columns", findings_)) continue;
      auto& names = mapping_.columns[field];
      if (value.is_array()) {
        for (const auto& [item, pointer] : reader.items(field, 1, 20)) {
          if (auto name = reader.text_of(*item, pointer, kColumn))
            names.push_back(std::move(*name));
        }
      } else if (auto name = reader.text(field, kColumn)) {
        names.push_back(std::move(*name));
      }
    }
  }

  void read_values(ObjectReader& root) {
    const auto* const values = object_at(root, "values");
    if (values == nullptr) return;
    ObjectReader fields{*values, "/values", findings_};
    for (const auto& [field, replaced] : values->items()) {
      if (!is_field(field, "/values", findings_)) continue;
      auto reader = fields.object(field);
      if (!reader) continue;
      for (const auto& [from, to] : replaced.items()) {
        if (auto text = reader->text(from, kText)) mapping_.values[field][from] = std::move(*text);
      }
    }
  }

  void read_constants(ObjectReader& root) {
    const auto* const constants = object_at(root, "constants");
    if (constants == nullptr) return;
    ObjectReader reader{*constants, "/constants", findings_};
    for (const auto& [field, value] : constants->items()) {
      if (!is_field(field, "/constants", findings_)) continue;
      if (auto text = reader.text(field, kText)) mapping_.constants[field] = std::move(*text);
    }
  }

  /// Null if the key is absent or no object, which is noted.
  static const Json* object_at(ObjectReader& root, std::string_view key) {
    if (!root.has(key)) return nullptr;
    const auto reader = root.object(key);
    return reader ? root.find(key) : nullptr;
  }

  Findings& findings_;
  TrialMapping mapping_;
};

}  // namespace

TrialMapping parse_mapping(std::string_view text, const std::string& file) {
  std::vector<Diagnostic> diagnostics;
  auto mapping =
      read_located(text, file, diagnostics, kMostValues, [](const Json& tree, Findings& findings) {
        return MappingReader{findings}.read(tree);
      });
  if (mapping) return std::move(*mapping);
  std::vector<std::string> told;
  for (const auto& diagnostic : diagnostics) told.push_back(describe(diagnostic));
  throw Error{fmt::format("{}", fmt::join(told, "\n"))};
}

TrialMapping read_mapping(const std::filesystem::path& file) {
  return parse_mapping(read_file(file), file.string());
}

}  // namespace bimodal::analysis
