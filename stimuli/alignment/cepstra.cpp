#include "stimuli/alignment/cepstra.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <sphinxbase/cmd_ln.h>
#include <sphinxbase/err.h>
#include <sphinxbase/fe.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kCoefficients = 13;
using StaticCepstra = std::array<float, kCoefficients>;

void take_mean_away(std::span<StaticCepstra> frames) {
  for (std::size_t i = 0; i < kCoefficients; ++i) {
    double sum = 0.0;
    for (const auto& frame : frames) sum += static_cast<double>(frame.at(i));
    const auto mean = static_cast<float>(sum / static_cast<double>(frames.size()));
    for (auto& frame : frames) frame.at(i) -= mean;
  }
}

/// Beyond either end the first or last frame goes on.
std::vector<Cepstra> with_slopes(std::span<const StaticCepstra> frames) {
  const auto last = static_cast<std::ptrdiff_t>(frames.size()) - 1;
  std::vector<Cepstra> made(frames.size());
  for (std::ptrdiff_t n = 0; n <= last; ++n) {
    const auto at = [&](std::ptrdiff_t offset, std::size_t i) {
      return frames[static_cast<std::size_t>(std::clamp(n + offset, std::ptrdiff_t{0}, last))].at(
          i);
    };
    auto& frame = made[static_cast<std::size_t>(n)];
    for (std::size_t i = 0; i < kCoefficients; ++i) {
      frame.at(i) = at(0, i);
      frame.at(kCoefficients + i) = at(2, i) - at(-2, i);
      frame.at(2 * kCoefficients + i) = (at(3, i) - at(-1, i)) - (at(1, i) - at(-3, i));
    }
  }
  return made;
}

}  // namespace

struct CepstraMaker::FrontEnd {
  struct FreeOptions {
    void operator()(cmd_ln_t* options) const { cmd_ln_free_r(options); }
  };

  struct Free {
    void operator()(fe_t* front_end) const { fe_free(front_end); }
  };

  explicit FrontEnd(const std::filesystem::path& parameters) {
    err_set_logfp(nullptr);  // it would chat on standard error
    // No frame may be left out, which would shift all that follow, and what comes must not depend
    // on what came before.
    std::unique_ptr<cmd_ln_t, FreeOptions> options{cmd_ln_init(nullptr,
                                                               fe_get_args(),
                                                               FALSE,
                                                               "-remove_silence",
                                                               "no",
                                                               "-remove_noise",
                                                               "no",
                                                               "-dither",
                                                               "no",
                                                               nullptr)};
    if (options != nullptr) {
      cmd_ln_parse_file_r(options.get(), fe_get_args(), parameters.c_str(), FALSE);
      sphinx.reset(fe_init_auto_r(options.get()));
    }
    if (!sphinx || fe_get_output_size(sphinx.get()) != static_cast<int>(kCoefficients)) {
      throw Error{
          fmt::format("setting the front end of '{}' up: SphinxBase cannot; reinstall the "
                      "Debian package pocketsphinx-en-us",
                      parameters.string())};
    }
  }

  std::unique_ptr<fe_t, Free> sphinx;
};

CepstraMaker::CepstraMaker(const std::filesystem::path& parameters)
    : front_end_{std::make_unique<FrontEnd>(parameters)} {}

CepstraMaker::~CepstraMaker() = default;
CepstraMaker::CepstraMaker(CepstraMaker&&) noexcept = default;
CepstraMaker& CepstraMaker::operator=(CepstraMaker&&) noexcept = default;

std::vector<Cepstra> CepstraMaker::make(std::span<const std::int16_t> samples) {
  auto* const sphinx = front_end_->sphinx.get();
  int shift = 0;
  int window = 0;
  fe_get_input_size(sphinx, &shift, &window);
  if (samples.size() < static_cast<std::size_t>(window)) return {};
  std::vector<StaticCepstra> frames(1 + (samples.size() - static_cast<std::size_t>(window)) /
                                            static_cast<std::size_t>(shift));
  std::vector<mfcc_t*> rows;
  for (auto& frame : frames) rows.push_back(frame.data());
  const auto* rest = samples.data();
  std::size_t left = samples.size();
  auto made = static_cast<int32>(frames.size());
  fe_start_stream(sphinx);
  fe_start_utt(sphinx);
  const int done = fe_process_frames(sphinx, &rest, &left, rows.data(), &made, nullptr);
  StaticCepstra unused{};
  int32 more = 0;
  fe_end_utt(sphinx, unused.data(), &more);
  if (done < 0 || made != static_cast<int32>(frames.size())) {
    throw Error{fmt::format("SphinxBase made {} of {} frames of sound", made, frames.size())};
  }
  take_mean_away(frames);
  return with_slopes(frames);
}

}  // namespace bimodal
