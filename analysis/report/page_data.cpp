#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/page_parts.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

std::string simulated_banner(const Dataset& dataset) {
  std::int64_t sessions = 0;
  std::int64_t simulated = 0;
  std::set<std::string> observers;
  for (const auto& session : dataset.sessions) {
    if (session.analysed_trials == 0) continue;
    ++sessions;
    if (!session.simulated) continue;
    ++simulated;
    if (!session.observer.empty()) observers.insert(session.observer);
  }
  if (simulated == 0) return {};
  return fmt::format(
      "<div class='simulated'><strong>SIMULATED</strong><br/>{} of {} sessions {} simulated{}; "
      "{} "
      "numbers below say {} about people.</div>\n",
      simulated,
      sessions,
      simulated == 1 ? "was" : "were",
      observers.empty()
          ? std::string{}
          : fmt::format(" (observer: {})", escaped(fmt::format("{}", fmt::join(observers, ", ")))),
      simulated == sessions ? "the" : "these mixed",
      simulated == sessions ? "nothing" : "little");
}

/// "full (measured)".
std::string face_of(const SessionSummary& session) {
  if (session.face_quality.empty()) return "&#8211;";
  return escaped(fmt::format("{} ({})", session.face_quality, session.face_quality_basis));
}

std::string rows_of_sessions(const Dataset& dataset) {
  std::string rows;
  for (const auto& session : dataset.sessions) {
    rows += fmt::format(
        "<tr><td>{}</td><td class='number'>{}</td><td class='number'>{}</td><td>{}</td>"
        "<td>{}{}</td><td>{}</td><td class='number'>{} / {}</td><td class='number'>{}</td>"
        "<td class='number'>{}</td></tr>\n",
        escaped(session.participant),
        session.session_number,
        session.file + 1,
        escaped(session.started_utc),
        escaped(session.outcome),
        session.simulated ? ", <b>SIMULATED</b>" : "",
        face_of(session),
        session.stored_trials,
        session.planned_trials,
        session.analysed_trials,
        session.flagged_trials ? fmt::format("{}", *session.flagged_trials) : "&#8211;");
  }
  return rows;
}

std::string rows_of_exclusions(const Dataset& dataset) {
  std::string rows =
      fmt::format("<tr><td>Stored</td><td class='number'>{}</td></tr>\n", dataset.stored_trials);
  for (const auto& exclusion : dataset.exclusions) {
    rows += fmt::format("<tr><td>Left out: {}</td><td class='number'>{}</td></tr>\n",
                        escaped(exclusion.reason),
                        exclusion.trials);
  }
  return rows + fmt::format("<tr class='first'><td>Analysed</td><td class='number'>{}</td></tr>\n",
                            dataset.trials.size());
}

}  // namespace

std::string part_of_warnings(const Results& results) {
  std::string part = simulated_banner(results.dataset);
  if (results.warnings.empty()) return part;
  part += "<div class='warnings'><h2>Before you read the numbers</h2><ul>\n";
  for (const auto& warning : results.warnings) {
    part += fmt::format("<li>{}</li>\n", escaped(warning));
  }
  return part + "</ul></div>\n";
}

std::string part_of_data(const Results& results) {
  const auto& dataset = results.dataset;
  return fmt::format(
      "<h2 id='data'>Data</h2>\n<h3>Trials</h3>\n<table><tbody>{}</tbody></table>\n"
      "<h3>Sessions</h3>\n<table><thead><tr>"
      "<th scope='col'>Participant</th><th scope='col' class='number'>Session</th><th scope='col' "
      "class='number'>File</th>"
      "<th scope='col'>Started (UTC)</th><th scope='col'>Outcome</th><th scope='col'>Face "
      "drawn</th>"
      "<th scope='col' class='number'>Stored / planned</th>"
      "<th scope='col' class='number'>Analysed</th><th scope='col' "
      "class='number'>Flagged</th></tr></thead>\n"
      "<tbody>{}</tbody></table>\n<p class='note'>Stored and planned trials include practice. "
      "Flagged: the timing was not as planned; &#8211;: the data do not say. Face drawn: how "
      "finely, and why: the protocol says "
      "so, "
      "it was measured that the machine keeps ahead of the session, or nobody looked (unwatched); "
      "&#8211;: no synthetic face was drawn, or it is not known.</p>\n",
      rows_of_exclusions(dataset),
      rows_of_sessions(dataset));
}

