in vec2 v_across;

uniform vec3 centre_colour;   // linear
uniform vec3 edge_colour;

out vec4 colour;

void main() {
  vec2 off = v_across - vec2(0.0, 0.45);
  colour = vec4(mix(edge_colour, centre_colour, exp(-3.0 * dot(off, off))), 1.0);
}
