// words.js: names of what elements are coloured by, for people, and numbers as text.

// The metrics' own words come with the data.
const otherWords = {
  face: {label: 'face', text: 'The region of the boundary that the element belongs to.', unit: ''},
  validity: {
    label: 'validity',
    text: 'Valid and invalid are proved for the numbers as stored; degenerate elements touch det J = 0.',
    unit: ''
  },
};
const fieldWords = (name) => ({
  label: `field ${name.slice('field:'.length)}`,
  text: 'A field that the mesh carries. Bars count elements by the value in their middle.',
  unit: ''
});
const wordsOf = (name) => settings.metrics[name] ?? otherWords[name] ??
    (name.startsWith('field:') ? fieldWords(name) : {label: name, text: '', unit: ''});
const metricTitle = (name) => wordsOf(name).label;
const metricText = (name) => wordsOf(name).text;
const metricUnit = (name) => wordsOf(name).unit;
const validityWords = ['valid', 'degenerate', 'invalid'];

const count = (number) => number.toLocaleString('en-US');
const plural = (number, word) => `${count(number)} ${word}${number === 1 ? '' : 's'}`;

// A number to so many significant digits, and one more for each power of ten by which it is above `size`: so numbers
// that differ by a part of `size` stay different.
function rounded(value, digits, size = Infinity) {
  const more = size > 0 ? Math.max(0, Math.floor(Math.log10(Math.abs(value) / size))) : 0;
  return Number(value.toPrecision(Math.min(17, digits + more)));
}

// A few significant digits, as `rounded` has them; what does not exist is a dash.
function short(value, digits = 4, size = Infinity) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '\u2013';
  return String(rounded(value, digits, size)).replace('-', '\u2212');
}

// Elements of the page from here on get text only as text, never as markup.
function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on'))
      node.addEventListener(name.slice(2), value);
    else if (value === true)
      node.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined)
      node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

function makeSvg(tag, attributes = {}, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

const byId = (id) => document.getElementById(id);
