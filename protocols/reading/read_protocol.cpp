#include "protocols/reading/read_protocol.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "protocols/reading/find_words.hpp"
#include "protocols/reading/judge_repertoire.hpp"
#include "protocols/reading/meaning.hpp"
#include "protocols/reading/structure.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/json_lines.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/obstacle.hpp"

namespace bimodal::protocols {

namespace {

/// The words that the protocol asks for, put where they belong.
void find_words(const Structure& structure, WordFinder& finder, ReadProtocol& read) {
  const std::string file = read.words.name;
  if (structure.words) {
    read.words.name =
        structure.words->list.empty() ? fmt::format("{}#/words", file) : structure.words->list;
    read.words.words = finder.find(*structure.words);
  }
  if (structure.practice) {
    read.practice = finder.find(*structure.practice);
    for (const auto& word : read.practice) read.protocol.practice.words.push_back(word.spelling);
  }
}

}  // namespace

ReadProtocol read_protocol_text(std::string text,
                                const std::filesystem::path& file,
                                const ReadOptions& options) {
  ReadProtocol read;
  read.text = std::move(text);
  read.sha256 = sha256(read.text);
  const auto parsed = parse_json(read.text);
  if (const auto* fault = std::get_if<TextFault>(&parsed)) {
    read.diagnostics.push_back(
        {Severity::Error, file.string(), fault->line, "", fault->finding, fault->remedy});
    return read;
  }
  const JsonLines lines{read.text};
  Findings findings;
  findings.refuse_duplicates(lines);
  auto structure = read_structure(std::get<nlohmann::json>(parsed), findings);
  read.protocol = structure.protocol;
  read.cast = options.cast;
  auto cast = protocols::cast(structure.conditions, file.parent_path(), options.cast, findings);
  read.protocol.conditions = cast.conditions;
  read.condition_pointers = cast.pointers;

  read.words.name = file.filename().string();
  WordFinder finder{file.parent_path(), options.dictionary, findings};
  find_words(structure, finder, read);
  judge_repertoire(cast, read.words.words, read.practice, findings);
  judge_meaning(read.protocol, read.words.words, read.practice, findings);

  read.diagnostics = cast.corpus_findings;
  const auto located = findings.located(lines, file.string());
  read.diagnostics.insert(read.diagnostics.end(), located.begin(), located.end());
  read.corpora = std::move(cast.corpora);
  const auto& of_lists = finder.list_findings();
  read.diagnostics.insert(read.diagnostics.end(), of_lists.begin(), of_lists.end());
  return read;
}

ReadProtocol read_protocol(const std::filesystem::path& file, const ReadOptions& options) {
  const auto refuse = [&file](std::string finding) {
    ReadProtocol read;
    read.diagnostics.push_back(
        {Severity::Error,
         file.string(),
         0,
         "",
         std::move(finding),
         "give the path of a protocol, e.g. protocols/library/words414.json"});
    return read;
  };
  if (const auto reason = obstacle(file)) {
    return refuse("cannot read the protocol: " + *reason);
  }
  try {
    return read_protocol_text(read_file(file), file, options);
  } catch (const Error& error) {
    return refuse(describe(error));
  }
}

}  // namespace bimodal::protocols