std::string part_of_attachments(std::span<const Attachment> attachments) {
  if (attachments.empty()) return {};
  std::string part = "<h2 id='trial'>The stimulus of one trial</h2>\n<div class='trial'>\n";
  for (const auto& attachment : attachments) {
    const auto source =
        fmt::format("data:{};base64,{}", attachment.media_type, base64(attachment.bytes));
    const auto caption = escaped(attachment.caption);
    part += attachment.kind == Attachment::Kind::Picture
                ? fmt::format("<figure><img src='{}' alt='{}'/>", source, caption)
                : fmt::format("<figure><audio controls='controls' src='{}'></audio>", source);
    part += fmt::format("<figcaption>{}</figcaption></figure>\n", caption);
  }
  return part + "</div>\n";
}

namespace {

/// What makes an answer correct that is not the word as spelled, up to the full stop.
std::string correct_besides(const ScoringRules& rules) {
  std::vector<std::string_view> tolerated;
  for (const Tolerance tolerance : kTolerances) {
    if (rules.tolerates(tolerance)) tolerated.push_back(name(tolerance));
  }
  return fmt::format(
      "{}{}.",
      rules.homophones ? ", or if any pronunciation that the dictionary gives for it is what was "
                         "presented (homophone)"
                       : "; homophones are wrong",
      tolerated.empty() ? std::string{}
                        : fmt::format("; tolerated besides: {}", fmt::join(tolerated, ", ")));
}

}  // namespace

std::string part_of_methods(const Results& results) {
  return fmt::format(
      R"(<h2 id="methods">How it was computed</h2>
<dl>
<dt>Words</dt><dd>Case, space, punctuation and accents are ignored. An answer is correct if it is the
word{} An answer with nothing left is blank, an omission.</dd>
<dt>Phonemes</dt><dd>The answer&#8217;s pronunciation is aligned with the phones presented at least
cost: {}, vowels stand only against vowels and consonants
against consonants; among equal costs the alignment with most matches. The pronunciation of least cost
is taken. {} {} All phones of a correct word are correct.</dd>
<dt>Units</dt><dd>Initial consonant: the first phone, if a consonant (in a cluster, its first). Vowel:
the first. Final consonant: the last phone, if a consonant.</dd>
<dt>Intervals</dt><dd>95&#160;%. Pooled: crossed bootstrap. Participants and words are drawn anew with
replacement, independently, {} times (seed {}); a cell counts as often as its participant times its
word was drawn; percentiles of the proportions. It errs on the wide side (Owen, 2007, <i>Annals of
Applied Statistics 1</i>, 386&#8211;411): in simulated experiments of 20 participants, 60 words and three
conditions it held the true value in 98&#160;% of 300, where an interval for independent trials (Wilson) held
it in 77&#160;%. One participant: Wilson&#8217;s score interval, which speaks of that participant only.
No interval is given for pooled answers, or one participant&#8217;s phonemes, of which all or none were correct.</dd>
</dl>
)",
      correct_besides(results.rules),
      results.rules.costs == AlignmentCosts::Unit
          ? "substitution, deletion and insertion cost 1 each"
          : "substitution costs the share of phonetic features in which the two phones differ, "
            "deletion and insertion cost 1 each",
      results.rules.out_of_dictionary == OutOfDictionary::LeftOut
          ? "Answers that the dictionary lacks are left out of phoneme scores, and stand as "
            "<i>other</i> in matrices."
          : "Answers that the dictionary lacks are said by letter-to-sound rules (Elovitz et al., "
            "1976).",
      results.rules.ties == TieRule::LeftOut
          ? "Where equally good alignments disagree about a phone, that phone is <i>ambiguous</i> "
            "and left out of its matrix, with its count in the caption."
          : "In matrices equally good alignments weigh the same, so that a response may count in "
            "parts.",
      results.bootstrap.draws,
      results.bootstrap.seed);
}

}  // namespace bimodal::analysis
