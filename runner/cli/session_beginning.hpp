#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runner/cli/resumption.hpp"
#include "runner/store/session_store.hpp"

namespace bimodal::runner {

/// What is stored when a session begins, or goes on.
struct Beginning {
  const SessionRecord& record;
  std::vector<PlanRecord> plan;
  const std::optional<Resumption>& resumption;
  bool is_shortened = false;    ///< by --trials or --no-practice
  const std::string& left_out;  ///< triggers; empty: none
  bool drops_repetitions = false;
  Instant at;
};

/// Stores it; returns the session's number.
[[nodiscard]] std::int64_t begin_in(SessionStore& store, const Beginning& beginning);

}  // namespace bimodal::runner
