// A point of light on a vertex.

layout(location = 0) in vec3 position;

uniform mat4 clip_from_world;
uniform float diameter;   // pixels

void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  gl_PointSize = diameter;
}
