// Teeth, gums and tongue.

uniform vec3 exponents_and_grain;   // of the two highlights; how rough the colour is

void main() {
  float grain = 1.0 + exponents_and_grain.z * (noise(v_rest * 1.6) - 0.5);
  colour = vec4(lit(v_albedo * grain, normalize(v_normal), v_gloss, exponents_and_grain.xy), 1.0);
}
