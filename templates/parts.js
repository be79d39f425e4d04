// Shows the parts of a page (src/pages/page.h): texts, tables, plots.
'use strict';

const COLORS = ['#1f5fa8', '#e08a2c', '#2a9d5c', '#c0392b', '#7d4fa0', '#17a2b8', '#8d6e63', '#555555'];
const WIDTH = 900, LEFT = 84, RIGHT = 14, TOP = 8, BOTTOM = 24;  // of plots, in SVG units
const PLOT_HEIGHT = 170, BAND_STEP = 20, BAR_HEIGHT = 9, BAR_GAP = 8;

function bytesOf(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}
const floatsOf = base64 => new Float32Array(bytesOf(base64).buffer);
const shortsOf = base64 => new Int16Array(bytesOf(base64).buffer);

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children.filter(child => child !== null));
  return node;
}
const html = (kind, attributes = {}, ...children) => fill(document.createElement(kind), attributes, children);
const svg = (kind, attributes = {}, ...children) =>
  fill(document.createElementNS('http://www.w3.org/2000/svg', kind), attributes, children);

/** The time that the page shows: the player sets it, plots over time follow it. */
const timeline = {
  seconds: new Float32Array(0), frame: 0, playing: false, followers: [],
  /** When the frame ends: when the next one begins; the last is as long as the others on average. */
  end(frame) {
    const s = this.seconds, last = s.length - 1;
    if (frame < last) return s[frame + 1];
    return last > 0 ? s[last] + (s[last] - s[0]) / last : (s[0] || 0) + 1;
  },
  frameAt(seconds) {
    let low = 0, high = this.seconds.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.seconds[middle] <= seconds) low = middle; else high = middle - 1;
    }
    return low;
  },
  go(frame) {
    this.frame = Math.max(0, Math.min(this.seconds.length - 1, frame));
    for (const follower of this.followers) follower(this.frame);
  },
  seek(seconds) { this.go(this.frameAt(seconds)); },
};

/** The smallest of 1, 2, 5 times a power of ten that is at least range / parts. */
function roundStep(range, parts) {
  if (!(range > 0)) return 1;
  const least = range / parts, power = Math.pow(10, Math.floor(Math.log10(least)));
  return ([1, 2, 5].find(factor => factor * power >= least * (1 - 1e-9)) || 10) * power;
}
const roundUp = value => {
  const step = roundStep(value, 5);
  return value > 0 ? step * Math.ceil(value / step - 1e-9) : 1;
};
const short = value => String(Number(value.toPrecision(6)));

const frameOf = height => svg('svg', {viewBox: `0 0 ${WIDTH} ${height}`});
const label = (x, y, anchor, text) => svg('text', {x, y, 'text-anchor': anchor}, text);
const gridLine = (x0, y0, x1, y1) => svg('path', {d: `M${x0} ${y0}L${x1} ${y1}`, stroke: '#ddd'});
function box(x, y, width, height, color, title) {
  return svg('rect', {x, y, width, height, fill: color}, title ? svg('title', {}, title) : null);
}
function ticks(low, high, parts, draw) {
  const step = roundStep(high - low, parts);
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    draw(k * step, (k + 1) * step > high + 1e-9 * step);
}

/** An axis from `low` to `high` across a plot. */
function across(low, high) {
  const scale = (WIDTH - LEFT - RIGHT) / (high - low || 1);
  return {low, high, at: value => LEFT + (value - low) * scale};
}
const timeAxis = () => across(timeline.seconds[0] || 0, timeline.end(timeline.seconds.length - 1));
function drawAcross(plot, axis, height, unit) {
  ticks(axis.low, axis.high, 10, value => plot.append(
    gridLine(axis.at(value), TOP, axis.at(value), height - BOTTOM),
    label(axis.at(value), height - 8, 'middle', short(value) + (unit ? ' ' + unit : ''))));
}

function legend(entries) {
  return html('div', {class: 'legend'}, ...entries.filter(e => e.name).map(
    entry => html('span', {}, html('i', {style: 'background:' + entry.color}), entry.name, entry.value || null)));
}

/** The path of a curve; where there are many more values than pixels, their extremes. */
function pathOf(x, y, values) {
  const every = Math.max(1, Math.floor(values.length / 1800));
  let path = '', drawing = false;
  const point = i => {
    path += `${drawing ? 'L' : 'M'}${x(i).toFixed(1)} ${y(values[i]).toFixed(1)}${drawing ? '' : 'h0'}`;
    drawing = true;
  };
  for (let begin = 0; begin < values.length; begin += every) {
    let least = begin, most = begin, known = true;
    for (let i = begin; i < Math.min(values.length, begin + every); ++i) {
      known = known && Number.isFinite(values[i]);
      if (values[i] < values[least]) least = i;
      if (values[i] > values[most]) most = i;
    }
    if (!known) drawing = false;
    else for (const i of new Set([Math.min(least, most), Math.max(least, most)])) point(i);
  }
  return path;
}

