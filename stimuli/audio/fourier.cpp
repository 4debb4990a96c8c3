#include "stimuli/audio/fourier.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <new>
#include <utility>

#include <kissfft/kiss_fftr.h>

namespace bimodal {

namespace {

using Plan =
    std::unique_ptr<kiss_fftr_state, decltype([](kiss_fftr_state* p) { kiss_fftr_free(p); })>;

bool is_fast(std::size_t length) {
  for (const std::size_t factor : {2U, 3U, 5U}) {
    while (length % factor == 0) length /= factor;
  }
  return length == 1;
}

constexpr std::size_t kKeptPlans = 32;  ///< of up to a megabyte each

// std::complex<float> is laid out as float[2] by the standard, kiss_fft_cpx is struct {r, i}.
static_assert(sizeof(kiss_fft_cpx) == sizeof(std::complex<float>));

}  // namespace

std::size_t fast_length(std::size_t samples) {
  std::size_t half = std::max<std::size_t>((samples + 1) / 2, 1);
  while (!is_fast(half)) ++half;
  return 2 * half;
}

std::size_t common_fast_length(std::size_t samples) {
  constexpr std::size_t kLong = 16384;
  constexpr std::size_t kUnit = 2048;
  if (samples <= kLong) return fast_length(samples);
  std::size_t units = (samples + kUnit - 1) / kUnit;
  while (!is_fast(units)) ++units;
  return kUnit * units;
}

struct FourierTransform::Plans {
  std::map<std::pair<std::size_t, bool>, Plan> plans;  // by length and whether inverse
  std::vector<float> signal;
  std::vector<std::complex<float>> bins;

  kiss_fftr_cfg plan(std::size_t length, bool inverse) {
    if (plans.size() >= kKeptPlans && !plans.contains({length, inverse})) plans.clear();
    auto& found = plans[{length, inverse}];
    if (!found) {
      found.reset(kiss_fftr_alloc(static_cast<int>(length), inverse ? 1 : 0, nullptr, nullptr));
      if (!found) throw std::bad_alloc{};
    }
    return found.get();
  }
};

FourierTransform::FourierTransform() : plans_{std::make_unique<Plans>()} {}

FourierTransform::FourierTransform(FourierTransform&&) noexcept = default;
FourierTransform& FourierTransform::operator=(FourierTransform&&) noexcept = default;
FourierTransform::~FourierTransform() = default;

std::span<const std::complex<float>> FourierTransform::forward(std::span<const float> signal) {
  const auto length = fast_length(signal.size());
  plans_->signal.assign(length, 0.0F);
  std::ranges::copy(signal, plans_->signal.begin());
  plans_->bins.resize(length / 2 + 1);
  kiss_fftr(plans_->plan(length, false),
            plans_->signal.data(),
            reinterpret_cast<kiss_fft_cpx*>(plans_->bins.data()));
  return plans_->bins;
}

std::span<std::complex<float>> FourierTransform::empty_spectrum(std::size_t length) {
  assert(fast_length(length) == length);
  plans_->bins.assign(length / 2 + 1, {});
  return plans_->bins;
}

std::span<float> FourierTransform::inverse() {
  assert(plans_->bins.size() >= 2);
  const auto length = 2 * (plans_->bins.size() - 1);
  plans_->signal.resize(length);
  kiss_fftri(plans_->plan(length, true),
             reinterpret_cast<const kiss_fft_cpx*>(plans_->bins.data()),
             plans_->signal.data());
  return plans_->signal;
}

}  // namespace bimodal
