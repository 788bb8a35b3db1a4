// The colour of a pixel, or where a study asks for it the demo's quantity in its place, as a number: mv::Program tells
// each program that declares `measuring`, before it draws.
uniform bool measuring;
out vec4 fragColor;

// The look of a surface: its colour, and its quantity (the lit fraction, say) where it `counts`.
void show(vec3 color, float quantity, bool counts) {
    fragColor = measuring ? vec4(counts ? quantity : -1.0) : vec4(color, 1.0);
}
