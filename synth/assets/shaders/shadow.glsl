// How much of the key light arrives, from the map of what it meets first.

#ifdef MOUTH
in float v_scattered_in_mouth;
#else
const float v_scattered_in_mouth = 1.0;
#endif

uniform sampler2DShadow shadow_map;
uniform mat4 map_from_world;
uniform float shadow_floor;   // light that reaches a translucent part in spite of what covers it

const float kExtent = 370.0;              // mm that the map is wide and deep (shadow_map.cpp)
const float kApart = 0.8 / kExtent;       // between two looks
const float kLift = 0.8;                  // mm off the surface, and
const float kBias = 1.2 / kExtent;        // towards the light: against shadowing itself

float look(vec3 in_map, vec2 off) {
  return textureLod(shadow_map, in_map + vec3(kApart * off, 0.0), 0.0);
}

// 0..1, the mean of 5 x 5 looks. First the corners and the middle; where these agree, which is nearly
// everywhere, that is all. One loop for both, since the processor goes through both ways of a
// condition, and through a loop once in any case.
float key_arriving(vec3 at, vec3 normal) {
  vec3 in_map = (map_from_world * vec4(at + kLift * normal, 1.0)).xyz;
  in_map.z -= kBias;
  float middle = 0.0;
  float sum = 0.0;
  int rounds = 1;
  for (int round = 0; round < rounds; ++round) {
    bool is_first = round == 0;
    float y = float(round) - 3.0;   // of the row, from the second round on
    float seen = look(in_map, vec2(-2.0, is_first ? -2.0 : y)) +
                 look(in_map, is_first ? vec2(-2.0, 2.0) : vec2(-1.0, y)) +
                 look(in_map, vec2(0.0, is_first ? 0.0 : y)) +
                 look(in_map, is_first ? vec2(2.0, -2.0) : vec2(1.0, y)) +
                 look(in_map, vec2(2.0, is_first ? 2.0 : y));
    if (is_first) {
      rounds = seen > 0.5 && seen < 4.5 ? 6 : 1;
      middle = seen;
    } else {
      sum += seen;
    }
  }
  return rounds == 1 ? middle / 5.0 : sum / 25.0;
}

vec3 key_light(vec3 at, vec3 normal) {
  return key_through(mix(shadow_floor * v_scattered_in_mouth, 1.0, key_arriving(at, normal)));
}
