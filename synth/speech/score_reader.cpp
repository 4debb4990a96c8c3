#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/located_reading.hpp"
#include "stimuli/base/nearest.hpp"
#include "stimuli/base/object_reader.hpp"
#include "synth/speech/score.hpp"

namespace bimodal::synth {

namespace {

using nlohmann::json;

constexpr std::size_t kMostSegments = 100'000;
constexpr std::size_t kMostValuesOfAScore = 4'000'000;
constexpr double kLongestMs = 3'600'000;
constexpr double kSmallest = 1e-9;

constexpr NumberRule kDuration{kSmallest, kLongestMs, "a duration in ms above 0, e.g. 120"};
constexpr NumberRule kStart{0, kLongestMs, "the time in ms since the start of the utterance"};
constexpr NumberRule kTarget{-1e9, 1e9, "the control's value, in its own unit"};
constexpr NumberRule kAlpha{kSmallest, 1e6, "the height of the dominance, above 0, e.g. 1"};
constexpr NumberRule kTheta{0, 1e3, "a rate in 1/ms, e.g. 0.035"};
constexpr NumberRule kExponent{0.05, 10, "the power of the distance, usually 1"};
constexpr NumberRule kOffset{-10'000, 10'000, "ms from the segment's centre to its peak, e.g. -13"};
constexpr NumberRule kInflection{0, 10'000, "ms before the centre, e.g. 68"};
constexpr NumberRule kRank{1, 10, "a rank of deformability from 1 (the least) to 10"};

/// One name for every way to write a symbol: "s" and "S" are the same phone.
std::string canonical(const std::string& written) {
  const auto parsed = parse_segment(written);
  const auto* const segment = std::get_if<Segment>(&parsed);
  return segment == nullptr ? written : symbol(*segment);
}

constexpr TextRule kSymbol{1, 40, true, "a symbol, e.g. \"S\""};
constexpr TextRule kControlName{1, 60, true, "the name of a control, e.g. \"lip_protrusion\""};
constexpr std::array<std::string_view, 2> kForms{"exponential", "critically damped"};

class ScoreReader {
 public:
  explicit ScoreReader(Findings& findings) : findings_{findings} {}

  Score read(const json& root) {
    ObjectReader reader{root, "", findings_};
    static_cast<void>(reader.find("about"));
    // What `tracks --json` writes is a score, too: what was sampled is passed over.
    const bool is_sampled =
        root.is_object() && root.contains("rate_hz") && root.contains("time_ms");
    for (const auto key : {"rate_hz", "time_ms", "controls", "dominance"}) {
      if (is_sampled) static_cast<void>(reader.find(key));
    }
    read_definitions(reader);
    reader.require("segments",
                   "the list of segments, e.g. [{\"symbol\": \"S\", \"duration_ms\": 140}]");
    for (const auto& [value, pointer] : reader.items("segments", 1, kMostSegments)) {
      read_segment(*value, pointer);
    }
    reader.refuse_unknown_keys();
    refuse_unknown_symbols();
    warn_of_mistyped_controls();
    warn_of_unused_definitions();
    return std::move(score_);
  }

 private:
  void read_definitions(ObjectReader& reader) {
    const auto* const definitions = reader.find("definitions");
    if (definitions == nullptr) return;
    const auto pointer = reader.pointer_to("definitions");
    const ObjectReader judged{*definitions, pointer, findings_};  // notes it if it is no object
    if (!definitions->is_object()) return;
    for (const auto& [symbol, controls] : definitions->items()) {
      const auto at = pointer + "/" + escape_pointer(symbol);
      if (!definitions_.emplace(canonical(symbol), read_controls(controls, at)).second) {
        findings_.error(at, "the same symbol is defined already", "keep one of them");
      }
    }
  }

  void read_segment(const json& value, const std::string& pointer) {
    ObjectReader reader{value, pointer, findings_};
    ScoreSegment segment;
    reader.require("symbol", "what is articulated, e.g. \"S\"");
    reader.require("duration_ms", "how long, e.g. 140");
    segment.symbol = reader.text("symbol", kSymbol).value_or("");
    const auto parsed = parse_segment(segment.symbol);
    if (const auto* known = std::get_if<Segment>(&parsed)) segment.segment = *known;
    segment.duration = Milliseconds{reader.number("duration_ms", kDuration).value_or(1)};
    const Milliseconds earliest = score_.end();
    segment.start = earliest;
    if (const auto start = reader.number("start_ms", kStart)) segment.start = Milliseconds{*start};
    if (segment.start < earliest - kRounding) {
      findings_.error(reader.pointer_to("start_ms"),
                      fmt::format("the segment starts at {} ms, before the one before it ends ({} "
                                  "ms): they overlap",
                                  segment.start.count(),
                                  earliest.count()),
                      "give a later start, shorten the segment before, or leave start_ms out");
      segment.start = earliest;
    }
    const auto rank = reader.whole("rank", kRank);
    if (rank) segment.rank = static_cast<int>(*rank);
    const auto defined = definitions_.find(canonical(segment.symbol));
    if (defined != definitions_.end()) segment.controls = defined->second;
    if (const auto* controls = reader.find("controls")) {
      for (auto& [name, asked] : read_controls(*controls, reader.pointer_to("controls"))) {
        segment.controls[name] = asked;
      }
    }
    reader.refuse_unknown_keys();
    score_.segments.push_back(std::move(segment));
    pointers_.push_back(pointer);
  }

  NamedTargets read_controls(const json& value, const std::string& pointer) {
    NamedTargets controls;
    ObjectReader reader{value, pointer, findings_};
    if (!value.is_object()) return controls;
    for (const auto& [name, asked] : value.items()) {
      const auto at = pointer + "/" + escape_pointer(name);
      if (!reader.text_of(name, at, kControlName)) continue;
      if (name == "time_ms" || name.find('@') != std::string::npos) {
        findings_.error(at,
                        "the name is kept for a column of the tracks",
                        "choose another, which has no \"@\"");
      }
      controls[name] = read_target(asked, at);
    }
    return controls;
  }

  SegmentTarget read_target(const json& value, const std::string& pointer) {
    ObjectReader reader{value, pointer, findings_};
    for (const auto key : {"target", "theta_before_per_ms", "theta_after_per_ms"}) {
      reader.require(key, "a number");
    }
    SegmentTarget asked{.target_source = "the score", .dynamics_source = "the score"};
    auto& dominance = asked.dominance;
    asked.target = reader.number("target", kTarget).value_or(0);
    dominance.alpha = reader.number("alpha", kAlpha).value_or(1);
    dominance.theta_before = reader.number("theta_before_per_ms", kTheta).value_or(0);
    dominance.theta_after = reader.number("theta_after_per_ms", kTheta).value_or(0);
    dominance.exponent = reader.number("exponent", kExponent).value_or(1);
    asked.offset = Milliseconds{reader.number("offset_ms", kOffset).value_or(0)};
    if (reader.choice("form", kForms) == 1) dominance.form = DominanceForm::CriticallyDamped;
    read_inflection(reader, dominance);
    reader.refuse_unknown_keys();
    return asked;
  }

  void read_inflection(ObjectReader& reader, Dominance& dominance) {
    const auto inflection = reader.number("inflection_ms", kInflection);
    const auto theta = reader.number("theta_early_per_ms", kTheta);
    if (!inflection && !theta) return;
    if (!reader.has("inflection_ms") || !reader.has("theta_early_per_ms")) {
      findings_.error(reader.pointer(),
                      "\"inflection_ms\" and \"theta_early_per_ms\" do not stand together",
                      "give both: the rate is theta_early_per_ms earlier than inflection_ms before "
                      "the centre");
      return;
    }
    if (dominance.exponent != 1) {
      findings_.error(reader.pointer_to("exponent"),
                      "a dominance that changes its rate has another exponent than 1",
                      "leave \"exponent\" or the inflection out");
      return;
    }
    dominance.inflection_ms = inflection.value_or(0);
    dominance.theta_early = theta.value_or(0);
  }

  void warn_of_unused_definitions() {
    std::set<std::string, std::less<>> used;
    for (const auto& segment : score_.segments) used.insert(canonical(segment.symbol));
    std::vector<std::string> idle;
    for (const auto& [name, ignored] : definitions_) {
      if (!used.contains(name)) idle.push_back(name);
    }
    if (idle.empty()) return;
    findings_.warning("/definitions",
                      fmt::format("no segment is {}", fmt::join(idle, ", ")),
                      "if none of them is mistyped, never mind");
  }

  /// Controls may have any name; but one that is nearly that of the face is likely to be meant so.
  void warn_of_mistyped_controls() {
    std::vector<std::string_view> known;
    for (const auto& row : controls()) known.push_back(row.name);
    std::set<std::string, std::less<>> told;
    for (std::size_t i = 0; i < score_.segments.size(); ++i) {
      for (const auto& [name, ignored] : score_.segments[i].controls) {
        if (control_from_name(name) || !told.insert(name).second) continue;
        const auto near = nearest(name, known);
        if (!near) continue;
        findings_.warning(pointers_[i],
                          fmt::format("\"{}\" is no control of the face", name),
                          fmt::format("did you mean \"{}\"? Otherwise never mind: it is a "
                                      "control of the score's own",
                                      *near));
      }
    }
  }

  void refuse_unknown_symbols() {
    for (std::size_t i = 0; i < score_.segments.size(); ++i) {
      const auto& segment = score_.segments[i];
      if (segment.segment || !segment.controls.empty() || segment.symbol.empty()) continue;
      findings_.error(pointers_[i] + "/symbol",
                      std::get<SegmentFault>(parse_segment(segment.symbol)).finding,
                      "write an ARPAbet symbol, \"B~W:3/8\", or give the segment \"controls\" of "
                      "its own");
    }
  }

  /// Starts that were added up elsewhere may differ in the last digits.
  static constexpr Milliseconds kRounding{1e-6};

  Findings& findings_;
  Score score_;
  std::map<std::string, NamedTargets, std::less<>> definitions_;
  std::vector<std::string> pointers_;
};

}  // namespace

std::optional<Score> parse_score(std::string_view text,
                                 std::string_view file,
                                 std::vector<Diagnostic>& diagnostics) {
  return read_located(
      text, file, diagnostics, kMostValuesOfAScore, [](const json& tree, Findings& findings) {
        return ScoreReader{findings}.read(tree);
      });
}

Score read_score(const std::string& file, std::vector<Diagnostic>& warnings) {
  std::vector<Diagnostic> diagnostics;
  auto score = parse_score(read_file(file), file, diagnostics);
  if (!score) {
    std::string message = fmt::format("cannot use the score '{}':", file);
    for (const auto& diagnostic : diagnostics) message += "\n  " + describe(diagnostic);
    throw Error{message};
  }
  warnings.insert(warnings.end(), diagnostics.begin(), diagnostics.end());
  return *std::move(score);
}

}  // namespace bimodal::synth
