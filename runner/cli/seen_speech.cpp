#include "runner/cli/seen_speech.hpp"

#include <memory>

#include "synth/speech/score_articulation.hpp"

namespace bimodal::runner {

SeenSpeech articulated_speech(const SpokenOptions& options, Account account, bool voiced) {
  SeenSpeech seen;
  synth::Score score;
  if (voiced) {
    auto said = voiced_score(options);
    score = std::move(said.score);
    seen.sound = std::move(said.sound);
  } else {
    score = spoken_score(options);
  }
  const auto claims = synth::claims_of(score, chosen_segments(options));
  for (const auto& segment : score.segments) {
    seen.centres.push_back({segment.symbol, segment.start + segment.duration / 2});
  }
  seen.end = claims.end;
  seen.pose = [face = std::make_shared<synth::ScoreArticulation>(claims, account)](
                  Milliseconds time) { return face->at(time); };
  return seen;
}

SeenSpeech with_expressions(SeenSpeech seen, std::vector<synth::ShownExpression> shown) {
  if (shown.empty()) return seen;
  seen.pose = [plain = std::move(seen.pose), shown = std::move(shown)](Milliseconds time) {
    return synth::with_expressions(plain(time), shown);
  };
  return seen;
}

}  // namespace bimodal::runner
