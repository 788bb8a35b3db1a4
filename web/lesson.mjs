// What the HTML of a lesson gets beyond Markdown.
import { word } from './words.mjs';

const isElsewhere = (link) => /^[a-z]+:/.test(link);
const entity = { '&quot;': '"', '&amp;': '&', '&lt;': '<', '&gt;': '>' };

// Each link to a file by what `to(link)` makes of it; a link within the page and one to elsewhere stay.
export const linksIn = (html, to) =>
  html.replace(/(<a href=")([^"#][^"]*)"/g, (all, before, link) => (isElsewhere(link) ? all : `${before}${to(link)}"`));

// Each picture with the size that `sizeOf(link)` tells, so that nothing moves as it arrives.
export const imagesIn = (html, sizeOf) =>
  html.replace(/<img src="([^"]+)"/g, (_, link) => {
    const { width, height, src = link } = sizeOf(link);
    return `<img src="${src}"${width ? ` width="${width}" height="${height}"` : ''} loading="lazy"`;
  });

// A heading's anchor, as the pages' links have it: its words in small letters with - between them.
export const anchorOf = (heading) =>
  heading
    .replace(/<[^>]*>/g, '')
    .replace(/&\w+;/g, (one) => entity[one] ?? '')
    .toLowerCase()
    .replace(/[^\w\- ]/g, '')
    .replace(/ /g, '-');
export const numbered = (html) =>
  html.replace(/<h([23])>(.*?)<\/h\1>/g, (all, level, words) => `<h${level} id="${anchorOf(words)}">${words}</h${level}>`);

// In a section of questions each answer is folded below its question, a paragraph that begins in bold or italics.
export function fold(html) {
  return html
    .split(/(?=<h2)/)
    .map((section) => {
      if (!/^<h2[^>]*>[^<]*[Qq]uestion/.test(section)) return section;
      return section
        .split(/(?=<p><(?:strong|em)>)/)
        .map((part) => {
          const found = part.match(/^<p><(strong|em)>(.*?)<\/\1>\s*(.*)$/s);
          if (!found) return part;
          const [, , question, rest] = found;
          const answer = rest.startsWith('</p>') ? rest.slice(4) : `<p>${rest}`;
          return `<details><summary>${question}</summary>\n${answer.trim()}\n</details>\n`;
        })
        .join('');
    })
    .join('');
}

// A quotation with letters that only Icelandic has is spoken so.
export const quotations = (html) => html.replace(/&quot;([^&<]*[þðæ][^&<]*)&quot;/gi, '&quot;<span lang="is">$1</span>&quot;');

// A table moves sideways where the page is too narrow for it, by the keyboard, too.
export function wide(html) {
  let count = 0;
  const opening = () => `<div class="wide" tabindex="0" role="region" aria-label="${word('table')} ${++count}"><table>`;
  // A column without a name is none to a screen reader; a long line of code moves sideways, by the keyboard, too.
  return html.replace(/<th><\/th>/g, '<td></td>').replace(/<pre>/g, '<pre tabindex="0">').replace(/<table>/g, opening).replace(/<\/table>/g, '</table></div>');
}
