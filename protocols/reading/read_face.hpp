#pragma once

#include <filesystem>
#include <utility>

#include "protocols/model/face.hpp"
#include "protocols/model/face_terms.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::protocols {

/// Reads what is asked of the synthetic face, and notes every mistake.
class FaceReader {
 public:
  /// Materials are looked for in `folder`. `terms` and `findings` are borrowed.
  FaceReader(const FaceTerms& terms, std::filesystem::path folder, Findings& findings)
      : terms_{terms}, folder_{std::move(folder)}, findings_{findings} {}

  /// The key "face" of `parent`. What it leaves out is as in `usual`.
  [[nodiscard]] Face read(ObjectReader& parent, const Face& usual) const;

 private:
  [[nodiscard]] std::string read_material(ObjectReader& reader, const std::string& usual) const;
  [[nodiscard]] std::vector<std::string> read_parts(ObjectReader& reader,
                                                    std::string_view key,
                                                    const std::vector<std::string>& usual) const;
  void read_expression(ObjectReader& parent, Face& face) const;
  void read_controls(ObjectReader& parent, Face& face) const;
  [[nodiscard]] nlohmann::json without_speech_controls(nlohmann::json written,
                                                       const std::string& pointer) const;
  void judge_parts(ObjectReader& reader, const Face& face) const;
  void judge_ranges(ObjectReader& reader, const Face& face) const;

  const FaceTerms& terms_;
  std::filesystem::path folder_;
  Findings& findings_;
};

}  // namespace bimodal::protocols
