// Teeth, gums and tongue.

uniform float grain;      // how rough the colour is

#ifdef TONGUE
// The furrow along the middle of the upper side, its paler coat, and papillae.
vec3 tongue(vec3 albedo) {
  float upper = kTexture * smoothstep(0.0, 0.5, v_normal.y);
  float across = v_rest.x + 0.6 * (noise(vec2(v_rest.z * 0.25, 3.0), 5) - 0.5);
  float furrow = exp(-0.5 * across * across) * upper;
  float papillae = (noise(v_rest * vec3(2.6, 2.6, 2.2)) - 0.5) * upper;
  float coat = smoothstep(14.0, 4.0, abs(v_rest.x)) * upper;
  return albedo * (1.0 - 0.38 * furrow + 0.30 * papillae) + 0.10 * coat * vec3(0.50, 0.42, 0.40);
}
#endif

void main() {
  float rough = 1.0 + kTexture * grain * (noise(v_rest * 1.6) - 0.5);
  vec3 albedo = v_albedo * rough;
#ifdef TONGUE
  albedo = tongue(albedo);
#endif
  colour = vec4(lit(albedo, surface_normal(), v_gloss, exponent), 1.0);
}
