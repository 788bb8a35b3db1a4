// The corners of a patch go on as they are: nothing is known here of the patch.
in vec3 position;
out vec3 corner;

void main() { corner = position; }
