// From the colour and gloss of a point to its light: one soft key light, two highlights.

in vec3 v_position;
in vec3 v_normal;
in vec3 v_rest;
in vec3 v_albedo;
in vec3 v_around;
in vec3 v_key;
in vec2 v_gloss;
in vec4 v_masks;
in vec3 v_brow;
in vec3 v_half;
in float v_sheen;

uniform vec3 key_direction;
uniform float softness;

out vec4 colour;

const float kExposure = 0.62;
const float kBackFace = 0.35;    // the inner side of an open surface is darker
const vec3 kHighlightColour = vec3(1.0, 0.98, 0.95);

vec3 srgb(float red, float green, float blue) {
  return pow(vec3(red, green, blue) / 255.0, vec3(2.2));
}

// Compresses what is brighter than the paper is white; the target encodes to sRGB.
vec3 toned(vec3 linear) {
  linear = max(linear, 0.0);
  return linear * (1.0 + 0.12 * linear) / (1.0 + 0.42 * linear);
}

// The sharp highlight is this much narrower than the broad one.
const float kSharper = 3.5;

// `albedo` linear; `gloss`: strength of the broad and the sharp highlight; `exponent`: the broad one's.
vec3 lit(vec3 albedo, vec3 normal, vec2 gloss, float exponent) {
  float cosine = dot(normal, key_direction);
  vec3 wrap = vec3(0.32, 0.14, 0.08) * softness;   // red light creeps farthest
  vec3 t = max((cosine + wrap) / (1.0 + wrap), 0.0);
  vec3 light = v_around + v_key * t * mix(vec3(1.0), t, 1.2 * wrap);
  vec3 result = albedo * light;
  if (!gl_FrontFacing) result *= kBackFace;

  float broad = pow(max(dot(normal, v_half), 1e-3), exponent);
  float sharp = broad * broad * broad * sqrt(broad);   // to the power kSharper
  float highlight = gloss.x * (exponent + 2.0) * broad +
                    gloss.y * (kSharper * exponent + 2.0) * sharp;
  highlight *= v_key.g * clamp(4.0 * cosine, 0.0, 1.0) / 16.0;
  return toned((result + kHighlightColour * (highlight + v_sheen)) * kExposure);
}
