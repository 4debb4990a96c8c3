#include "runner/cli/session_setup.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "runner/preparation/drawn_face.hpp"
#include "runner/store/stored_session.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

namespace {

bool is_control(char letter) {
  constexpr unsigned char kFirstPrintable = 0x20;
  constexpr unsigned char kDelete = 0x7f;
  const auto byte = static_cast<unsigned char>(letter);
  return byte < kFirstPrintable || byte == kDelete;
}

}  // namespace

int participant_number(const std::string& participant, std::optional<int> given) {
  if (participant.empty() || std::ranges::any_of(participant, is_control)) {
    throw Error{"the name of a participant must be text without line breaks; give e.g. P01"};
  }
  if (given) return *given;
  const auto last_other = participant.find_last_not_of("0123456789");
  const auto digits = participant.substr(last_other == std::string::npos ? 0 : last_other + 1);
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size() || number < 1) {
    throw Error{fmt::format(
        "cannot tell the number of participant '{}', which decides lists and orders; let the name "
        "end with a number from 1 (P01) or give --number",
        participant)};
  }
  return number;
}

std::vector<protocols::PlannedTrial> shortened_plan(const protocols::ReadProtocol& read,
                                                    protocols::SessionKey key,
                                                    const Shortening& shortening) {
  const auto whole = protocols::make_plan(read.protocol, read.words, read.practice, key);
  std::vector<protocols::PlannedTrial> plan;
  int main_trials = 0;
  for (auto trial : whole) {
    const bool is_practice = trial.phase == protocols::Phase::Practice;
    if (is_practice && !shortening.practice) continue;
    if (!is_practice && shortening.main_trials && ++main_trials > *shortening.main_trials) break;
    trial.index = plan.size();
    plan.push_back(std::move(trial));
  }
  return plan;
}

std::filesystem::path default_data_file(const std::string& protocol_named) {
  return std::filesystem::path{protocol_named}.stem().string() + ".sqlite";
}

void refuse_repetition(const std::filesystem::path& data,
                       const std::string& participant,
                       protocols::SessionKey key,
                       const protocols::ReadProtocol& read,
                       bool simulated) {
  if (!std::filesystem::exists(data) || std::filesystem::file_size(data) == 0) return;
  for (const auto& stored : read_sessions(data)) {
    const auto& session = stored.session;
    if (session.protocol_sha256 != read.sha256 || session.session_number != key.session_number) {
      continue;
    }
    if (session.participant == participant) {
      throw Error{
          fmt::format("'{}' already has session {} of participant '{}' ({}, {}{}); {}give another "
                      "--participant, "
                      "--session or --data, or --again to add one more beside it",
                      data.string(),
                      key.session_number,
                      participant,
                      counted(stored.trials.size(), "trial"),
                      stored.outcome.empty() ? "interrupted" : stored.outcome,
                      session.simulated_answers ? ", simulated" : "",
                      stored.outcome == "complete" ? "" : "go on with it by --resume, ")};
    }
    if (session.participant_number == key.participant_number &&
        session.simulated_answers == simulated) {
      throw Error{fmt::format(
          "participant '{}' would get the very lists, order and noise of '{}', who has number {} "
          "in '{}'; give a free --number, another --data, or --again if that is meant",
          participant,
          session.participant,
          key.participant_number,
          data.string())};
    }
  }
}

