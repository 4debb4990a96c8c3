#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocols/reading/read_protocol.hpp"
#include "runner/preparation/face_quality.hpp"
#include "runner/preparation/preparation_queue.hpp"
#include "runner/preparation/repertoire.hpp"

namespace bimodal::runner {

/// What preparing a session borrows, and how it goes about it.
struct SessionPreparation {
  const protocols::ReadProtocol& read;
  const std::string& named;  ///< the protocol, in messages
  const std::vector<protocols::PlannedTrial>& plan;
  Repertoire& repertoire;
  Hertz drawing_rate;
  ChosenQuality quality;
  bool keeps_films = true;                   ///< from session to session
  void (*tell)(std::string_view) = nullptr;  ///< how far drawing ahead is
};

/// Prepares on the queue's thread: first every sound of the session is made and judged; then, if
/// the face cannot be drawn as fast as trials follow each other, all films are drawn; then trial
/// after trial is mixed and drawn. Throws Error if a sound cannot be made or would clip.
[[nodiscard]] PreparationQueue::Prepare prepare_session(const SessionPreparation& session);

}  // namespace bimodal::runner
