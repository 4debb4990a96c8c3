// The eyeball by angle from the gaze: pupil, iris with its fibres and dark border, sclera. The
// white that fills the corners of the lids and the caruncle are marked by their rest position.

const float kPupil = 12.5;   // degrees from the gaze
const float kIris = 29.5;

const float kCornerFiller = -5.0;   // rest z of the white behind the lids' corners
const float kCaruncle = -0.5;

vec3 sclera(vec3 rest, vec3 direction, float angle) {
  vec3 pink = linear(kEyeFlesh);
  vec3 white = linear(kEyeWhite);
  if (rest.z < kCornerFiller) {
    white = mix(linear(kEyeCorners), pink, smoothstep(0.55, 0.92, -rest.x));
  } else if (rest.z < kCaruncle) {
    white = pink;
  }
  float veins = 0.5 * noise(direction * vec3(14.0, 14.0, 6.0)) +
                0.25 * noise(direction * vec3(28.0, 28.0, 12.0));
  return mix(white, linear(kEyeVeins), kTexture * 0.5 * smoothstep(25.0, 75.0, angle) * veins);
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

void main() {
  vec3 direction = normalize(v_rest);
  float angle = degrees(acos(clamp(direction.z, -1.0, 1.0)));
  vec3 albedo = mix(iris(direction, angle), sclera(v_rest, direction, angle),
                    smoothstep(kIris - 1.3, kIris + 1.3, angle));
  albedo = mix(linear(kPupilColour), albedo, smoothstep(kPupil - 1.0, kPupil + 1.0, angle));
  albedo *= 1.0 - 0.45 * smoothstep(0.10, 0.40, direction.y);   // shadow of the upper lid
  colour = vec4(lit(albedo, surface_normal(), vec2(0.0), 16.0), 1.0);
}
