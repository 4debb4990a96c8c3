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
in float v_open;

uniform vec3 camera;
uniform vec3 key_direction;
uniform vec3 fill_direction;
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

// `albedo` linear; `gloss`: strength of the broad and the sharp highlight; `exponents` theirs.
vec3 lit(vec3 albedo, vec3 normal, vec2 gloss, vec2 exponents) {
  vec3 to_camera = normalize(camera - v_position);
  float facing = dot(normal, to_camera);
  float cosine = dot(normal, key_direction);

  vec3 wrap = vec3(0.32, 0.14, 0.08) * softness;   // red light creeps farthest
  vec3 t = max((cosine + wrap) / (1.0 + wrap), 0.0);
  vec3 light = v_around + v_key * t * mix(vec3(1.0), t, 1.2 * wrap);
  vec3 result = albedo * light * kExposure;
  if (!gl_FrontFacing) result *= kBackFace;

  vec2 strength = gloss * (exponents + 2.0) / 8.0;
  float key_half = max(dot(normal, normalize(key_direction + to_camera)), 1e-4);
  float fill_half = max(dot(normal, normalize(fill_direction + to_camera)), 1e-4);
  float highlight =
      dot(strength, pow(vec2(key_half), exponents)) * v_key.g * 0.5 * clamp(4.0 * cosine, 0.0, 1.0) +
      0.25 * dot(strength, pow(vec2(fill_half), exponents)) * v_open;
  float grazing = 1.0 - clamp(facing, 0.0, 1.0);
  grazing *= grazing;
  highlight += 0.08 * grazing * grazing * v_open * softness;
  return toned(result + kHighlightColour * (highlight * kExposure));
}
