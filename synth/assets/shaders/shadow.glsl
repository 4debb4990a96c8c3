// How much of the key light arrives, from the map of what it meets first.

in float v_scattered_in_mouth;

uniform sampler2DShadow shadow_map;
uniform mat4 map_from_world;
uniform float shadow_floor;   // light that reaches a translucent part in spite of what covers it

const float kExtent = 370.0;              // mm that the map is wide and deep
const float kApart = 0.8 / kExtent;       // between two looks
const float kLift = 0.8;                  // mm off the surface, and
const float kBias = 1.2 / kExtent;        // towards the light: against shadowing itself

// 0..1, the mean of 5 x 5 looks. Where the outermost agree, which is nearly everywhere, the others
// are not taken: a loop, since the processor would go through both ways of a condition.
float key_arriving(vec3 at, vec3 normal) {
  vec3 in_map = (map_from_world * vec4(at + kLift * normal, 1.0)).xyz;
  in_map.z -= kBias;
  float corners = texture(shadow_map, in_map + kApart * vec3(-2.0, -2.0, 0.0)) +
                  texture(shadow_map, in_map + kApart * vec3(2.0, -2.0, 0.0)) +
                  texture(shadow_map, in_map + kApart * vec3(-2.0, 2.0, 0.0)) +
                  texture(shadow_map, in_map + kApart * vec3(2.0, 2.0, 0.0)) +
                  texture(shadow_map, in_map);
  int rows = corners > 0.001 && corners < 4.999 ? 5 : 0;
  float sum = 0.0;
  for (int row = 0; row < rows; ++row) {
    vec3 left = in_map + kApart * vec3(-2.0, float(row) - 2.0, 0.0);
    sum += texture(shadow_map, left) + texture(shadow_map, left + kApart * vec3(1.0, 0.0, 0.0)) +
           texture(shadow_map, left + kApart * vec3(2.0, 0.0, 0.0)) +
           texture(shadow_map, left + kApart * vec3(3.0, 0.0, 0.0)) +
           texture(shadow_map, left + kApart * vec3(4.0, 0.0, 0.0));
  }
  return rows == 0 ? corners / 5.0 : sum / 25.0;
}

vec3 key_light(vec3 at, vec3 normal) {
  return key_through(mix(shadow_floor * v_scattered_in_mouth, 1.0, key_arriving(at, normal)));
}
