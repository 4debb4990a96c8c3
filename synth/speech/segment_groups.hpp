#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "stimuli/base/findings.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// Reads the groups of one file into a table that may be filled already. Every step notes what is
/// wrong and goes on with what remains.
class SegmentGroups {
 public:
  /// All three are borrowed.
  SegmentGroups(SegmentTargets& targets,
                const std::map<std::string, std::string>& sources,
                Findings& findings)
      : targets_{targets}, sources_{sources}, findings_{findings} {}

  /// `pointer` is that of the group.
  void read(const nlohmann::json& group, const std::string& pointer);

  [[nodiscard]] const std::set<std::string>& used_sources() const { return used_sources_; }

  [[nodiscard]] const std::set<std::pair<Phone, Control>>& set() const { return set_; }

 private:
  struct Columns {
    std::vector<std::string> further;  ///< of dynamics, beyond those that each group has
    std::vector<Control> controls;
    DominanceForm form = DominanceForm::Exponential;

    [[nodiscard]] std::size_t count() const;
  };

  DominanceForm read_form(const nlohmann::json& group, const std::string& pointer);
  Columns read_columns(const nlohmann::json& group, const std::string& pointer);
  void read_row(const std::string& segments,
                const nlohmann::json& row,
                const std::string& pointer,
                const Columns& columns);
  void read_further(const nlohmann::json& row,
                    const std::string& pointer,
                    const Columns& columns,
                    Dominance& dominance);
  std::vector<Phone> read_segments(const std::string& segments, const std::string& pointer);
  double number(const nlohmann::json& row, std::size_t column, const std::string& pointer);
  void positive(double number, std::size_t column, const std::string& pointer);
  std::string source(const nlohmann::json& row, std::size_t column, const std::string& pointer);
  void set(Phone phone, Control control, const SegmentTarget& asked, const std::string& pointer);

  SegmentTargets& targets_;
  const std::map<std::string, std::string>& sources_;
  Findings& findings_;
  std::set<std::string> used_sources_;
  std::set<Control> grouped_;
  std::set<std::pair<Phone, Control>> set_;
};

}  // namespace bimodal::synth
