const corners = [[-1, -1, 1], [-1, 1, 1], [1, 1, 1], [1, -1, 1], [-1, -1, -1], [-1, 1, -1], [1, 1, -1], [1, -1, -1]].map((corner) => corner.map((one) => one / 2));
const colors = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]];
const faces = [[1, 0, 3, 2], [2, 3, 7, 6], [3, 0, 4, 7], [6, 5, 1, 2], [4, 5, 6, 7], [5, 4, 0, 1]];

window.onload = () => {
  const positions = [], paints = [];
  for (const [a, b, c, d] of faces) {
    for (const corner of [a, b, c, a, c, d]) positions.push(...corners[corner]), paints.push(...colors[a]);
  }
  for (const axis of [0, 1, 2]) {
    for (const end of [-1.5, 1.5]) positions.push(...[0, 1, 2].map((i) => (i === axis ? end : 0))), paints.push(...[0, 1, 2].map((i) => Number(i === axis)));
  }

  const canvas = document.getElementById('canvas');
  const gl = contextOf(canvas);
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(0.9, 1, 1, 1);
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.CULL_FACE);

  const program = programOf(gl, 'vertex-shader', 'fragment-shader');
  gl.useProgram(program);
  for (const [name, numbers] of [['vPosition', positions], ['vColor', paints]]) {
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    const place = gl.getAttribLocation(program, name);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
    gl.enableVertexAttribArray(place);
  }
  const fromBehind = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, -4, 1];
  gl.uniformMatrix4fv(gl.getUniformLocation(program, 'projection'), false, perspective(50, 0.2, 100));
  gl.uniformMatrix4fv(gl.getUniformLocation(program, 'modelview'), false, product(product(fromBehind, turned(-20, 1, 2)), turned(-30, 2, 0)));

  requestAnimationFrame(() => {
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.drawArrays(gl.TRIANGLES, 0, 36);
    gl.drawArrays(gl.LINES, 36, 6);
    performance.mark('first-picture');
    document.documentElement.className = 'is-drawn';
  });
};
