// words.js: names of the metrics for people, and numbers as text.

const metricWords = {
  jacobian: ['least det J', 'A guaranteed lower bound of the Jacobian determinant; positive on every valid element.'],
  jacobian_max: ['greatest det J', 'A guaranteed upper bound of the Jacobian determinant.'],
  scaled_jacobian:
      ['scaled Jacobian', 'Least over greatest |det J|: 1 where it is constant, negative where the element folds.'],
  shape: [
    'shape \u03c4', 'Guaranteed least \u03c4 on the element: 1 if everywhere like an equilateral triangle, 0 if flat.'
  ],
  logical_tau: ['logical \u03c4', '\u03c4 of the straight triangle on the corners.'],
  control_tau: ['control-net \u03c4', 'Least \u03c4 of the straight triangles of the control net.'],
  distortion: ['distortion D', 'Mean square of det J over its squared mean: 1 if det J is constant.'],
  logical_angle: ['least angle', 'Least angle of the straight triangle on the corners.', '\u00b0'],
  turning_angle: ['turning angle', 'The most that the control polygon of an edge turns.', '\u00b0'],
  edge_length: ['shortest edge', 'Arc length of the shortest edge.'],
  edge_length_max: ['longest edge', 'Arc length of the longest edge.'],
  element_area: ['area', 'Signed area of the element.'],
  face: ['face', 'The region of the boundary that the element belongs to.'],
  validity:
      ['validity', 'Valid and invalid are proved for the numbers as stored; degenerate elements touch det J = 0.'],
};
const metricTitle = (name) => (metricWords[name] ?? [name])[0];
const metricText = (name) => (metricWords[name] ?? ['', ''])[1];
const metricUnit = (name) => (metricWords[name] ?? [])[2] ?? '';
const validityWords = ['valid', 'degenerate', 'invalid'];

const count = (number) => number.toLocaleString('en-US');
const plural = (number, word) => `${count(number)} ${word}${number === 1 ? '' : 's'}`;

// A few significant digits; what does not exist is a dash.
function short(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '\u2013';
  return String(Number(value.toPrecision(digits))).replace('-', '\u2212');
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
