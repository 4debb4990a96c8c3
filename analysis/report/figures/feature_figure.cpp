#include "analysis/report/figures/feature_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/report/figures/colours.hpp"
#include "analysis/report/figures/legend.hpp"
#include "analysis/report/figures/share_axis.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kLetters = 8.0;
constexpr double kNumbers = 7.0;
constexpr double kBar = 7.5;    ///< outlined, as observed
constexpr double kInner = 4.5;  ///< filled, as corrected
constexpr double kRow = 9.5;
constexpr double kFeatureGap = 5.0;

std::string print(const std::optional<double>& share) {
  if (!share) return "\u2013";
  return (*share < 0.0 ? "\u2212" : "") + print_proportion(std::abs(*share));
}

/// ".61 (.64)": corrected, then as observed.
std::string print(const FeatureShare& share) {
  return share.observed ? fmt::format("{} ({})", print(share.miller_madow), print(share.observed))
                        : "\u2013";
}

std::string describe(std::span<const FeatureProfile> profiles) {
  std::string text = "T / H corrected by Miller and Madow's formula (as observed). ";
  for (const auto& profile : profiles) {
    text += profile.condition + ":";
    for (const auto& share : profile.shares) {
      text += fmt::format(" {} {},", share.feature, print(share));
    }
    text.back() = '.';
    text += ' ';
  }
  text.pop_back();
  return text;
}

class Painter {
 public:
  Painter(Svg& svg, std::span<const FeatureProfile> profiles) : svg_{svg}, profiles_{profiles} {
    double names = 0.0;
    double numbers = 0.0;
    for (const auto& profile : profiles) {
      for (const auto& share : profile.shares) {
        names = std::max(names, width_of(share.feature, kLetters));
        numbers = std::max(numbers, width_of(print(share), kNumbers));
        for (const auto& value : {share.observed, share.miller_madow}) {
          axis_.low = std::min(axis_.low, value.value_or(0.0));
          axis_.high = std::max(axis_.high, value.value_or(0.0));
        }
      }
    }
    axis_.left = names + 6.0;
    axis_.width = svg.width() - axis_.left - numbers - 8.0;
  }

  double paint() {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < profiles_.size(); ++i) {
      entries.push_back({profiles_[i].condition, series_colour(i), Mark::Square});
    }
    const double top = profiles_.size() > 1 ? paint_legend(svg_, entries, axis_.left, 0.0) : 3.0;
    const auto features = profiles_.empty() ? 0 : profiles_.front().shares.size();
    const double block = kRow * static_cast<double>(profiles_.size()) + kFeatureGap;
    const double bottom = paint_axis(svg_,
                                     axis_,
                                     "part of the feature's information transmitted, T / H",
                                     top,
                                     top + block * static_cast<double>(features));
    for (std::size_t k = 0; k < features; ++k) {
      paint_feature(k, top + kFeatureGap / 2 + block * static_cast<double>(k));
    }
    return bottom;
  }

 private:
  void paint_feature(std::size_t feature, double top) {
    const double height = kRow * static_cast<double>(profiles_.size());
    svg_.text(axis_.left - 5.0,
              top + height / 2 + 0.36 * kLetters,
              profiles_.front().shares[feature].feature,
              {.size = kLetters, .anchor = Anchor::End});
    for (std::size_t i = 0; i < profiles_.size(); ++i) {
      paint_bar(profiles_[i], feature, series_colour(i), top + kRow * static_cast<double>(i));
    }
  }

  void paint_bar(const FeatureProfile& profile,
                 std::size_t feature,
                 const std::string& colour,
                 double top) {
    const auto& share = profile.shares.at(feature);
    const double middle = top + kRow / 2;
    const auto meaning = fmt::format("{}, {}: {}", profile.condition, share.feature, print(share));
    if (share.miller_madow) {
      svg_.box(from_zero(*share.miller_madow, middle, kInner),
               {.fill = colour, .meaning = meaning});
    }
    if (share.observed) {
      svg_.box(from_zero(*share.observed, middle, kBar), {.stroke = colour, .width = 0.7});
    }
    svg_.text(svg_.width(),
              middle + 0.36 * kNumbers,
              print(share),
              {.size = kNumbers, .anchor = Anchor::End});
  }

  Box from_zero(double share, double middle, double height) const {
    const double left = axis_.x(std::min(share, 0.0));
    return {left, middle - height / 2, axis_.x(std::max(share, 0.0)) - left, height};
  }

  Svg& svg_;
  std::span<const FeatureProfile> profiles_;
  ShareAxis axis_;
};

}  // namespace

std::string feature_figure(std::span<const FeatureProfile> profiles, PaperWidth width) {
  Svg svg{points(width), "Information transmitted by feature", describe(profiles)};
  const double bottom = Painter{svg, profiles}.paint();
  return svg.finish(bottom);
}

}  // namespace bimodal::analysis
