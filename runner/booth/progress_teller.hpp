#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "runner/booth/booth.hpp"
#include "runner/booth/oversight.hpp"
#include "runner/booth/session_health.hpp"

namespace bimodal::runner {

/// Tells whoever watches how the session goes on. Nothing here is called while a stimulus is on.
class ProgressTeller {
 public:
  /// All borrowed.
  ProgressTeller(const Booth& booth, Oversight& oversight) : booth_{booth}, oversight_{oversight} {}

  void page(const std::string& text, bool is_break);

  /// `of`: trials of the session.
  void reached(const protocols::PlannedTrial& trial, std::size_t of, TrialState state);

  /// The trial has been answered; it is told by stored(), but its record may go before.
  /// `underflows`: during its sound. `trial` must live until then.
  void answered(const protocols::PlannedTrial& trial,
                const TrialRecord& record,
                std::int64_t underflows);

  /// How long after its last stroke an answer was on the disk.
  void note_storing(Duration delay) { health_.note_storing(delay); }

  void stored(std::size_t of);

  /// `outcome`: as in SessionEnded.
  void ended(std::string_view outcome);
  void failed(const std::string& why);

 private:
  void tell_health();

  const Booth& booth_;
  Oversight& oversight_;
  SessionHealth health_;
  std::optional<TrialResult> answered_;
};

}  // namespace bimodal::runner
