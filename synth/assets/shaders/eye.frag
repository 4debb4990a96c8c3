// The eyeball by angle from the gaze: pupil, iris with its fibres and dark border, sclera. The
// white that does not turn, with the caruncle, is marked by its rest position.

uniform mat3 head_axes;   // columns: the head's left, up and forward in the world

const float kPupil = 12.5;   // degrees from the gaze
const float kIris = 29.5;

const float kStill = -5.0;   // rest z of the white that does not turn

// 1 on the caruncle; `at`: from nose to temple and up, in radii of the eyeball.
float flesh(vec2 at) {
  return smoothstep(0.87, 0.98, -at.x - 0.2 * abs(at.y + 0.1));
}

vec3 still_white(vec2 at) {
  float vessels = 0.5 * noise(at * vec2(9.0, 22.0), 5) + 0.5 * noise(at * vec2(19.0, 40.0), 6);
  float corner = smoothstep(0.50, 1.05, abs(at.x));
  vec3 white = mix(linear(kEyeWhite), linear(kEyeCorners), corner);
  white = mix(white, linear(kEyeVeins), kTexture * corner * (0.12 + 0.35 * vessels));
  return mix(white, 1.25 * linear(kEyeFlesh), flesh(at));
}

vec3 iris(vec3 direction, float angle) {
  float round = atan(direction.y, direction.x);
  float coarse = noise(vec2(round * 9.0, angle * 0.10), 1);
  float fine = noise(vec2(round * 22.0, angle * 0.22), 4);
  vec3 ring = mix(linear(kIrisDark), linear(kIrisLight),
                  clamp(0.10 + 0.75 * (0.6 * coarse + 0.55 * fine), 0.0, 1.0));
  ring = mix(ring, linear(kIrisMiddle), 0.55 * (1.0 - smoothstep(11.0, 19.0, angle + 3.0 * fine)));
  ring = mix(ring, linear(kIrisEdge), 0.85 * smoothstep(24.0, 29.5, angle));
  return ring * (kTexture * (0.75 + 0.6 * clamp(0.2 - 1.2 * direction.y, 0.0, 1.0)) + (1.0 - kTexture));
}

vec3 turning_ball(vec3 direction) {
  float angle = degrees(acos(clamp(direction.z, -1.0, 1.0)));
  vec3 albedo = mix(iris(direction, angle), linear(kEyeWhite),
                    smoothstep(kIris - 1.3, kIris + 1.3, angle));
  return mix(linear(kPupilColour), albedo, smoothstep(kPupil - 1.0, kPupil + 1.0, angle));
}

void main() {
  vec3 normal = surface_normal();
  bool still = v_rest.z < kStill;
  vec3 albedo = still ? still_white(v_rest.xy) : turning_ball(normalize(v_rest));
  vec2 gloss = still ? vec2(0.05, 0.10) * flesh(v_rest.xy) : vec2(0.0);
  albedo *= 1.0 - 0.45 * smoothstep(0.10, 0.40, dot(normal, head_axes[1]));   // shadow of the upper lid
  colour = vec4(lit(albedo, normal, gloss, 26.0), 1.0);
}
