#include "protocols/reading/read_protocol.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "protocols/reading/find_words.hpp"
#include "protocols/reading/judge_repertoire.hpp"
#include "protocols/reading/meaning.hpp"
#include "protocols/reading/structure.hpp"
#include "stimuli/base/asset.hpp"
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

/// What to do about a text that is no JSON.
std::string remedy_of(const TextFault& fault, std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") != std::string_view::npos) return fault.remedy;
  try {
    return fmt::format("begin with a copy of {}",
                       asset("protocols/library/first-steps.json").string());
  } catch (const Error&) {
    return fault.remedy;  // the library is not installed
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
    read.diagnostics.push_back({Severity::Error,
                                file.string(),
                                fault->line,
                                "",
                                fault->finding,
                                remedy_of(*fault, read.text)});
    return read;
  }
  const JsonLines lines{read.text};
  Findings findings;
  findings.refuse_duplicates(lines);
  const FaceReader faces{options.face, file.parent_path(), findings};
  auto structure = read_structure(std::get<nlohmann::json>(parsed), faces, findings);
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