/** Lets a plot over the frames show the time and set it. `tell` is called with the frame. */
function timed(plot, tell) {
  const cursor = html('div', {class: 'cursor'}), wrapper = html('div', {class: 'plot timed'}, plot, cursor);
  const axis = timeAxis();
  let seen = true, told = 0;
  const follow = frame => {
    if (!seen) return;
    cursor.style.left = 100 * axis.at(timeline.seconds[frame]) / WIDTH + '%';
    const now = performance.now();
    if (!tell || (timeline.playing && now - told < 200)) return;
    told = now;
    tell(frame);
  };
  if (window.IntersectionObserver)
    new IntersectionObserver(entries => { seen = entries.at(-1).isIntersecting; follow(timeline.frame); }).observe(wrapper);
  timeline.followers.push(follow);
  const set = event => {
    const place = wrapper.getBoundingClientRect();
    const x = (event.clientX - place.left) / place.width * WIDTH;
    timeline.seek(axis.low + (x - LEFT) / (WIDTH - LEFT - RIGHT) * (axis.high - axis.low));
  };
  wrapper.addEventListener('pointerdown', set);
  wrapper.addEventListener('pointermove', event => { if (event.buttons & 1) set(event); });
  follow(timeline.frame);
  return wrapper;
}

function linesPart(part) {
  const lines = part.lines.map((line, i) =>
    ({name: line.name, color: line.color || COLORS[i % COLORS.length], values: floatsOf(line.values), value: html('b')}));
  const own = part.x === undefined ? null : floatsOf(part.x);
  const x = own || timeline.seconds;
  let low = 0, top = part.top || 0;
  for (const line of lines)
    for (const value of line.values) {
      if (!part.top && value > top) top = value;
      if (value < low) low = value;
    }
  top = part.top || (top > 0 || low === 0 ? roundUp(top) : 0);
  low = low < 0 ? -roundUp(-low) : 0;
  const plot = frameOf(PLOT_HEIGHT);
  const axis = own ? across(x[0] || 0, x.length > 1 ? x[x.length - 1] : (x[0] || 0) + 1) : timeAxis();
  drawAcross(plot, axis, PLOT_HEIGHT, own ? part.across : 's');
  const y = value => PLOT_HEIGHT - BOTTOM -
    (PLOT_HEIGHT - TOP - BOTTOM) * (Math.max(low, Math.min(top, value)) - low) / (top - low);
  ticks(low, top, 5, (value, last) => plot.append(gridLine(LEFT, y(value), WIDTH - RIGHT, y(value)),
    label(LEFT - 4, y(value) + 4, 'end', short(value) + (last && part.unit ? ' ' + part.unit : ''))));
  for (const line of lines)
    plot.append(svg('path', {fill: 'none', 'stroke-width': 1.6, 'stroke-linecap': 'round', 'stroke-linejoin': 'round',
      stroke: line.color, d: pathOf(i => axis.at(x[i]), y, line.values)}));
  if (own) return [legend(lines.map(({name, color}) => ({name, color}))), html('div', {class: 'plot'}, plot)];
  const digits = top - low > 50 ? 0 : top - low > 5 ? 1 : 2;
  const tell = frame => {
    for (const line of lines)
      line.value.textContent = ' ' + (Number.isFinite(line.values[frame]) ? line.values[frame].toFixed(digits) : '–');
  };
  return [legend(lines), timed(plot, tell)];
}

function drawRuns(plot, axis, runs, states, y, height) {
  for (const [first, next, state, why] of runs) {
    const from = timeline.seconds[first], to = timeline.end(next - 1);
    const title = `${states[state].name}${why ? ': ' + why : ''}, ${from.toFixed(2)} s to ${to.toFixed(2)} s`;
    plot.append(box(axis.at(from), y, Math.max(1.2, axis.at(to) - axis.at(from) + .3), height, states[state].color, title));
  }
}
function bandsPart(part) {
  const height = TOP + BAND_STEP * part.bands.length + BOTTOM, plot = frameOf(height), axis = timeAxis();
  drawAcross(plot, axis, height, 's');
  part.bands.forEach((band, i) => {
    const y = TOP + BAND_STEP * i;
    plot.append(label(LEFT - 6, y + BAND_STEP / 2 + 3, 'end', band.name));
    drawRuns(plot, axis, band.runs, part.states, y, BAND_STEP - 3);
  });
  return [legend(part.states), timed(plot)];
}

function barsPart(part) {
  const row = BAR_HEIGHT * part.names.length + BAR_GAP, height = TOP + row * part.rows.length + BOTTOM;
  const most = Math.max(0, ...part.rows.flatMap(r => r.values.filter(v => v !== null)));
  const plot = frameOf(height), axis = across(0, roundUp(most));
  ticks(0, axis.high, 8, value => plot.append(
    gridLine(axis.at(value), TOP, axis.at(value), height - BOTTOM),
    label(axis.at(value), height - 8, value === axis.high ? 'end' : 'middle', `${short(value)} ${part.unit}`)));
  part.rows.forEach((one, r) => {
    const y = TOP + row * r;
    plot.append(label(LEFT - 6, y + row / 2 + 1, 'end', one.name));
    one.values.forEach((value, k) => {
      if (value !== null)
        plot.append(box(LEFT, y + BAR_HEIGHT * k, axis.at(value) - LEFT, BAR_HEIGHT, COLORS[k],
          `${value.toFixed(1)} ${part.unit}`));
    });
  });
  return [legend(part.names.map((name, k) => ({name, color: COLORS[k]}))), html('div', {class: 'plot'}, plot)];
}

