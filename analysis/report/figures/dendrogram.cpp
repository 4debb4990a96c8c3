#include "analysis/report/figures/dendrogram.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kLetters = 7.5;
constexpr double kSmallLetters = 6.5;
constexpr double kRow = 9.5;
constexpr double kTop = 14.0;
constexpr double kLeft = 9.0;

/// Half way between the last merge within classes and the first between them; where only one of
/// the two exists, just beyond it.
double cut_of(const ClusterTable& table) {
  const auto& merges = table.merges;
  const auto within = table.labels.size() - table.classes.size();
  if (merges.empty()) return 0.0;
  if (within == 0) return merges.front().height / 2.0;
  if (within == merges.size()) return merges.back().height * 1.05;
  return (merges[within - 1].height + merges[within].height) / 2.0;
}

std::string describe(const ClusterTable& table) {
  auto text = fmt::format("{} linkage of dissimilarities by {}; {} classes keep at least {}:",
                          name(table.linkage),
                          name(table.measure),
                          table.classes.size(),
                          print_proportion(table.criterion));
  for (const auto& made : table.classes) {
    text += fmt::format(" /{}/ {},", fmt::join(made.members, " "), print_proportion(made.kept));
  }
  text.back() = '.';
  return text;
}

class Painter {
 public:
  Painter(Svg& svg, const ClusterTable& table) : svg_{svg}, table_{table}, cut_{cut_of(table)} {
    double labels = 0.0;
    for (const auto& label : table.labels) {
      labels = std::max(labels, width_of(label, kLetters));
    }
    right_ = svg.width() - labels - 12.0 - width_of("1.00 kept", kSmallLetters);
    bracket_ = right_ + labels + 6.0;
    highest_ = table.merges.empty() ? 1.0 : std::max(table.merges.back().height, cut_);
    if (highest_ <= 0.0) highest_ = 1.0;
    step_ = highest_ > 0.6 ? 0.2 : highest_ > 0.3 ? 0.1 : 0.05;
  }

  double paint() {
    paint_axis();
    paint_tree();
    for (const auto& made : table_.classes) paint_class(made);
    paint_cut();
    return bottom() + 2 * kLetters + 8.0;
  }

 private:
  double x(double height) const { return right_ - height / highest_ * (right_ - kLeft); }

  double bottom() const { return kTop + kRow * static_cast<double>(table_.labels.size()) + 2.0; }

  double row_of(const std::string& label) const {
    const auto place = std::ranges::find(table_.order, label) - table_.order.begin();
    return kTop + kRow * (static_cast<double>(place) + 0.5);
  }

  void paint_axis() {
    const auto steps = static_cast<int>(highest_ / step_ + 1e-9);
    for (int step = 0; step <= steps; ++step) {
      const double height = step * step_;
      svg_.line(x(height), kTop, x(height), bottom(), {.stroke = "#e1e6ea", .width = 0.6});
      svg_.text(x(height),
                bottom() + kLetters + 1.0,
                step == 0 ? "0" : print_proportion(height),
                {.size = kSmallLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
    }
    svg_.text((kLeft + right_) / 2,
              bottom() + 2 * kLetters + 4.0,
              fmt::format("dissimilarity ({})", name(table_.measure)),
              {.size = kSmallLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
  }

  void paint_tree() {
    struct Root {
      double height = 0.0;
      double row = 0.0;
    };

    std::vector<Root> roots;
    for (const auto& label : table_.labels) {
      roots.push_back({0.0, row_of(label)});
      svg_.text(right_ + 3.0, row_of(label) + 0.36 * kLetters, label, {.size = kLetters});
    }
    const Paint branch{.stroke = "#08306b", .width = 0.9};
    for (const auto& merge : table_.merges) {
      const auto one = roots.at(merge.one);
      const auto other = roots.at(merge.other);
      svg_.path(fmt::format("M{} {}H{}V{}H{}",
                            coordinate(x(one.height)),
                            coordinate(one.row),
                            coordinate(x(merge.height)),
                            coordinate(other.row),
                            coordinate(x(other.height))),
                branch);
      roots.push_back({merge.height, (one.row + other.row) / 2.0});
    }
  }

  void paint_class(const ClusterTable::Class& made) {
    double first = bottom();
    double last = 0.0;
    for (const auto& member : made.members) {
      first = std::min(first, row_of(member));
      last = std::max(last, row_of(member));
    }
    svg_.path(fmt::format("M{0} {1}h2.5V{2}h-2.5",
                          coordinate(bracket_),
                          coordinate(first - 0.33 * kRow),
                          coordinate(last + 0.33 * kRow)),
              {.stroke = kSoftInk, .width = 0.7});
    svg_.text(
        bracket_ + 5.0,
        (first + last) / 2.0 + 0.36 * kSmallLetters,
        print_proportion(made.kept) + " kept",
        {.size = kSmallLetters, .colour = made.kept < table_.criterion ? "#b35806" : kSoftInk});
  }

  void paint_cut() {
    if (table_.merges.empty()) return;
    svg_.line(x(cut_),
              kTop - 3.0,
              x(cut_),
              bottom(),
              {.stroke = "#d55e00", .width = 0.9, .dashes = "3 2"});
    const auto words = fmt::format("{} class{}, each to keep {}",
                                   table_.classes.size(),
                                   table_.classes.size() == 1 ? "" : "es",
                                   print_proportion(table_.criterion));
    const bool is_left = x(cut_) < svg_.width() / 2.0;
    svg_.text(x(cut_),
              kTop - 6.0,
              words,
              {.size = kSmallLetters,
               .anchor = is_left ? Anchor::Start : Anchor::End,
               .colour = "#a04600"});
  }

  Svg& svg_;
  const ClusterTable& table_;
  double cut_;
  double right_ = 0.0;    ///< of the leaves
  double bracket_ = 0.0;  ///< of the classes
  double highest_ = 1.0;
  double step_ = 0.2;  ///< between ticks
};

}  // namespace

std::string dendrogram(const ClusterTable& table, PaperWidth width) {
  Svg svg{points(width), "Dendrogram: " + table.title, describe(table)};
  const double bottom = Painter{svg, table}.paint();
  return svg.finish(bottom);
}

}  // namespace bimodal::analysis
