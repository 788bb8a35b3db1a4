// Asks before each draw for what OpenGL leaves undefined, and some drivers draw as if nothing were wrong.
//
// A listener over the function table, for tests and for --audit: it costs some dozens of questions a draw. It keeps nothing of
// OpenGL's state, which it asks the driver for; what no question tells it notes: what was written into buffers that began without
// contents, which queries are open, and which uniforms were not set since their program was linked. (OpenGL says that they are
// 0, so that nothing is undefined: it is a mistake all the same.)
#pragma once

namespace mv {

// Begins or ends to watch, this context and those after it; OpenGL ES, which has not all of the questions, is not watched. Each
// fault is among the next takeErrors(), as a sentence: "draw of 'floor': sampler shadowMap reads unit 0, where no texture is
// bound". The checks:
// - each sampler's unit holds a complete texture of the sampler's kind, whose contents were written, and no other kind of
//   sampler reads that unit; a shadow sampler's compares depths, another one's does not;
// - no texture is read at a level that the draw writes;
// - each enabled attribute has a buffer that reaches as far as the draw's vertices, and indices lie within theirs;
// - the framebuffer is complete, and what a depth test, a stencil test, blending, a blit or a read-back reads was written;
// - no point or line is drawn while GL_POLYGON_OFFSET_FILL is on: SwiftShader pushes them, too, by whatever slope it finds;
// - queries and transform feedback are begun, ended and asked in this order;
// - each uniform that the program uses was set. Left out are arrays, of which a program reads as many elements as another uniform
//   says; samplers and images, which begin with unit 0 or the shader's: what that unit holds is asked above; and draws of depths or
//   stencil values alone, whose colour nobody sees.
void watchUndefined(bool on);
bool watchingUndefined();

}  // namespace mv
