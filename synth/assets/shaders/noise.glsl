// The value noise of solid_noise.cpp, and the same in the plane.

float lattice_value(ivec3 corner) {
  uint hash = uint(corner.x) * 374761393u + uint(corner.y) * 668265263u +
              uint(corner.z) * 2246822519u;
  hash = (hash ^ (hash >> 13u)) * 1274126177u;
  hash ^= hash >> 16u;
  return float(hash & 0xffffffu) / 16777215.0;
}

// `layer` (a whole number) chooses one of many independent patterns.
float noise(vec2 at, int layer) {
  vec2 corner = floor(at);
  vec2 t = at - corner;
  t = t * t * (3.0 - 2.0 * t);
  ivec3 c = ivec3(ivec2(corner), layer);
  return mix(mix(lattice_value(c), lattice_value(c + ivec3(1, 0, 0)), t.x),
             mix(lattice_value(c + ivec3(0, 1, 0)), lattice_value(c + ivec3(1, 1, 0)), t.x), t.y);
}

float noise(vec3 at) {
  float corner = floor(at.z);
  float t = at.z - corner;
  t = t * t * (3.0 - 2.0 * t);
  return mix(noise(at.xy, int(corner)), noise(at.xy, int(corner) + 1), t);
}