function histogramPart(part) {
  const bins = 40, values = [...floatsOf(part.values)].filter(Number.isFinite);
  const axis = across(0, roundUp(values.reduce((a, b) => Math.max(a, b), 0))), counts = Array(bins).fill(0);
  for (const value of values) ++counts[Math.min(bins - 1, Math.floor(value / axis.high * bins))];
  const top = roundUp(Math.max(...counts)), plot = frameOf(PLOT_HEIGHT);
  const y = count => PLOT_HEIGHT - BOTTOM - (PLOT_HEIGHT - TOP - BOTTOM) * count / top;
  ticks(0, top, 5, value => plot.append(gridLine(LEFT, y(value), WIDTH - RIGHT, y(value)),
    label(LEFT - 4, y(value) + 4, 'end', short(value))));
  counts.forEach((count, b) => plot.append(box(axis.at(b / bins * axis.high) + .5, y(count),
    (WIDTH - LEFT - RIGHT) / bins - 1, y(0) - y(count), COLORS[0], String(count))));
  ticks(0, axis.high, 10, value => plot.append(label(axis.at(value), PLOT_HEIGHT - 8,
    value >= axis.high * (1 - 1e-9) ? 'end' : 'middle', `${short(value)} ${part.unit}`)));
  return [html('div', {class: 'plot'}, plot)];
}

/** A cell is a text, or {"text", "href"}, or {"text", "fault": true} over the rest of the row. */
function tablePart(part) {
  const figures = part.head.map(name => name.startsWith('#'));
  const head = html('tr', {}, ...part.head.map(
    (name, i) => html('th', figures[i] ? {class: 'n'} : {}, name.replace(/^#/, ''))));
  const cellOf = (cell, i) => {
    if (cell.fault) return html('td', {class: 'fault', colspan: part.head.length - i}, cell.text);
    return html('td', figures[i] ? {class: 'n'} : {}, cell.href ? html('a', {href: cell.href}, cell.text) : cell);
  };
  const rows = part.rows.map((row, r) =>
    html('tr', (part.strong || []).includes(r) ? {class: 'strong'} : {}, ...row.map(cellOf)));
  const named = part.head.some(name => name !== '' && name !== '#');
  return [html('div', {class: 'wide'}, html('table', part.head.length > 12 ? {class: 'dense'} : {}, named ? head : null, ...rows))];
}

function residualsPart(part) {
  const arrows = (packed, color, width) => {
    const n = floatsOf(packed);
    let path = '';
    for (let i = 0; i + 3 < n.length; i += 4)
      path += `M${n[i].toFixed(0)} ${n[i + 1].toFixed(0)}l${(part.longer * n[i + 2]).toFixed(0)} ${(part.longer * n[i + 3]).toFixed(0)}`;
    return svg('path', {stroke: color, fill: 'none', 'stroke-linecap': 'round', 'stroke-width': width / 500, d: path});
  };
  return [html('div', {class: 'tiles'}, ...part.cameras.map(({name, size, used, left_out}) =>
    html('figure', {}, svg('svg', {viewBox: `0 0 ${size[0]} ${size[1]}`, style: 'background:#f4f4f4'},
      arrows(used, COLORS[0], size[0]), arrows(left_out, COLORS[3], size[0])), html('figcaption', {}, name))))];
}

const KINDS = {
  heading: part => [html('h' + part.level, {}, part.text)],
  text: part => [html('p', {}, part.strong ? html('b', {}, part.text) : part.text)],
  cards: part => [html('div', {class: 'cards'}, ...part.cards.map(
    card => html('div', {class: 'card'}, html('b', {}, card.value), html('span', {}, card.meaning))))],
  table: tablePart, lines: linesPart, bands: bandsPart, bars: barsPart, histogram: histogramPart, residuals: residualsPart,
  picture: part => [html('figure', {}, html('img', {src: 'data:image/jpeg;base64,' + part.jpeg, alt: part.caption}),
    html('figcaption', {}, part.caption))],
};

function showPage(page, main) {
  document.title = page.title;
  main.append(html('h1', {}, page.title));
  for (const part of page.parts)
    if (part.kind === 'player') timeline.seconds = floatsOf(part.seconds);
  for (const part of page.parts) main.append(...KINDS[part.kind](part));
  if (timeline.seconds.length) timeline.seek(parseFloat((location.hash.match(/^#t=(.*)/) || [0, 0])[1]) || 0);
}
