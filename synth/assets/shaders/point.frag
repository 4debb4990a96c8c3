// Round.

uniform vec3 plain_colour;   // linear

out vec4 colour;

void main() {
  if (distance(gl_PointCoord, vec2(0.5)) > 0.5) discard;
  colour = vec4(plain_colour, 1.0);
}
