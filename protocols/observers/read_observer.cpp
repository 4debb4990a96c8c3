#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "protocols/observers/observer_description.hpp"
#include "stimuli/words/judged_json.hpp"

namespace bimodal::protocols {

namespace {

using nlohmann::json;

constexpr double kRowTolerance = 1e-6;
constexpr std::array<std::string_view, 6> kKeys{
    "name", "provenance", "stated_snr_db", "slope_per_db", "auditory", "visual"};
constexpr std::array<std::string_view, 2> kModalityKeys{"consonants", "vowels"};
constexpr std::array<std::string_view, 2> kTableKeys{"columns", "rows"};

/// The consonants or the vowels, and what to call one.
struct Kind {
  std::string_view name;
  std::vector<Phone> phones;
};

Kind kind_of(std::string_view key) {
  Kind kind{key == "vowels" ? "vowel" : "consonant", {}};
  for (const Phone phone : all_phones()) {
    if (key == "vowels" ? is_vowel(phone) : is_consonant(phone)) kind.phones.push_back(phone);
  }
  return kind;
}

class Reader {
 public:
  explicit Reader(JudgedJson& judged) : judged_{judged} {}

  ObserverDescription read(const json& root) {
    ObserverDescription description;
    judged_.warn_of_unknown_keys(root, "", kKeys);
    description.name = judged_.text_at(root, "", "name", "name the observer").value_or("");
    description.provenance =
        judged_.text_at(root, "", "provenance", "say where the numbers come from").value_or("");
    description.stated_snr =
        Decibels{number_at(root, "stated_snr_db", "give the S/N of the auditory table, e.g. -8")};
    const std::string slope_remedy = "give the slope of the logistic function, e.g. 0.25";
    const bool has_slope = root.contains("slope_per_db");
    description.slope_per_db = number_at(root, "slope_per_db", slope_remedy);
    if (has_slope && root["slope_per_db"].is_number() && !(description.slope_per_db > 0.0)) {
      judged_.find("/slope_per_db",
                   fmt::format("{} is not above 0", shown(root["slope_per_db"])),
                   slope_remedy);
    }
    read_modality(root, "auditory", description.auditory);
    read_modality(root, "visual", description.visual);
    return description;
  }

 private:
  double number_at(const json& object, std::string_view key, const std::string& remedy) {
    const auto found = object.find(key);
    if (found == object.end()) {
      judged_.find("", fmt::format("there is no \"{}\"", key), remedy);
    } else if (!found->is_number()) {
      judged_.find(
          fmt::format("/{}", key), fmt::format("{} is not a number", shown(*found)), remedy);
    } else {
      return found->get<double>();
    }
    return 0.0;
  }

  /// The object or array under a key; null, with a finding, if it is not there.
  const json* part(const json& object, const std::string& at, std::string_view key, bool array) {
    const auto found = object.find(key);
    const std::string_view wanted = array ? "an array" : "an object";
    const auto remedy = fmt::format("write it as in typical.json, with {}", wanted);
    if (found == object.end()) {
      judged_.find(at, fmt::format("there is no \"{}\"", key), remedy);
    } else if (array ? !found->is_array() : !found->is_object()) {
      judged_.find(fmt::format("{}/{}", at, key),
                   fmt::format("{} is not {}", shown(*found), wanted),
                   remedy);
    } else {
      return &*found;
    }
    return nullptr;
  }

  void read_modality(const json& root, std::string_view key, PhoneTable& table) {
    const json* modality = part(root, "", key, false);
    if (modality == nullptr) return;
    const auto at = fmt::format("/{}", key);
    judged_.warn_of_unknown_keys(*modality, at, kModalityKeys);
    for (const std::string_view kind : kModalityKeys) {
      const json* content = part(*modality, at, kind, false);
      if (content != nullptr) {
        read_table(*content, fmt::format("{}/{}", at, kind), kind_of(kind), table);
      }
    }
  }

