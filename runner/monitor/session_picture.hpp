#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "runner/monitor/tally.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What a monitor knows of a session: the newest line of each kind that it was told. Lines come
/// from another program, of another version perhaps: what is missing in them, or is of another
/// type, is absent here. Pure.
class SessionPicture {
 public:
  /// Takes a line; returns its kind, empty if it is not one of ours.
  std::string take(std::string_view line);

  [[nodiscard]] bool knows(std::string_view kind) const;

  /// Values of the newest line of a kind; empty, absent or false where there is none.
  [[nodiscard]] std::string text(std::string_view kind, std::string_view key) const;
  [[nodiscard]] std::optional<std::int64_t> number(std::string_view kind,
                                                   std::string_view key) const;
  [[nodiscard]] std::optional<double> real(std::string_view kind, std::string_view key) const;
  [[nodiscard]] bool flag(std::string_view kind, std::string_view key) const;

  [[nodiscard]] std::vector<ConditionTally> conditions() const;
  [[nodiscard]] std::vector<TalliedTrial> latest_trials() const;  ///< oldest first

  /// Kind and detail of what flagged the last trial, "late_frame: 2 refreshes were late"; empty:
  /// nothing did.
  [[nodiscard]] std::string last_events() const;

 private:
  [[nodiscard]] const nlohmann::json* value(std::string_view kind, std::string_view key) const;

  std::map<std::string, nlohmann::json, std::less<>> newest_;
};

}  // namespace bimodal::runner
