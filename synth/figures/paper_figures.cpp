#include "synth/figures/paper_figures.hpp"

#include <array>

#include <fmt/format.h>

#include "synth/figures/paper_scores.hpp"

namespace bimodal::synth {

namespace {

PaperFigure figure_one() {
  PaperFigure figure{
      .name = "figure1",
      .title = "Figure 1. Protrusion from /i/ to /u/ under three accounts of coarticulation",
      .caption =
          "Look-ahead begins as soon as the first vowel allows (its rule of Kapoor et al. 2000), "
          "time-locked a fixed time before the second vowel, hybrid does both, slowly and then "
          "fast. Dotted: acoustic onset of /u/. The paper's figure is a schema after Perkell "
          "(1989); these are this program's own movements, drawn to the same time. Durations 200, "
          "150, 200 ms and theta .03 are chosen by us.",
      .panels = {},
      .columns = 3};
  for (std::size_t consonants = 1; consonants <= 2; ++consonants) {
    const auto score = towards_protrusion(consonants);
    const double onset = score.segments.back().start.count();
    for (const auto account : {Account::LookAhead, Account::TimeLocked, Account::Hybrid}) {
      const auto& row = accounts()[static_cast<std::size_t>(account)];
      figure.panels.push_back(
          {.title = fmt::format("{}, {}", row.name, consonants == 1 ? "VCV" : "VCCV"),
           .y_label = "protrusion",
           .traces = {{.label = "", .score = score, .account = account}},
           .shows_dominance = false,
           .lines = {{.x = onset, .label = ""}}});
    }
  }
  return figure;
}

PaperFigure figure_four() {
  return {.name = "figure4",
          .title = "Figure 4. Two segments and what becomes of their targets",
          .caption =
              "Theta .035 per ms, c 1, 100 ms each, targets .1 and .9 (circles), as in the "
              "paper. Neither target is reached: .123 and .877 at the centres.",
          .panels = {{.title = "",
                      .y_label = "control",
                      .traces = {{.label = "", .score = two_segments({})}}}}};
}

PaperFigure figure_five() {
  PaperPanel panel{.title = "", .y_label = "control", .traces = {}};
  for (const double alpha : {1.0, 0.5, 0.2, 0.05}) {
    panel.traces.push_back({.label = fmt::format("alpha {}", alpha),
                            .score = two_segments({.alpha_of_first = alpha})});
  }
  return {.name = "figure5",
          .title = "Figure 5. The less alpha of segment 1, the more segment 2 intrudes",
          .caption =
              "As figure 4, with four values of alpha for segment 1 (the values are chosen "
              "by us). Grey: the same in all.",
          .panels = {panel}};
}

PaperFigure figure_six() {
  PaperPanel panel{.title = "", .y_label = "control", .traces = {}};
  for (const double theta : {0.0175, 0.035, 0.07, 0.14}) {
    panel.traces.push_back({.label = fmt::format("theta {}", theta),
                            .score = two_segments({.theta_before_of_second = theta})});
  }
  return {.name = "figure6",
          .title = "Figure 6. More theta before segment 2: a later, steeper transition",
          .caption =
              "As figure 4, with four values of theta on the anticipatory side of segment 2 "
              "(the values are chosen by us).",
          .panels = {panel}};
}

PaperFigure figure_seven() {
  PaperPanel panel{.title = "", .y_label = "control", .traces = {}};
  for (const double exponent : {0.5, 1.0, 1.25, 2.0}) {
    panel.traces.push_back(
        {.label = fmt::format("c {}", exponent), .score = two_segments({.exponent = exponent})});
  }
  return {.name = "figure7",
          .title = "Figure 7. Greater power c: closer to the targets, more abrupt",
          .caption =
              "As figure 4, with four values of c and the same theta, in 1/ms^c (the values "
              "are chosen by us). With c 2 the change is almost a step.",
          .panels = {panel}};
}

PaperFigure figure_eight() {
  return {
      .name = "figure8",
      .title = "Figure 8. \"stew\": lip protrusion runs ahead of the vowel, or does not",
      .caption =
          "Alpha .06 for /s t/ and 1 for /u/, as printed. With the printed theta of .07 per ms "
          "protrusion does not extend far forward, whatever the text says: half of it is reached "
          "14 ms after the onset of /u/ (dotted). With .02, which natural lips have (.018 to "
          ".022), "
          "half is reached 45 ms before it, within /t/, as talkers do (43 to 62 ms). Right: "
          "tongue angle, of which /t/ and /u/ have alpha 1, so that /t/ reaches its place. "
          "Durations and targets are chosen by us; one theta for all segments.",
      .panels = {{.title = "lip protrusion, theta .07 (printed)",
                  .y_label = "control",
                  .traces = {{.label = "", .score = stew(0.07)}},
                  .lines = {{.x = 200, .label = ""}}},
                 {.title = "lip protrusion, theta .02 (natural lips)",
                  .y_label = "control",
                  .traces = {{.label = "", .score = stew(0.02)}},
                  .lines = {{.x = 200, .label = ""}}},
                 {.title = "tongue angle, theta .07",
                  .y_label = "control",
                  .traces = {{.label = "", .score = stew_tongue(0.07)}},
                  .lines = {{.x = 200, .label = ""}}}},
      .columns = 3};
}

PaperFigure inflected(std::string name, std::string title, std::size_t consonants) {
  PaperPanel panel{.title = "", .y_label = "control", .traces = {}, .lines = {}};
  panel.traces = {{.label = "inflected", .score = vowels_around(consonants, true)},
                  {.label = "equation 1", .score = vowels_around(consonants, false)}};
  panel.lines.push_back({.x = 280, .label = "V2 centre - 68 ms"});
  return {.name = std::move(name),
          .title = std::move(title),
          .caption =
              "Theta before V2 is .07 per ms, as in figure 8, from 68 ms before its centre on, "
              "and .01 earlier: the control accelerates at 280 ms, as in the hybrid "
              "account. With equation 1 (.01 throughout) it does not: it moves early, as "
              "under look-ahead. The thetas .01 and, elsewhere, .02 and the durations are "
              "chosen by us, so that the change falls on the paper's 280 ms.",
          .panels = {panel}};
}

PaperFigure figure_eleven() {
  PaperPanel rates{.title = "English, three rates", .y_label = "lip protrusion", .traces = {}};
  for (const auto& [label, rate] :
       {std::pair{"slow (2X durations)", 0.5}, {"normal", 1.0}, {"fast (.5X durations)", 2.0}}) {
    rates.traces.push_back({.label = label, .score = utu(rate)});
  }
  rates.shows_dominance = false;
  PaperPanel languages{
      .title = "trough and plateau, normal rate", .y_label = "lip protrusion", .traces = {}};
  languages.traces = {{.label = "alpha of /t/ .15", .score = utu(1)},
                      {.label = "alpha of /t/ .01", .score = utu(1, 0.01)}};
  languages.shows_dominance = false;
  return {.name = "figure11",
          .title = "Figure 11. /utu/: the faster, the more its two gestures become one",
          .caption =
              "Only durations change with rate (circles: the targets of /u/, /t/, /u/). Right: "
              "with a much lower alpha of /t/ the "
              "trough of English talkers becomes the plateau of Turkish ones (Boyce 1990). "
              "Durations, theta .02 and alphas are chosen by us.",
          .panels = {rates, languages},
          .columns = 2};
}

PaperFigure equation_seven() {
  PaperPanel panel{.title = "", .y_label = "control", .traces = {}};
  panel.traces = {{.label = "equation 1, theta .035", .score = two_segments({})},
                  {.label = "equation 7, omega .035",
                   .score = two_segments({.form = DominanceForm::CriticallyDamped})}};
  return {.name = "equation7",
          .title = "Equation 7. Critically damped dominance",
          .caption =
              "As figure 4. At the same rate the critically damped form is broader; it is "
              "level at its peak.",
          .panels = {panel}};
}

}  // namespace

std::vector<PaperFigure> paper_figures() {
  return {figure_one(),
          figure_four(),
          figure_five(),
          figure_six(),
          figure_seven(),
          figure_eight(),
          inflected("figure9", "Figure 9. VCCV with an inflected dominance of V2", 2),
          inflected("figure10", "Figure 10. VCV with an inflected dominance of V2", 1),
          figure_eleven(),
          equation_seven()};
}

}  // namespace bimodal::synth
