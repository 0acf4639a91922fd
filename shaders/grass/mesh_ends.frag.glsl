// Where rays leave a shell over a mesh, through sides that look away from the eye: how steeply, and of which part of
// which surface.
in vec3 position;
in vec3 normal;
flat in float part;
layout(location = 0) out vec2 leaving;

void main() { leaving = vec2(dot(normalize(normal), normalize(position)), part); }
