#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "protocols/model/protocol.hpp"
#include "protocols/reading/read_condition.hpp"
#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/corpus/corpus.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::protocols {

/// What is decided when a protocol is run, not when it is written.
struct CastOptions {
  std::map<std::string, std::filesystem::path> corpora;  ///< where a corpus of a name is
  std::vector<std::string> without;                      ///< conditions to be left out
  std::vector<std::string> with;                         ///< optional conditions to be taken in
};

/// The conditions that take place, with their talkers.
struct Cast {
  std::vector<Condition> conditions;  ///< talkers are final: where a corpus is named, it is there
  std::vector<std::string> pointers;  ///< where each is written
  std::map<std::string, Corpus> corpora;    ///< by name, those that are used
  std::vector<Diagnostic> corpus_findings;  ///< what the manifests have wrong
};

/// Chooses conditions and finds talkers. A corpus NAME is looked for where the options say, else in
/// NAME and corpora/NAME beside the protocol, then in corpora/NAME here, $BIMODAL_CORPORA/NAME and
/// ~/.local/share/bimodal/corpora/NAME. Where there is none, whoever stands in "otherwise" takes
/// its place, which is noted as a warning; where nobody does, it is an error.
[[nodiscard]] Cast cast(const std::vector<WrittenCondition>& written,
                        const std::filesystem::path& protocol_folder,
                        const CastOptions& options,
                        Findings& findings);

}  // namespace bimodal::protocols
