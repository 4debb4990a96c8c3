// From the colour and gloss of a point to its light: one soft key light, two highlights.

in vec3 v_position;
in vec3 v_normal;
in vec3 v_rest;
in vec3 v_albedo;
BY_VERTEX in vec3 v_around;
BY_VERTEX in vec3 v_key;
BY_VERTEX in vec3 v_half;
BY_VERTEX in float v_sheen;
in vec2 v_gloss;
in vec4 v_masks;
in vec3 v_brow;
#ifdef GOURAUD
in vec3 v_scattered;
in float v_highlight;
#endif

uniform vec3 key_direction;

out vec4 colour;

const float kBackFace = 0.35;    // the inner side of an open surface is darker
const vec3 kHighlightColour = vec3(1.0, 0.98, 0.95);

// Of an 8-bit sRGB colour.
vec3 linear(vec3 srgb) {
  return pow(srgb / 255.0, vec3(2.2));
}

// Compresses what is brighter than the paper is white; the target encodes to sRGB.
vec3 toned(vec3 light) {
  light = max(light, 0.0);
  return light * (1.0 + 0.12 * light) / (1.0 + 0.42 * light);
}

// The normal for light; of the whole triangle where it is flat.
vec3 surface_normal() {
#ifdef FLAT
  vec3 facet = normalize(cross(dFdy(v_position), dFdx(v_position)));
  return dot(facet, v_normal) < 0.0 ? -facet : facet;
#else
  return normalize(v_normal);
#endif
}

// `albedo` linear; `gloss`: strength of the broad and the sharp highlight; `width`: the exponent of
// the broad one.
vec3 lit(vec3 albedo, vec3 normal, vec2 gloss, float width) {
#ifdef GOURAUD
  vec3 result = albedo * v_scattered;
  float mirrored = v_highlight;
#else
  float cosine = dot(normal, key_direction);
#ifdef FULL
  vec3 key = key_light(v_position, normal);
#else
  vec3 key = v_key;
#endif
  vec3 result = albedo * scattered(cosine, v_around, key);
  float mirrored = highlight(cosine, dot(normal, v_half), gloss, width, key.g);
#endif
  if (!gl_FrontFacing) result *= kBackFace;
  return toned((result + kHighlightColour * (mirrored + v_sheen) * kGloss) * kExposure);
}
