#include "analysis/report/columns.hpp"

#include <algorithm>
#include <array>

namespace bimodal::analysis {

namespace {

constexpr std::array kColumns = std::to_array<Column>({
    {"trials", "participant", "who took part, as named at the session"},
    {"trials", "session", "the participant's session number, from 1"},
    {"trials", "file", "number of the data file, from 1, in the order of manifest.json"},
    {"trials", "session_id", "number of the session within its file"},
    {"trials", "trial", "order of presentation within the session, from 0, practice included"},
    {"trials", "phase", "main or practice"},
    {"trials",
     "block",
     "a new block begins after every break; 0 is the practice if there is one (see phase)"},
    {"trials", "condition", "name of the condition in the protocol"},
    {"trials", "auditory_talker", "whose speech was heard; absent: none"},
    {"trials", "visual_talker", "whose face was seen; absent: none"},
    {"trials", "snr_db", "speech to noise level ratio in dB; absent: no noise"},
    {"trials", "word", "the stimulus: what was heard, or what was seen if nothing was heard"},
    {"trials",
     "visual_word",
     "what was seen, if it was dubbed onto another word; absent: the same"},
    {"trials",
     "articulation",
     "what the synthetic face did where sounds were ambiguous, e.g. B~W:3/8 AA; absent: none was"},
    {"trials", "phones", "the stimulus as presented, ARPAbet"},
    {"trials", "response", "the answer as typed; quoted empty for none"},
    {"trials", "answer", "the answer without case, space, punctuation and accents"},
    {"trials", "verdict", "correct, homophone, tolerated, wrong, not in dictionary, omission"},
    {"trials", "word_correct", "1 if correct, homophone or tolerated, else 0"},
    {"trials", "phones_total", "number of phones in the stimulus"},
    {"trials", "phones_correct", "of these found in the answer; absent if not in the dictionary"},
    {"trials",
     "consonant_initial_response",
     "phone answered for the initial consonant, or deleted, blank, other, ambiguous; absent: the "
     "word begins with a vowel"},
    {"trials", "vowel_response", "the same for the vowel"},
    {"trials", "consonant_final_response", "the same for the final consonant"},
    {"trials",
     "first_key_ms",
     "first key after the point that the protocol names (by default the end of the stimulus), ms; "
     "negative before it; absent: no key"},
    {"trials", "submitted_ms", "submission after that point, ms"},
    {"trials", "timed_out", "1 if the time limit ended the answer, else 0"},
    {"trials", "flagged", "1 if the timing was not as planned, else 0"},
    {"trials", "simulated", "1 if answers or time were simulated, else 0"},
    {"words", "word", "the stimulus"},
    {"words", "phones", "as presented, ARPAbet"},
    {"words", "condition", "name of the condition"},
    {"words", "trials", "number of trials"},
    {"words", "correct", "of these correct, homophones and tolerated ones included"},
    {"words", "proportion", "correct / trials"},
    {"words", "phones_judged", "phones of the stimulus over trials with answers in the dictionary"},
    {"words", "phones_correct", "of these found in the answer"},
    {"proportions", "measure", "word, phoneme, consonant-initial, vowel, consonant-final"},
    {"proportions", "condition", "name of the condition"},
    {"proportions", "scope", "pooled or participant"},
    {"proportions", "participant", "absent if pooled"},
    {"proportions", "participants", "number of participants"},
    {"proportions", "words", "number of different words"},
    {"proportions", "correct", "number correct"},
    {"proportions", "judged", "number judged: what correct is a part of"},
    {"proportions", "proportion", "correct / judged; absent if nothing was judged"},
    {"proportions", "low", "lower end of the 95 % interval; absent if there is none"},
    {"proportions", "high", "upper end of the 95 % interval; absent if there is none"},
    {"proportions", "method", "how the interval was made, or why there is none"},
    {"confusions", "condition", "name of the condition"},
    {"confusions", "unit", "consonant-initial, vowel, consonant-final"},
    {"confusions", "stimulus", "phone presented, ARPAbet"},
    {"confusions", "response", "phone answered, or deleted, blank, other"},
    {"confusions", "count", "number of trials; ambiguous alignments are left out"},
    {"confusions",
     "row_total",
     "trials of this stimulus in this condition, less ambiguous alignments"},
    {"confusions", "proportion", "count / row_total; absent if row_total is 0"},
    {"likeness", "unit", "consonant-initial, vowel, consonant-final"},
    {"likeness", "condition_1", "name of a condition"},
    {"likeness", "condition_2", "name of the other condition"},
    {"likeness", "responses_1", "number of responses in the matrix of condition_1"},
    {"likeness", "responses_2", "number of responses in the matrix of condition_2"},
    {"likeness", "cells", "off-diagonal cells compared (phones and deleted)"},
    {"likeness", "cells_not_empty", "of these with a response in either condition"},
    {"likeness", "correlation", "Pearson's r of row proportions; absent without spread"},
    {"likeness", "rms_difference", "root mean square difference of row proportions"},
    {"exclusions", "what", "trials or phones counted"},
    {"exclusions", "condition", "name of the condition; absent: all"},
    {"exclusions", "count", "how many"},
    {"columns", "table", "name of a table"},
    {"columns", "column", "name of one of its columns, in order"},
    {"columns", "meaning", "what it means. Text is in quotation marks, absent values are empty"},
});

}  // namespace

std::span<const Column> all_columns() {
  return kColumns;
}

std::span<const Column> columns_of(std::string_view table) {
  const auto is_of_table = [&](const Column& column) { return column.table == table; };
  const auto* const first = std::ranges::find_if(kColumns, is_of_table);
  const auto* const last = std::find_if_not(first, kColumns.end(), is_of_table);
  return {first, last};
}

}  // namespace bimodal::analysis
