#include "stimuli/alignment/phone_search.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <pocketsphinx.h>
#include <sphinxbase/err.h>
#include <sphinxbase/fsg_model.h>
#include <sys/mman.h>
#include <unistd.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

Phone modelled(Phone phone) {
  if (phone == Phone::AX) return Phone::AH;
  if (phone == Phone::WH) return Phone::W;
  return phone;
}

namespace {

constexpr const char* kInstalled = "/usr/share/pocketsphinx/model/en-us/en-us";
/// Scores of a search are in units of this many logarithms (SENSCR_SHIFT of PocketSphinx).
constexpr double kScoreUnit = 1024.0;
constexpr const char* kGiven = "given";
constexpr const char* kFree = "free";
constexpr const char* kRestWord = "<sil>";

struct FreeConfiguration {
  void operator()(cmd_ln_t* configuration) const { cmd_ln_free_r(configuration); }
};

struct FreeDecoder {
  void operator()(ps_decoder_t* decoder) const { ps_free(decoder); }
};

struct FreeGrammar {
  void operator()(fsg_model_t* grammar) const { fsg_model_free(grammar); }
};

using Configuration = std::unique_ptr<cmd_ln_t, FreeConfiguration>;
using Grammar = std::unique_ptr<fsg_model_t, FreeGrammar>;

std::string acoustic_model() {
  const char* const chosen = std::getenv("BIMODAL_ACOUSTICS");
  const std::filesystem::path folder{chosen != nullptr ? chosen : kInstalled};
  std::error_code ignored;
  for (const char* const part : {"mdef", "means", "variances", "transition_matrices"}) {
    if (std::filesystem::exists(folder / part, ignored)) continue;
    throw Error{fmt::format("loading the acoustic model of English: there is no file '{}'; {}",
                            (folder / part).string(),
                            chosen != nullptr
                                ? "correct the environment variable BIMODAL_ACOUSTICS, or unset it"
                                : "install the Debian package pocketsphinx-en-us, or set"
                                  " BIMODAL_ACOUSTICS to a folder with a PocketSphinx model")};
  }
  return folder.string();
}

/// "AH", or "+AH" at the beginning of a word: words of one phone in PocketSphinx's dictionary.
std::string name_of(const PhoneToken& token) {
  if (token.phone == Phone::Rest) return kRestWord;
  return fmt::format("{}{}", token.begins_word ? "+" : "", symbol(modelled(token.phone)));
}

PhoneToken token_of(std::string_view name) {
  if (name == kRestWord) return {};
  const bool begins = name.starts_with('+');
  const auto phone = phone_from_symbol(begins ? name.substr(1) : name);
  if (!phone) throw Error{fmt::format("PocketSphinx found '{}', which is no phone of ours", name)};
  return {*phone, begins};
}

/// A file that is nowhere on disk, and gone with this object.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view content)
      : descriptor_{::memfd_create("bimodal-phones", MFD_CLOEXEC)} {
    if (descriptor_ < 0 || ::write(descriptor_, content.data(), content.size()) !=
                               static_cast<ssize_t>(content.size())) {
      const int reason = errno;
      if (descriptor_ >= 0) ::close(descriptor_);
      throw Error{
          fmt::format("setting PocketSphinx up: cannot hold its {} bytes of dictionary in "
                      "memory: {}",
                      content.size(),
                      std::generic_category().message(reason))};
    }
  }

  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  MemoryFile(MemoryFile&&) = delete;
  MemoryFile& operator=(MemoryFile&&) = delete;

  ~MemoryFile() { ::close(descriptor_); }

  [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

/// PocketSphinx's dictionary: every phone a word of its own, twice, and what every dictionary must
/// have. As "fillers" they are modelled without context, so that a path has the same score wherever
/// it comes from.
std::string words_of_one_phone() {
  std::string text = "<s> SIL\n</s> SIL\n<sil> SIL\n";
  for (const Phone phone : all_phones()) {
    if (phone == Phone::Rest || modelled(phone) != phone) continue;
    for (const bool begins : {false, true}) {
      text += fmt::format("{} {}\n", name_of({phone, begins}), symbol(phone));
    }
  }
  return text;
}

/// Nothing is pruned that could still end well, nothing is rewarded but the fit to the sound, and
/// no frame is left out, which would shift all that follow.
Configuration configuration(const MemoryFile& dictionary) {
  const auto model = acoustic_model();
  Configuration made{cmd_ln_init(nullptr,
                                 ps_args(),
                                 TRUE,
                                 "-hmm",
                                 model.c_str(),
                                 "-dict",
                                 "/dev/null",
                                 "-fdict",
                                 dictionary.path().c_str(),
                                 "-remove_silence",
                                 "no",
                                 "-remove_noise",
                                 "no",
                                 "-dither",
                                 "no",  // its random numbers are shared by all threads
                                 "-cmn",
                                 "batch",
                                 "-fsgusefiller",
                                 "no",
                                 "-fsgusealtpron",
                                 "no",
                                 "-bestpath",
                                 "no",
                                 "-beam",
                                 "1e-120",
                                 "-pbeam",
                                 "1e-120",
                                 "-wbeam",
                                 "1e-120",
                                 "-lw",
                                 "1.0",
                                 "-wip",
                                 "1.0",
                                 "-pip",
                                 "1.0",
                                 nullptr)};
  if (!made) throw Error{"setting PocketSphinx up: it does not know our options; use 5prealpha"};
  return made;
}

PhoneGrammar any_phones() {
  PhoneGrammar loop{.states = 2, .arcs = {{.from = 0, .to = 1, .token = {}}}};
  for (const Phone phone : all_phones()) {
    if (modelled(phone) == phone) loop.arcs.push_back({0, 0, PhoneToken{phone, false}});
  }
  return loop;
}

}  // namespace

struct PhoneSearch::Decoder {
  Decoder() {
    err_set_logfp(nullptr);  // it would chat on standard error
    const MemoryFile dictionary{words_of_one_phone()};
    const auto options = configuration(dictionary);
    decoder.reset(ps_init(options.get()));
    if (!decoder) {
      throw Error{
          fmt::format("loading the acoustic model '{}': PocketSphinx cannot use it; "
                      "reinstall the Debian package pocketsphinx-en-us",
                      cmd_ln_str_r(options.get(), "-hmm"))};
    }
    use(any_phones(), kFree);
  }

