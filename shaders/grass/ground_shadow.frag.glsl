// Shadow of a blade on the ground: what is left of its light, multiplied onto the picture.
in vec3 left;
out vec4 color;

void main() { color = vec4(clamp(left, vec3(0.0), vec3(1.0)), 1.0); }
