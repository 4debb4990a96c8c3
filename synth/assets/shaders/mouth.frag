// Teeth, gums and tongue.

uniform float exponent;   // of the broad highlight
uniform float grain;      // how rough the colour is

void main() {
  float rough = 1.0 + grain * (noise(v_rest * 1.6) - 0.5);
  colour = vec4(lit(v_albedo * rough, normalize(v_normal), v_gloss, exponent), 1.0);
}
