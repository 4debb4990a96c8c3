void main() {
  colour = vec4(toned(v_albedo * (v_around + 0.4 * v_key) * kExposure), 1.0);
}
