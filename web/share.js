// What leaves a page: its picture, a film of it, a link to all that it shows, and a frame for another page.
import { tag } from './controls.js';

export function asCanvas(width, height, pixels) {
  const copy = tag('canvas', { width, height });
  copy.getContext('2d').putImageData(new ImageData(pixels, width, height), 0, 0);
  return copy;
}

function handOver(blob, file) {
  const link = tag('a', { href: URL.createObjectURL(blob), download: file });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// Both pictures of a comparison as they are seen, with the line and what each is.
function besides(picture, second, at, labels, density) {
  const { width, height } = picture, pen = picture.getContext('2d'), line = Math.round(width * at);
  if (line < width) pen.drawImage(second, line, 0, width - line, height, line, 0, width - line, height);
  pen.fillStyle = '#fff';
  pen.fillRect(line - density, 0, 2 * density, height);
  pen.scale(density, density);
  pen.font = '16px sans-serif';
  labels.forEach((label, i) => {
    const wide = pen.measureText(label).width + 16, left = i ? width / density - wide : 0, low = height / density;
    pen.fillStyle = '#000a';
    pen.fillRect(left, low - 26, wide, 26);
    pen.fillStyle = '#fff';
    pen.fillText(label, left + 8, low - 8);
  });
  return picture;
}

// Its buttons. `frame()` is the number of the frame that is shown, `density()` the picture's pixels for each of the page's, `address(search)` where all of it is found again, `redraw()` draws the
// picture once more.
export function shareButtons({ name, canvas, demo, compare, frame, density, address, redraw, isWide, isEmbedded }) {
  function save() {
    const { width, height } = canvas, size = width * height, picture = asCanvas(width, height, demo.pixels(size));
    if (compare.on()) besides(picture, asCanvas(width, height, compare.second().pixels(size)), compare.at(), compare.labels(), density());
    picture.toBlob((blob) => handOver(blob, `${name}-${frame()}.png`));
  }

  // Where there is no clipboard, as on a host without TLS, the words are shown to be copied by hand.
  async function copy({ target: button }, words) {
    const before = (button.dataset.says ??= button.textContent);
    try {
      await navigator.clipboard.writeText(words);
      button.textContent = word('copied');
    } catch {
      prompt(word('copyHere'), words);
    }
    setTimeout(() => (button.textContent = before), 2000);
  }
  const embedded = () => `<iframe src="${address('?embed').replaceAll('&', '&amp;')}" width="${isWide ? 1000 : 700}" height="500" allow="fullscreen; clipboard-write" title="mvgl: ${name}"></iframe>`;

  // What the canvas shows from one press to the next.
  let recorder;
  function film({ target: button }) {
    if (recorder) return recorder.stop();
    const parts = [], told = (on) => {
      button.setAttribute('aria-pressed', on);
      button.textContent = word(on ? 'recordEnd' : 'record');
    };
    recorder = new MediaRecorder(canvas.captureStream());
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onstop = () => {
      handOver(new Blob(parts, { type: recorder.mimeType }), `${name}.${recorder.mimeType.includes('mp4') ? 'mp4' : 'webm'}`);
      recorder = undefined;
      told(false);
    };
    recorder.start();
    redraw(); // a film begins with what is drawn next, and a picture that rests draws nothing
    told(true);
  }

  const button = (words, onclick, more) => tag('button', { type: 'button', onclick, ...more }, words);
  return [
    button(word('save'), save),
    button(word('copyLink'), (event) => copy(event, address(location.search))),
    isEmbedded ? '' : button(word('copyFrame'), (event) => copy(event, embedded())),
    canvas.captureStream && globalThis.MediaRecorder ? button(word('record'), film, { 'aria-pressed': 'false' }) : '',
  ];
}
