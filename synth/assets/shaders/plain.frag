// One colour, without light.

uniform vec3 plain_colour;   // linear

out vec4 colour;

void main() {
  colour = vec4(plain_colour, 1.0);
}
