#include "runner/preparation/face_talker.hpp"

#include "stimuli/base/asset.hpp"
#include "synth/speech/articulation.hpp"

namespace bimodal::runner {

namespace {

synth::Backdrop plain(std::uint32_t background) {
  const Colour colour{static_cast<std::uint8_t>((background >> 16U) & 0xffU),
                      static_cast<std::uint8_t>((background >> 8U) & 0xffU),
                      static_cast<std::uint8_t>(background & 0xffU)};
  return {.centre = colour, .edge = colour};
}

/// Drawn ahead of their presentation, pictures may have smooth edges in full quality.
synth::Appearance appearance_in(synth::Quality quality) {
  constexpr int kFullSamples = 4;
  synth::Appearance appearance;
  appearance.quality = quality;
  if (quality == synth::Quality::Full) appearance.samples = kFullSamples;
  return appearance;
}

class TalkingFace final : public FrameSource {
 public:
  TalkingFace(synth::HeadRenderer& renderer, synth::Articulation articulation)
      : renderer_{renderer}, articulation_{std::move(articulation)} {}

  [[nodiscard]] std::int64_t picture_at(Duration time) override { return time.count(); }

  [[nodiscard]] std::shared_ptr<const Image> paint(Duration time) override {
    auto image = std::make_shared<Image>();
    renderer_.draw(articulation_.at(time), *image);
    return image;
  }

 private:
  synth::HeadRenderer& renderer_;
  synth::Articulation articulation_;
};

}  // namespace

FaceTalker::FaceTalker(std::size_t height, std::uint32_t background, synth::Quality quality)
    : head_{asset("synth/assets/head")},
      renderer_{head_,
                {.width = height * 8 / 9,
                 .height = height,
                 .centre_y_mm = -32.0,
                 .field_mm = 312.0,  // the whole head, crown to neck
                 .backdrop = plain(background)},
                appearance_in(quality)} {}

std::unique_ptr<FrameSource> FaceTalker::say(std::span<const TimedSegment> segments,
                                             const synth::SegmentTable& table,
                                             Account account) {
  return std::make_unique<TalkingFace>(renderer_, synth::Articulation{segments, table, account});
}

}  // namespace bimodal::runner
