// Teeth, gums and tongue.

uniform float grain;      // how rough the colour is

void main() {
  float rough = 1.0 + kTexture * grain * (noise(v_rest * 1.6) - 0.5);
  colour = vec4(lit(v_albedo * rough, surface_normal(), v_gloss, exponent), 1.0);
}
