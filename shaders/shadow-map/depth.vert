uniform mat4 mapClipFromObject;
in vec4 position;

void main() { gl_Position = mapClipFromObject * position; }
