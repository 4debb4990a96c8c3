#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// Which labels belong together: visemes, say.
struct ClassMap {
  std::string name;                            ///< "owens-blazek", or the file
  std::string source;                          ///< reference; empty for a file
  std::map<std::string, std::string> classes;  ///< by label
  bool of_phones = false;                      ///< labels are phones, "p" as good as "P"

  /// The class of a label; of one that the map lacks the label itself, alone in its class.
  [[nodiscard]] const std::string& class_of(const std::string& label) const;
};

/// "owens-blazek", "place", "manner", "voicing".
[[nodiscard]] std::vector<std::string_view> preset_class_names();

/// A map of consonants by one of these names, else absent; labels are symbols of phones ("SH"), so
/// vowels stay alone.
///
/// owens-blazek: the visemes of Owens, E. & Blazek, B. (1985), Visemes observed by hearing-impaired
/// and normal-hearing adult viewers, J. Speech Hear. Res. 28, 381-393: /p b m/, /f v/, /th dh/,
/// /w r/, /ch jh sh zh/, /t d s k n g l/, named by their members; other consonants stay alone.
/// place, manner, voicing: the features of phone_features.hpp.
[[nodiscard]] std::optional<ClassMap> preset_classes(std::string_view name);

/// A map as CSV: a line like label,class, then one line for each label. Throws Error, naming file
/// and line.
[[nodiscard]] ClassMap parse_classes(std::string_view text, std::string_view file);

/// The same of a file.
[[nodiscard]] ClassMap read_classes(const std::filesystem::path& file);

/// The confusions of classes: counts of stimuli and of responses of the same class are added.
[[nodiscard]] ConfusionMatrix matrix_of_classes(const ConfusionMatrix& matrix,
                                                const ClassMap& classes);

/// How well the members of one class are told from each other: confusions within visemes are not
/// random (Files, Tjan, Jiang & Bernstein, 2015, Front. Psychol. 6, 878).
struct WithinClass {
  std::string name;
  ConfusionMatrix matrix;         ///< of its stimuli, with the responses within the class only
  std::optional<double> correct;  ///< part of these that names the right member; absent without any
  double chance = 0.0;            ///< what guessing among the members would give: 1 / members
};

/// For each class of two members or more, in the order in which stimuli meet it. The members of a
/// class are the labels of stimuli and responses that belong to it.
[[nodiscard]] std::vector<WithinClass> within_class_confusions(const ConfusionMatrix& matrix,
                                                               const ClassMap& classes);

}  // namespace bimodal::analysis
