// The clear shell before the iris: only what it mirrors, the key light as a window.

uniform vec3 camera;
uniform vec3 fill_direction;

// 1 where the mirrored direction meets a rectangle of half angles `size` (tangents) round a light.
float window(vec3 mirrored, vec3 light, vec2 size) {
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), light));
  vec3 up = cross(light, right);
  float forward = dot(mirrored, light);
  vec2 at = abs(vec2(dot(mirrored, right), dot(mirrored, up))) / max(forward, 0.01);
  vec2 within = 1.0 - smoothstep(0.8 * size, 1.15 * size, at);
  return forward > 0.0 ? within.x * within.y : 0.0;
}

void main() {
  vec3 normal = normalize(v_normal);
  vec3 to_camera = normalize(camera - v_position);
  vec3 mirrored = reflect(-to_camera, normal);
  float light = 1.5 * window(mirrored, key_direction, vec2(0.20, 0.24)) +
                0.28 * window(mirrored, fill_direction, vec2(0.16, 0.30));
  light *= mix(0.35, 1.0, smoothstep(0.78, 0.88, v_rest.z));   // the white round it mirrors less
  float grazing = 1.0 - clamp(dot(normal, to_camera), 0.0, 1.0);
  float fresnel = 0.03 + 0.5 * pow(grazing, 5.0);
  vec3 mirror = vec3(light) + vec3(0.50, 0.55, 0.60) * fresnel * 0.5;
  colour = vec4(min(mirror, vec3(1.0)), 0.5 * fresnel);   // premultiplied
}
