// Reads {name: script} as JSON, and writes it with each script as short as terser makes it: without comments and spaces, and with
// short names inside of functions. Scripts that import or export are modules. Started by make.mjs, with NODE_PATH where Debian's
// packages are.
const { minify } = require('terser');

(async () => {
  const scripts = JSON.parse(require('fs').readFileSync(0, 'utf8'));
  for (const [name, text] of Object.entries(scripts)) {
    const { code } = await minify(text, { module: /^(import|export) /m.test(text), compress: { passes: 2 } });
    scripts[name] = code;
  }
  process.stdout.write(JSON.stringify(scripts));
})();
