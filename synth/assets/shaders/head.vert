// Every part of the head. What varies slowly over the surface is worked out here, once per vertex:
// light from everywhere, light in the mouth, and how much of the key light arrives.
// Millimetres; x = subject's left, y up, z forward; colours are linear.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;    // for eyes: direction in the eyeball, gaze +z
layout(location = 3) in vec3 albedo;
layout(location = 4) in vec4 baked;   // open sky, key light, fill light (0..1); inside the mouth 0..1
layout(location = 5) in vec4 masks;   // lip, wet, scalp, special, as in SurfaceDescription
layout(location = 6) in vec3 brow;    // as in VertexPaint
layout(location = 7) in vec2 gloss;   // as in VertexPaint

uniform mat4 clip_from_world;
uniform vec3 camera;
uniform vec3 key_direction;   // towards the light
uniform vec3 fill_direction;

#ifdef MOUTH
uniform mat3 head_axes;       // columns: the head's left, up and forward in the world
uniform vec3 mouth_centre;    // of the opening between the lips
uniform vec3 mouth_opening;   // half width, half height (mm), area (mm2)
#endif

uniform float sky_floor;      // light that reaches a translucent part in spite of what covers it
uniform float shadow_floor;
#ifdef CUT
uniform vec4 cut;             // the plane's unit normal, minus its distance from the origin
#endif

out vec3 v_position;
out vec3 v_normal;
out vec3 v_rest;
out vec3 v_albedo;
BY_VERTEX out vec3 v_around;  // light from everywhere but the key light
BY_VERTEX out vec3 v_key;     // colour of the key light that arrives here
out vec2 v_gloss;
out vec4 v_masks;
out vec3 v_brow;
BY_VERTEX out vec3 v_half;    // between the key light and the camera
BY_VERTEX out float v_sheen;  // highlights that are broad enough for the vertices
#ifdef MOUTH
out float v_scattered_in_mouth;   // 0..1: how much of the scattered light gets so deep
#else
const float v_scattered_in_mouth = 1.0;
#endif
#ifdef GOURAUD
out vec3 v_scattered;
out float v_highlight;
#endif

const vec3 kRimLeft = vec3(0.666, 0.400, -0.622);
const vec3 kRimRight = vec3(-0.724, 0.272, -0.634);
const float kFillExponent = 16.0;
const float kFillSheen = 0.25 * (kFillExponent + 2.0) / 8.0;
const float kGrazingSheen = 0.08;
const float kPi = 3.14159265;

#ifdef MOUTH
// Part of the sky's light that comes through the lips: the form factor of the opening as a disc of
// the same area, with a share that has been scattered in the mouth.
float sky_through_lips(vec3 at, vec3 n) {
  vec3 to_opening = mouth_centre - at;
  float square = dot(to_opening, to_opening);
  float distance = sqrt(square + 1e-6);
  float facing = clamp(dot(to_opening, n) / distance, 0.0, 1.0);
  float behind = max(dot(to_opening, head_axes[2]), 0.0);
  float area = mouth_opening.z;
  return clamp(1.25 * area * (0.25 + 0.75 * facing) * clamp(behind / distance + 0.25, 0.0, 1.0) /
                   (kPi * (square + area / kPi)), 0.0, 1.0);
}

// Part of the light scattered in the mouth that gets as deep as this: half of it at 1.3 times the
// side of a square as large as the opening.
float scattered_so_deep(vec3 at) {
  float behind = max(dot(mouth_centre - at, head_axes[2]), 0.0);
  return 1.0 / (1.0 + behind * behind / (1.7 * max(mouth_opening.z, 1.0)));
}

// 1 if the ray from `at` towards a light leaves through the lips, taken as an ellipse; soft edge.
float light_through_lips(vec3 at, vec3 direction) {
  vec3 from = transpose(head_axes) * (at - mouth_centre);
  vec3 along = transpose(head_axes) * direction;
  vec2 hit = from.xy + along.xy * max(-from.z, 0.0) / max(along.z, 0.1);
  float outside = length(hit / max(mouth_opening.xy, vec2(0.05)));
  float passes = 1.0 - smoothstep(0.70, 1.25, outside);
  return mix(passes, 1.0, smoothstep(-1.0, 3.0, from.z));
}
#endif

// Diffuse light that creeps round the form by `wrap` (0..1).
float wrapped(float cosine, float wrap) {
  float t = max((cosine + wrap) / (1.0 + wrap), 0.0);
  return t * mix(1.0, t, 1.2 * wrap);
}

void main() {
  float open = baked.x;
  float key = baked.y;
  float fill = baked.z;
#ifdef MOUTH
  float inside = baked.w;
  open = mix(open, mix(sky_through_lips(position, normal), 1.0, kMouthLight), inside);
  v_scattered_in_mouth = mix(1.0, mix(scattered_so_deep(position), 1.0, kMouthLight), inside);
  key = mix(key, mix(light_through_lips(position, key_direction), 1.0, kMouthLight), inside);
  fill = mix(fill, mix(light_through_lips(position, fill_direction), 1.0, kMouthLight), inside);
#endif
  open = mix(sky_floor * v_scattered_in_mouth, 1.0, open);
  key = mix(shadow_floor * v_scattered_in_mouth, 1.0, key);

  float cosine = dot(normal, fill_direction);
  vec3 filled = fill * vec3(wrapped(cosine, 0.30 * softness), wrapped(cosine, 0.20 * softness),
                            wrapped(cosine, 0.15 * softness));
  vec3 sky = mix(kGroundColour, kSkyColour, 0.5 + 0.5 * normal.y) *
             vec3(pow(open, 1.0 - 0.25 * softness), open, pow(open, 1.0 + 0.1 * softness));
  float rim = 0.70 * max(dot(normal, kRimLeft), 0.0) + 0.35 * max(dot(normal, kRimRight), 0.0);

  v_around = sky + kFillColour * filled + kRimColour * rim * open;
  v_key = key_through(key);

  vec3 to_camera = normalize(camera - position);
  float grazing = 1.0 - clamp(dot(normal, to_camera), 0.0, 1.0);
  float mirrored = max(dot(normal, normalize(fill_direction + to_camera)), 1e-3);
  v_half = normalize(key_direction + to_camera);
  v_sheen = open * (kFillSheen * gloss.x * pow(mirrored, kFillExponent) +
                    kGrazingSheen * softness * pow(grazing, 4.0));

  v_position = position;
  v_normal = normal;
  v_rest = rest;
  v_albedo = albedo;
  v_gloss = gloss;
  v_masks = masks;
  v_brow = brow;
  gl_Position = clip_from_world * vec4(position, 1.0);
#ifdef GOURAUD
  cosine = dot(normal, key_direction);
  v_scattered = scattered(cosine, v_around, v_key);
  v_highlight = highlight(cosine, dot(normal, v_half), gloss, exponent, v_key.g);
#endif
#ifdef CUT
  gl_ClipDistance[0] = -dot(cut, vec4(position, 1.0));
#endif
}
