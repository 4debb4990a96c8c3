// Lashes are thinner than a pixel, so one that is drawn covers only a part of it.

const float kCover = 0.55;

void main() {
  vec3 light = v_around + 0.4 * v_key;
  colour = vec4(toned(v_albedo * light * kExposure) * kCover, kCover);   // premultiplied
}
