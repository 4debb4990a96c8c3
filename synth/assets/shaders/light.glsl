// What a light does to a surface. Colours are linear.

uniform float softness;   // 1 skin, 0 hard: how far light creeps round the form
uniform float exponent;   // of the part's broad highlight

#ifdef FLAT
#define BY_VERTEX flat
#else
#define BY_VERTEX
#endif

// The sharp highlight is this much narrower than the broad one.
const float kSharper = 3.5;

// All light that is scattered, of what comes from around and from the key light at `cosine`.
vec3 scattered(float cosine, vec3 around, vec3 key) {
  vec3 wrap = vec3(0.32, 0.14, 0.08) * softness;   // red light creeps farthest
  vec3 t = max((cosine + wrap) / (1.0 + wrap), 0.0);
  return around + key * t * mix(vec3(1.0), t, 1.2 * wrap);
}

// `gloss`: strength of the broad and the sharp highlight; `width`: exponent of the broad one;
// `mirrored`: cosine between the normal and the middle of light and eye.
float highlight(float cosine, float mirrored, vec2 gloss, float width, float key) {
  float broad = pow(max(mirrored, 1e-3), width);
  float sharp = broad * broad * broad * sqrt(broad);   // to the power kSharper
  float both = gloss.x * (width + 2.0) * broad + gloss.y * (kSharper * width + 2.0) * sharp;
  return both * (key * clamp(4.0 * cosine, 0.0, 1.0) / 16.0);
}

// Colour of the key light of which this share arrives: red goes deepest into what is in shadow.
vec3 key_through(float share) {
  return kKeyColour *
         vec3(pow(share, 1.0 - 0.35 * softness), share, pow(share, 1.0 + 0.15 * softness));
}