  void read_table(const json& content, const std::string& at, const Kind& kind, PhoneTable& table) {
    judged_.warn_of_unknown_keys(content, at, kTableKeys);
    const json* columns = part(content, at, "columns", true);
    const json* rows = part(content, at, "rows", false);
    if (columns == nullptr || rows == nullptr) return;
    const auto responses = read_columns(*columns, at + "/columns", kind);
    std::vector<Phone> stimuli;
    for (const auto& [key, row] : rows->items()) {
      const auto pointer = fmt::format("{}/rows/{}", at, escape_pointer(key));
      const auto stimulus = read_phone(key, pointer, kind);
      if (!stimulus.has_value()) continue;
      stimuli.push_back(*stimulus);
      if (responses.has_value()) read_row(row, pointer, *stimulus, *responses, table);
    }
    report_missing(stimuli, at + "/rows", kind, "row");
  }

  std::optional<Phone> read_phone(const json& written, const std::string& at, const Kind& kind) {
    const auto phone = written.is_string()
                           ? phone_from_symbol(written.get_ref<const std::string&>())
                           : std::nullopt;
    if (phone.has_value() && std::ranges::find(kind.phones, *phone) != kind.phones.end()) {
      return phone;
    }
    judged_.find(at,
                 fmt::format("{} is no {}", shown(written), kind.name),
                 fmt::format("use each of {} once", spell(kind.phones)));
    return std::nullopt;
  }

  bool report_missing(const std::vector<Phone>& present,
                      const std::string& at,
                      const Kind& kind,
                      std::string_view what) {
    std::vector<Phone> missing;
    std::vector<Phone> doubled;
    for (const Phone phone : kind.phones) {
      const auto count = std::ranges::count(present, phone);
      if (count == 0) missing.push_back(phone);
      if (count > 1) doubled.push_back(phone);
    }
    if (!missing.empty()) {
      judged_.find(at,
                   fmt::format("there is no {} for {}", what, spell(missing)),
                   fmt::format("give one {} for each {}", what, kind.name));
    }
    if (!doubled.empty()) {
      judged_.find(at,
                   fmt::format("there are several {}s for {}", what, spell(doubled)),
                   fmt::format("give one {} for each {}", what, kind.name));
    }
    return missing.empty() && doubled.empty();
  }

  /// Absent unless each phone of the kind stands there exactly once.
  std::optional<std::vector<Phone>> read_columns(const json& columns,
                                                 const std::string& at,
                                                 const Kind& kind) {
    std::vector<Phone> phones;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto phone = read_phone(columns[i], fmt::format("{}/{}", at, i), kind);
      if (phone.has_value()) phones.push_back(*phone);
    }
    const bool complete = report_missing(phones, at, kind, "column");
    if (!complete || phones.size() != columns.size()) return std::nullopt;
    return phones;
  }

  void read_row(const json& row,
                const std::string& at,
                Phone stimulus,
                const std::vector<Phone>& responses,
                PhoneTable& table) {
    if (!row.is_array() || row.size() != responses.size()) {
      judged_.find(
          at,
          row.is_array() ? fmt::format("there are {} numbers", row.size())
                         : fmt::format("{} is no row", shown(row)),
          fmt::format("give an array of {} probabilities, one for each column", responses.size()));
      return;
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!row[i].is_number() || row[i].get<double>() < 0.0 || row[i].get<double>() > 1.0) {
        judged_.find(fmt::format("{}/{}", at, i),
                     fmt::format("{} is no probability", shown(row[i])),
                     "give a number from 0 to 1");
        return;
      }
      sum += row[i].get<double>();
    }
    if (std::abs(sum - 1.0) > kRowTolerance) {
      judged_.find(at, fmt::format("the row sums to {:.6g}", sum), "make its numbers sum to 1");
      return;
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      table(stimulus, responses[i]) = row[i].get<double>() / sum;
    }
    if (table(stimulus, stimulus) == 0.0) {
      judged_.find(at,
                   fmt::format("{} is never recognised", symbol(stimulus)),
                   "give the right answer a probability above 0, however small");
    }
  }

  JudgedJson& judged_;
};

}  // namespace

ObserverDescription read_observer(const std::filesystem::path& file,
                                  std::vector<Diagnostic>& diagnostics) {
  JudgedJson judged{file, diagnostics};
  const auto root = judged.parse();
  if (!root.has_value()) return {};
  if (!root->is_object()) {
    judged.find("", "an observer must be an object", "write it as in typical.json");
    return {};
  }
  return Reader{judged}.read(*root);
}

}  // namespace bimodal::protocols
