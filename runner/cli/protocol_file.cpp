#include "runner/cli/protocol_file.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "runner/preparation/face_terms.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

std::filesystem::path find_protocol(const std::string& named) {
  const bool is_bare_name = named.find('/') == std::string::npos && !named.ends_with(".json");
  if (std::filesystem::exists(named) || !is_bare_name) return named;
  try {
    return asset("protocols/library/" + named + ".json");
  } catch (const Error&) {
    return named;  // the reader says that it is missing
  }
}

void print(std::span<const Diagnostic> diagnostics) {
  for (const auto severity : {Severity::Error, Severity::Warning}) {
    for (const auto& diagnostic : diagnostics) {
      if (diagnostic.severity == severity) fmt::print(stderr, "{}\n", describe(diagnostic));
    }
  }
}

void add_protocol_options(CLI::App& verb, ProtocolChoice& choice) {
  verb.add_option("PROTOCOL", choice.named, "a JSON file, or the name of a protocol of the library")
      ->required();
  verb.add_option("--corpus",
                  choice.corpora,
                  "NAME=FOLDER: where the corpus is that the protocol calls corpus:NAME")
      ->allow_extra_args(false)
      ->type_name("NAME=FOLDER");
  verb.add_option(
          "--without", choice.without, "leaves a condition out; the order is balanced again")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->type_name("CONDITION");
  verb.add_option("--with", choice.with, "takes an optional condition in")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->type_name("CONDITION");
}

std::optional<protocols::ReadProtocol> load_protocol(const ProtocolChoice& choice) {
  protocols::ReadOptions options{.cast = {.without = choice.without, .with = choice.with},
                                 .face = face_terms()};
  for (const auto& corpus : choice.corpora) {
    const auto equals = corpus.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw Error{
          fmt::format("--corpus '{}' does not say which corpus is meant; give NAME=FOLDER, e.g. "
                      "--corpus natural=my-talker",
                      corpus)};
    }
    const auto name = corpus.substr(0, equals);
    if (!options.cast.corpora.emplace(name, corpus.substr(equals + 1)).second) {
      throw Error{fmt::format("--corpus names '{}' twice; give one folder for each name", name)};
    }
  }
  auto read = protocols::read_protocol(find_protocol(choice.named), options);
  print(read.diagnostics);
  if (!has_errors(read.diagnostics)) return read;
  const auto errors = std::ranges::count(read.diagnostics, Severity::Error, &Diagnostic::severity);
  fmt::print(
      stderr, "bimodal: the protocol cannot be used: {} error{}\n", errors, errors == 1 ? "" : "s");
  return std::nullopt;
}

}  // namespace bimodal::runner
