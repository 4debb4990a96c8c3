#include "stimuli/alignment/word_listener.hpp"

#include <algorithm>

#include "stimuli/alignment/acoustic_model.hpp"
#include "stimuli/alignment/cepstra.hpp"
#include "stimuli/alignment/phone_path.hpp"
#include "stimuli/alignment/search_sound.hpp"
#include "stimuli/alignment/word_graph.hpp"

namespace bimodal {

struct WordListener::Ear {
  AcousticModel model{AcousticModel::installed()};
  CepstraMaker cepstra{AcousticModel::installed() / "feat.params"};
};

struct HeardStretch::Scores {
  const AcousticModel* model;
  UnitScores scores;
  double free;
  double speech_frames;
};

HeardStretch::HeardStretch(std::unique_ptr<Scores> scores) : scores_{std::move(scores)} {}

HeardStretch::HeardStretch(HeardStretch&&) noexcept = default;
HeardStretch& HeardStretch::operator=(HeardStretch&&) noexcept = default;
HeardStretch::~HeardStretch() = default;

std::optional<double> HeardStretch::fit(std::span<const SpokenWord> words) const {
  const auto graph = graph_of(words);
  const auto path = best_path(graph.nodes, scores_->scores, *scores_->model);
  if (!path) return std::nullopt;
  double likelihood = 0.0;
  for (const auto& step : *path) {
    likelihood += phone_likelihood(
        graph.nodes[step.node], step.first_frame, step.frames, scores_->scores, *scores_->model);
  }
  return (likelihood - scores_->free) / scores_->speech_frames;
}

std::optional<double> HeardStretch::fit(const SpokenWord& word) const {
  return fit(std::span{&word, 1});
}

WordListener::WordListener() : ear_{std::make_unique<Ear>()} {}

WordListener::~WordListener() = default;
WordListener::WordListener(WordListener&&) noexcept = default;
WordListener& WordListener::operator=(WordListener&&) noexcept = default;

HeardStretch WordListener::listen(const Clip& sound, Duration speech) {
  const auto heard = search_sound(sound);
  const auto cepstra = ear_->cepstra.make(heard.samples);
  const auto units = context_free_units(ear_->model, 0, cepstra.size());
  auto scores = ear_->model.score(cepstra, units);
  std::vector<PhoneNode> any_phones;
  for (const Phone phone : all_phones()) {
    if (modelled(phone) == phone) any_phones.push_back(context_free_node(phone));
  }
  const auto free = free_likelihood(any_phones, 0, cepstra.size(), scores, ear_->model);
  const double frames = std::max(
      1.0, static_cast<double>(speech.count()) / static_cast<double>(CepstraMaker::kFrame.count()));
  return HeardStretch{std::make_unique<HeardStretch::Scores>(
      HeardStretch::Scores{&ear_->model, std::move(scores), free, frames})};
}

}  // namespace bimodal