/// What was chosen when the protocol was read, and what it rests on beside its own text, as JSON;
/// empty if there is nothing.
std::string cast_text(const protocols::ReadProtocol& read) {
  const auto& cast = read.cast;
  nlohmann::json text;
  if (!cast.without.empty() || !cast.with.empty() || !read.corpora.empty()) {
    text = {{"without", cast.without}, {"with", cast.with}};
  }
  for (const auto& [name, corpus] : read.corpora) {
    std::error_code ignored;
    text["corpora"][name] = {{"name", corpus.name},
                             {"folder", std::filesystem::absolute(corpus.folder, ignored).string()},
                             {"manifest_sha256", corpus.sha256}};
  }
  for (const auto& condition : read.protocol.conditions) {
    if (!condition.visual_talker || protocols::is_corpus(*condition.visual_talker)) continue;
    const auto& file = condition.articulating.segments;
    auto& inventories = text["inventories"];
    const auto name = std::filesystem::path{file}.filename().string();
    if (!inventories.contains(name)) inventories[name] = synth::SegmentTable{file}.sha256();
  }
  return text.is_null() ? std::string{} : text.dump();
}

/// The phones as presented.
std::string phones_of(const protocols::ReadProtocol& read,
                      const protocols::Condition& condition,
                      const Word& word) {
  const auto& talker = condition.timing_talker;
  if (protocols::is_corpus(talker)) {
    const auto corpus = read.corpora.find(protocols::corpus_name(talker));
    const auto* const item =
        corpus == read.corpora.end() ? nullptr : find_item(corpus->second, word.spelling);
    if (item != nullptr) return spell(pronunciation_of(*item));
  }
  return spell(word.phones);
}

/// What the synthetic face looks like in each condition; empty where there is none.
std::vector<std::string> face_records(const protocols::Protocol& protocol) {
  std::vector<std::string> records;
  for (const auto& condition : protocol.conditions) {
    const bool has_face =
        condition.visual_talker && !protocols::is_corpus(*condition.visual_talker);
    records.push_back(has_face ? face_record(condition.face) : std::string{});
  }
  return records;
}

SessionRecord session_record(const protocols::ReadProtocol& read,
                             const std::string& participant,
                             protocols::SessionKey key) {
  return {.participant = participant,
          .participant_number = key.participant_number,
          .session_number = key.session_number,
          .protocol_title = read.protocol.title,
          .protocol_text = read.text,
          .protocol_sha256 = read.sha256,
          .cast = cast_text(read),
          .seed = read.protocol.seed,
          .program_version = BIMODAL_VERSION,
          .started_utc = utc_now()};
}

DeviceRecord record_of(const Display& display) {
  return {.kind = display.kind(),
          .description = display.description(),
          .time_source = std::string{name(display.time_source())}};
}

DeviceRecord record_of(const AudioOutput& audio) {
  return {.kind = audio.kind(),
          .description = audio.description(),
          .time_source = std::string{audio.time_source()}};
}

std::vector<PlanRecord> plan_records(const protocols::ReadProtocol& read,
                                     const std::vector<protocols::PlannedTrial>& plan) {
  const auto faces = face_records(read.protocol);
  std::vector<PlanRecord> records;
  records.reserve(plan.size());
  for (const auto& trial : plan) {
    const auto& condition = read.protocol.conditions.at(trial.condition);
    PlanRecord record{.trial = static_cast<int>(trial.index),
                      .phase = trial.phase == protocols::Phase::Practice ? "practice" : "main",
                      .block = trial.block,
                      .word = trial.word.spelling,
                      .phones = phones_of(read, condition, trial.word),
                      .condition = condition.name,
                      .auditory_talker = condition.auditory_talker,
                      .visual_talker = condition.visual_talker,
                      .noise_seed = trial.noise_seed};
    if (trial.word.seen && condition.visual_talker) record.visual_word = trial.word.seen->spelling;
    const auto& shown = trial.word.seen ? trial.word.seen->articulation : trial.word.articulation;
    const bool has_face =
        condition.visual_talker && !protocols::is_corpus(*condition.visual_talker);
    if (has_face && !shown.empty()) record.articulation = spell(shown);
    if (has_face) record.face = faces.at(trial.condition);
    if (condition.snr) record.snr_db = condition.snr->count();
    records.push_back(std::move(record));
  }
  return records;
}

std::string utc_now() {
  const auto now = std::time(nullptr);
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace bimodal::runner
