function shaderOf(gl, kind, id) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, document.getElementById(id).text);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
  return shader;
}

function programOf(gl, vertexId, fragmentId) {
  const program = gl.createProgram();
  gl.attachShader(program, shaderOf(gl, gl.VERTEX_SHADER, vertexId));
  gl.attachShader(program, shaderOf(gl, gl.FRAGMENT_SHADER, fragmentId));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}
