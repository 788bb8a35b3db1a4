// Asks before each draw for what OpenGL leaves undefined, and some drivers draw as if nothing were wrong.
//
// A listener over the function table, for tests and for --audit: it costs some dozens of questions a draw. The watch
// keeps nothing of OpenGL's state, which it asks the driver for; what no question tells it notes: what was written into
// buffers that began without contents, and which queries are open. (A uniform that was not set is no fault: OpenGL says
// that it is 0.)
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
// - queries and transform feedback are begun, ended and asked in this order.
void watchUndefined(bool on);
bool watchingUndefined();

}  // namespace mv
