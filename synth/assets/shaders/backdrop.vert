// One triangle over the whole picture, behind everything.

out vec2 v_across;   // -0.5..0.5 in x, 0 (top) .. 1 in y

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  v_across = vec2(0.5 * corner.x, 0.5 + 0.5 * corner.y);
  gl_Position = vec4(corner, 1.0, 1.0);
}
