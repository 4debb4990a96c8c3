#include "analysis/report/benefit_table.hpp"

#include <fmt/format.h>

#include "analysis/report/json_count.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

std::string interval_text(const std::optional<Interval>& interval) {
  if (!interval) return {};
  return fmt::format(" [{}, {}]", print_decimals(interval->low), print_decimals(interval->high));
}

}  // namespace

std::string benefit_text(std::span<const BenefitRow> rows, std::span<const ShareRow> shares) {
  std::string text;
  for (const auto& row : rows) {
    text += fmt::format(
        "  {} against {}: A {}, AV {}{}; AV - A {}{}; (AV - A) / (1 - A) {}{}; log odds {}{}\n"
        "    n {} and {}; {}\n",
        row.bimodal,
        row.auditory,
        print_decimals(row.a),
        print_decimals(row.av),
        row.v ? fmt::format(", V {} ({})", print_decimals(row.v), row.visual) : "",
        print_decimals(row.benefit.gain),
        interval_text(row.gain_interval),
        print_decimals(row.benefit.relative),
        interval_text(row.relative_interval),
        print_decimals(row.benefit.log_odds),
        row.benefit.excess
            ? fmt::format("; above two independent chances {}", print_decimals(row.benefit.excess))
            : "",
        row.n,
        row.n_auditory,
        row.method);
  }
  for (const auto& share : shares) {
    text += fmt::format("  {} gives {}{} of the benefit of {} (over {}; {})\n",
                        share.synthetic,
                        print_decimals(share.share),
                        interval_text(share.interval),
                        share.natural,
                        share.auditory,
                        share.method);
  }
  return text.empty() ? text : "\nWhat the face adds to the voice, in words correct\n\n" + text;
}

Json benefit_json(std::span<const BenefitRow> rows) {
  Json json = Json::array();
  for (const auto& row : rows) {
    json.push_back({{"bimodal", row.bimodal},
                    {"auditory", row.auditory},
                    {"visual", row.visual.empty() ? Json() : Json(row.visual)},
                    {"participants", row.participants},
                    {"words", row.words},
                    {"n", row.n},
                    {"n_auditory", row.n_auditory},
                    {"n_visual", row.n_visual},
                    {"a", row.a},
                    {"av", row.av},
                    {"v", optional_json(row.v)},
                    {"gain", row.benefit.gain},
                    {"gain_interval", interval_json(row.gain_interval)},
                    {"relative_gain", optional_json(row.benefit.relative)},
                    {"relative_gain_interval", interval_json(row.relative_interval)},
                    {"auditory_relative_gain", optional_json(row.benefit.auditory_relative)},
                    {"log_odds_gain", optional_json(row.benefit.log_odds)},
                    {"excess_over_probability_summation", optional_json(row.benefit.excess)},
                    {"method", row.method}});
  }
  return json;
}

Json share_json(std::span<const ShareRow> shares) {
  Json json = Json::array();
  for (const auto& share : shares) {
    json.push_back({{"natural", share.natural},
                    {"synthetic", share.synthetic},
                    {"auditory", share.auditory},
                    {"participants", share.participants},
                    {"words", share.words},
                    {"share_of_natural_benefit", optional_json(share.share)},
                    {"interval", interval_json(share.interval)},
                    {"method", share.method}});
  }
  return json;
}

}  // namespace bimodal::analysis
