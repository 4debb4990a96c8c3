// Skin, with one of LIPS, BROW, HAIR where the triangle has some of it. ALONE: these are all that is
// drawn, without the skin between and around them.

const float kSkinExponent = 16.0;

#ifdef LIPS
const float kLipExponent = 26.0;

// Returns the exponent of the highlight.
float lips(inout vec3 albedo, inout vec2 gloss) {
  float lip = v_masks.x;
  float creases = kTexture * (noise(vec2(v_rest.x * 1.15, v_rest.y * 0.16), 3) - 0.5);
  float border = smoothstep(0.33, 0.62, lip + 0.1 * creases * (1.0 - min(lip, 1.0)));
#ifdef ALONE
  if (border < 0.5) discard;
#endif
  vec3 vermilion = mix(linear(kLipsOuter), linear(kLipsInner), smoothstep(0.9, 1.6, lip));
  albedo = mix(albedo, vermilion * (1.0 + 0.22 * creases), 0.86 * border);
  albedo = mix(albedo, linear(kLipsInside), 0.9 * smoothstep(1.6, 2.4, lip));
  albedo = mix(albedo, linear(kMouthWalls), smoothstep(0.05, 0.6, v_masks.y));
  gloss += vec2(0.05, 0.04) * border;
  return mix(kSkinExponent, kLipExponent, border);
}
#endif

#ifdef BROW
// Hairs combed outward and up: noise drawn out along their direction.
void brow(inout vec3 albedo, inout vec2 gloss) {
  const float kLength = 48.0;   // mm along the brow
  float along = v_brow.x;
  float above = v_brow.y;
  int side = v_rest.x > 0.0 ? 1 : 9;
  float combed = along * kLength - above * (0.25 + 1.6 * along);
  float hairs = 0.5 * noise(vec2(combed * 4.2, above * 0.30 + 7.0), side) +
                0.6 * noise(vec2(combed * 8.7, above * 0.45), side + 2);
  float edge = v_brow.z * (0.75 + 0.6 * noise(vec2(combed * 2.6, 2.0), side + 4));
  float density = 1.0 - smoothstep(0.20 * edge, 1.20 * edge, abs(above));
  density *= smoothstep(0.0, 0.12, along + 0.06 * (hairs - 0.4)) *
             (1.0 - 0.55 * smoothstep(0.85, 1.0, along)) * (1.0 - smoothstep(1.0, 1.04, along));
  float cover = min(density * (0.66 + 0.50 * smoothstep(0.20, 0.85, hairs)), 1.0);
#ifdef ALONE
  if (cover < 0.3) discard;
#endif
  albedo = mix(albedo, linear(kBrows), 0.92 * cover);
  gloss *= 1.0 - cover;
}
#endif

#ifdef HAIR
// Short hair, painted: strands stand up, so the noise is drawn out along y.
void hair(inout vec3 albedo, inout vec2 gloss) {
  vec3 strand = v_rest * vec3(1.7, 0.42, 0.8);
  float strands = 0.5 * noise(strand) + 0.25 * noise(strand * 2.03) + 0.11;
  float cover = smoothstep(0.22, 0.78, v_masks.z + 0.42 * (strands - 0.45));
#ifdef ALONE
  if (cover < 0.5) discard;
#endif
  albedo = mix(albedo, linear(kHair) * (kTexture * (0.45 + 1.1 * strands) + (1.0 - kTexture)), 0.95 * cover);
  gloss *= 1.0 - vec2(0.6, 1.0) * cover;
}
#endif

void main() {
  vec3 albedo = v_albedo;
  vec2 gloss = v_gloss;
  float width = kSkinExponent;
#ifdef LIPS
  width = lips(albedo, gloss);
#endif
#ifdef BROW
  brow(albedo, gloss);
#endif
#ifdef HAIR
  hair(albedo, gloss);
#endif
  colour = vec4(lit(albedo, surface_normal(), gloss, width), 1.0);
}