  void use(const PhoneGrammar& grammar, const char* name) {
    Grammar made{fsg_model_init(
        name, ps_get_logmath(decoder.get()), 1.0F, static_cast<int32>(grammar.states) + 1)};
    made->start_state = 0;
    made->final_state = static_cast<int32>(grammar.states) - 1;
    for (const auto& [from, to, token] : grammar.arcs) {
      if (token) {
        fsg_model_trans_add(made.get(),
                            static_cast<int32>(from),
                            static_cast<int32>(to),
                            0,
                            fsg_model_word_add(made.get(), name_of(*token).c_str()));
      } else {
        fsg_model_null_trans_add(made.get(), static_cast<int32>(from), static_cast<int32>(to), 0);
      }
    }
    {
      const auto aside = static_cast<int32>(grammar.states);
      fsg_model_null_trans_add(made.get(), 0, aside, 0);
      for (const auto& arc : any_phones().arcs) {
        if (arc.token)
          fsg_model_trans_add(made.get(),
                              aside,
                              aside,
                              0,
                              fsg_model_word_add(made.get(), name_of(*arc.token).c_str()));
      }
    }
    glist_free(fsg_model_null_trans_closure(made.get(), nullptr));
    if (ps_set_fsg(decoder.get(), name, made.get()) < 0) {
      throw Error{fmt::format("PocketSphinx cannot use a grammar of {} states", grammar.states)};
    }
  }

  std::vector<FoundPhone> run(const char* name, std::span<const std::int16_t> samples) {
    auto* const ps = decoder.get();
    if (ps_set_search(ps, name) < 0 || ps_start_utt(ps) < 0) {
      throw Error{"PocketSphinx cannot begin to search"};
    }
    const int done = ps_process_raw(ps, samples.data(), samples.size(), FALSE, TRUE);
    if (ps_end_utt(ps) < 0 || done < 0) throw Error{"PocketSphinx has failed in its search"};
    return path();
  }

  std::vector<FoundPhone> path() {
    std::vector<FoundPhone> found;
    const double unit = kScoreUnit * std::log(logmath_get_base(ps_get_logmath(decoder.get())));
    for (auto* part = ps_seg_iter(decoder.get()); part != nullptr; part = ps_seg_next(part)) {
      const std::string_view word{ps_seg_word(part)};
      if (word == "(NULL)") continue;
      int first = 0;
      int last = 0;
      int32 acoustic = 0;
      ps_seg_frames(part, &first, &last);
      ps_seg_prob(part, &acoustic, nullptr, nullptr);
      found.push_back({.token = token_of(word),
                       .first_frame = static_cast<std::size_t>(first),
                       .frames = static_cast<std::size_t>(last - first + 1),
                       .log_likelihood = acoustic * unit});
    }
    return found;
  }

  std::unique_ptr<ps_decoder_t, FreeDecoder> decoder;
};

PhoneSearch::PhoneSearch() : decoder_{std::make_unique<Decoder>()} {}

PhoneSearch::~PhoneSearch() = default;
PhoneSearch::PhoneSearch(PhoneSearch&&) noexcept = default;
PhoneSearch& PhoneSearch::operator=(PhoneSearch&&) noexcept = default;

std::vector<FoundPhone> PhoneSearch::best_path(const PhoneGrammar& grammar,
                                               std::span<const std::int16_t> samples) {
  decoder_->use(grammar, kGiven);
  return decoder_->run(kGiven, samples);
}

std::vector<FoundPhone> PhoneSearch::free_path(std::span<const std::int16_t> samples) {
  return decoder_->run(kFree, samples);
}

}  // namespace bimodal
