#include "analysis/report/sinfa_table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "analysis/report/csv.hpp"
#include "analysis/report/json_count.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

bool is_chosen(const SinfaRound& round, const std::string& feature) {
  return std::ranges::find(round.chosen, feature) != round.chosen.end();
}

std::string round_text(const SinfaRound& round, std::size_t number) {
  auto text = fmt::format("round {}: {} responses\n", number, round.responses);
  std::size_t width = 0;
  for (const auto& candidate : round.candidates) {
    width = std::max(width, candidate.feature.size());
  }
  for (const auto& candidate : round.candidates) {
    text += fmt::format(
        "  {:<{}}  T {:.3f}   H {:.3f}   T/H {}{}\n",
        candidate.feature,
        width,
        candidate.transmitted,
        candidate.entropy,
        candidate.relative ? fmt::format("{:.3f}", *candidate.relative) : std::string{"-"},
        is_chosen(round, candidate.feature) ? "   held from now on" : "");
  }
  if (round.chosen.size() > 1) text += "  they tie, and are held together\n";
  return text;
}

}  // namespace

Sinfa analyse_sequentially(const ConfusionMatrix& matrix, const FeatureTable& features) {
  require_stimuli(matrix, features);
  std::vector<Feature> respects;
  for (std::size_t i = 0; i < features.features.size(); ++i) {
    respects.push_back({.name = features.features[i],
                        .of_stimuli = features.values_of(matrix.stimuli(), i),
                        .of_responses = features.values_of(matrix.responses(), i)});
  }
  return sinfa(matrix, respects);
}

std::string sinfa_text(const std::string& title, const Sinfa& sinfa) {
  auto text = fmt::format("{}: sequential information analysis (Wang & Bilger, 1973)\n", title);
  text += fmt::format("{} responses analysed, {} left out to which a feature does not apply\n\n",
                      sinfa.responses,
                      sinfa.left_out);
  for (std::size_t i = 0; i < sinfa.rounds.size(); ++i) text += round_text(sinfa.rounds[i], i + 1);
  if (!sinfa.determined.empty()) {
    text += fmt::format("determined by what is held: {}\n", fmt::join(sinfa.determined, ", "));
  }
  return text +
         "\nT: transmitted, H: entropy of the stimuli, in bits per response analysed, within the\n"
         "values of what is held. Of each round only responses that agree with their stimulus in\n"
         "that count; what drops out is not made up for. T of few responses is too large.\n";
}

std::string sinfa_csv(const Sinfa& sinfa) {
  std::string text;
  append_csv(text,
             std::vector<CsvField>{std::string_view{"round"},
                                   std::string_view{"responses"},
                                   std::string_view{"feature"},
                                   std::string_view{"transmitted_bits"},
                                   std::string_view{"entropy_bits"},
                                   std::string_view{"transmitted_relative"},
                                   std::string_view{"held_from_now_on"}});
  std::int64_t number = 0;
  for (const auto& round : sinfa.rounds) {
    ++number;
    for (const auto& candidate : round.candidates) {
      append_csv(
          text,
          std::vector<CsvField>{number,
                                round.responses,
                                std::string_view{candidate.feature},
                                candidate.transmitted,
                                candidate.entropy,
                                candidate.relative ? CsvField{*candidate.relative} : CsvField{},
                                std::int64_t{is_chosen(round, candidate.feature) ? 1 : 0}});
    }
  }
  return text;
}

std::string sinfa_json(const std::string& title, const Sinfa& sinfa) {
  Json json{{"title", title},
            {"n", json_count(sinfa.responses)},
            {"left_out", json_count(sinfa.left_out)},
            {"rounds", Json::array()},
            {"determined", sinfa.determined}};
  for (const auto& round : sinfa.rounds) {
    Json candidates = Json::array();
    for (const auto& candidate : round.candidates) {
      candidates.push_back(
          {{"feature", candidate.feature},
           {"transmitted_bits", candidate.transmitted},
           {"entropy_bits", candidate.entropy},
           {"transmitted_relative", candidate.relative ? Json(*candidate.relative) : Json()}});
    }
    json["rounds"].push_back({{"n", json_count(round.responses)},
                              {"chosen", round.chosen},
                              {"candidates", std::move(candidates)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace bimodal::analysis
