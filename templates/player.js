// Shows what moves (src/tools/common/player.h): body, hull and cameras in space, the views, the line of time.
// A page with it contains three.js r111 (Debian's libjs-three), which is under the MIT licence:
//
// Copyright © 2010-2017 three.js authors
//
// Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
// documentation files (the "Software"), to deal in the Software without restriction, including without limitation
// the rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and
// to permit persons to whom the Software is furnished to do so, subject to the following conditions:
//
// The above copyright notice and this permission notice shall be included in all copies or substantial portions of
// the Software.
//
// THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO
// THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
// AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF
// CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS
// IN THE SOFTWARE.
'use strict';

const OUTLINES = [['unknown', '#4aa3ff', 'not known'], ['mask', '#ff4040', 'mask'], ['body', '#4ade50', 'fitted body']];
const OUTLINE_UNITS = 2048, VIEW_WIDTH = 400;

/** The item of the last frame that is not after this one; null before the first. */
function itemAt(items, frame) {
  let low = -1, high = items.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (items[middle].frame <= frame) low = middle; else high = middle - 1;
  }
  return low < 0 ? null : items[low];
}

/** A truncated cone with round ends from (0, 0, 0) to (0, length, 0). */
function roundCone(length, radii) {
  const [a, b] = radii, points = [], arc = (y, radius, from, to) => {
    for (let k = 0; k <= 5; ++k) {
      const angle = from + (to - from) * k / 5;
      points.push(new THREE.Vector2(Math.max(1e-5, radius * Math.cos(angle)), y + radius * Math.sin(angle)));
    }
  };
  const lean = length > 0 ? (a - b) / length : 2;
  if (Math.abs(lean) >= 1) arc(a >= b ? 0 : length, Math.max(a, b), -Math.PI / 2, Math.PI / 2);
  else {
    arc(0, a, -Math.PI / 2, Math.asin(lean));
    arc(length, b, Math.asin(lean), Math.PI / 2);
  }
  return new THREE.LatheBufferGeometry(points, 12);
}

/** The cones of a link as one mesh: a browser that draws by software pays for each. */
function meshOf(cones, opacity) {
  const all = {position: [], normal: [], color: []}, index = [];
  for (const cone of cones) {
    const from = new THREE.Vector3(...cone.a), along = new THREE.Vector3(...cone.b).sub(from), length = along.length();
    const turn = new THREE.Quaternion();
    if (length > 0) turn.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.divideScalar(length));
    const one = roundCone(length, cone.radii), before = all.position.length / 3;
    one.applyMatrix(new THREE.Matrix4().compose(from, turn, new THREE.Vector3(1, 1, 1)));
    for (const i of one.index.array) index.push(before + i);
    for (const name of ['position', 'normal']) all[name].push(...one.attributes[name].array);
    for (let i = 0; i < one.attributes.position.count; ++i) all.color.push(...cone.color);
  }
  const geometry = new THREE.BufferGeometry();
  for (const [name, values] of Object.entries(all)) geometry.setAttribute(name, new THREE.Float32BufferAttribute(values, 3));
  geometry.setIndex(index);
  return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({vertexColors: THREE.VertexColors, transparent: opacity < 1, opacity}));
}

/** Who draws in space: 'none', 'software', for which smooth edges would cost half of the frames, or 'hardware'. */
function whoDraws() {
  const gl = document.createElement('canvas').getContext('webgl');
  if (!gl) return 'none';
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  return /swiftshader|llvmpipe|software/i.test(name) ? 'software' : 'hardware';
}

/** Poses of 7 numbers: place, then quaternion x y z w. */
function readPose(poses, at, place, turn) {
  place.fromArray(poses, at);
  turn.fromArray(poses, at + 3);
  return Number.isFinite(place.x);
}

/** The body, one mesh per link. */
function makeBody(body, poses, opacity) {
  const links = [], all = new THREE.Group(), count = body.parents.length;
  const place = new THREE.Vector3(), turn = new THREE.Quaternion(), one = new THREE.Vector3(1, 1, 1);
  for (let link = 0; link < count; ++link) {
    const cones = body.cones.filter(cone => cone.link === link);
    if (!cones.length) continue;
    const mesh = meshOf(cones, opacity);
    mesh.matrixAutoUpdate = false;
    links.push({link, mesh});
    all.add(mesh);
  }
  all.show = frame => {
    for (const {link, mesh} of links) {
      mesh.visible = readPose(poses, 7 * (frame * count + link), place, turn);
      if (mesh.visible) mesh.matrix.compose(place, turn, one);
    }
  };
  return all;
}

/** Lines from each link's origin to that of its parent. */
function makeSkeleton(parents, poses) {
  const geometry = new THREE.BufferGeometry(), ends = new THREE.BufferAttribute(new Float32Array(6 * parents.length), 3);
  geometry.setAttribute('position', ends);
  const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: '#12345c', depthTest: false}));
  lines.renderOrder = 2;
  lines.frustumCulled = false;
  lines.show = frame => {
    const at = link => 7 * (frame * parents.length + link);
    parents.forEach((parent, i) => {
      const known = parent >= 0 && Number.isFinite(poses[at(i)]) && Number.isFinite(poses[at(parent)]);
      for (let k = 0; k < 3; ++k) {
        ends.array[6 * i + k] = known ? poses[at(i) + k] : 0;
        ends.array[6 * i + 3 + k] = known ? poses[at(parent) + k] : 0;
      }
    });
    ends.needsUpdate = true;
  };
  return lines;
}

/** Surface voxels as points; they are read when their time comes. */
function makeHull(hulls) {
  const room = hulls.reduce((most, hull) => Math.max(most, hull.gaps.length), 0);  // base64: more than bytes
  const geometry = new THREE.BufferGeometry(), centers = new THREE.BufferAttribute(new Float32Array(3 * room), 3);
  geometry.setAttribute('position', centers);
  const material = new THREE.PointsMaterial({color: '#5b8fd0', size: 0.03, transparent: true, opacity: 0.3});
  const points = new THREE.Points(geometry, material);
  points.frustumCulled = false;
  let shown = null;
  points.show = frame => {
    const hull = itemAt(hulls, frame);
    if (hull === shown) return;
    shown = hull;
    let count = 0;
    if (hull) {
      const [nx, ny] = hull.size, half = hull.corner.map(value => value + hull.pitch / 2);
      let next = 0;
      for (const gap of bytesOf(hull.gaps)) {
        next += gap;
        if (gap === 255) continue;
        const cell = [next % nx, Math.floor(next / nx) % ny, Math.floor(next / (nx * ny))];
        for (let k = 0; k < 3; ++k) centers.array[3 * count + k] = half[k] + hull.pitch * cell[k];
        ++count;
        ++next;
      }
      material.size = 2 * hull.pitch;  // three.js does not count the angle of view: a voxel's size is 2.7
    }
    geometry.setDrawRange(0, count);
    centers.needsUpdate = true;
  };
  return points;
}

/** The ground truth: grey bones between its points. */
function makeTruth(truth) {
  const points = floatsOf(truth.points), all = new THREE.Group();
  const material = new THREE.MeshLambertMaterial({color: '#8a8f96'});
  const from = new THREE.Vector3(), to = new THREE.Vector3(), geometry = new THREE.CylinderBufferGeometry(.022, .022, 1, 8);
  geometry.translate(0, 0.5, 0);
  const bones = truth.bones.map(ends => ({ends, mesh: new THREE.Mesh(geometry, material)}));
  for (const bone of bones) all.add(bone.mesh);
  all.show = frame => {
    for (const {ends, mesh} of bones) {
      from.fromArray(points, 3 * (frame * truth.count + ends[0]));
      to.fromArray(points, 3 * (frame * truth.count + ends[1])).sub(from);
      const length = to.length();
      mesh.visible = length > 0;
      if (!mesh.visible) continue;
      mesh.position.copy(from);
      mesh.scale.set(1, length, 1);
      mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), to.divideScalar(length));
    }
  };
  return all;
}

function nameSprite(name) {
  const canvas = html('canvas', {width: 256, height: 64}), pen = canvas.getContext('2d');
  pen.font = '32px sans-serif';
  pen.textAlign = 'center';
  pen.fillStyle = '#555';
  pen.fillText(name, 128, 44, 250);
  const material = new THREE.SpriteMaterial({map: new THREE.CanvasTexture(canvas), depthTest: false});
  const sprite = new THREE.Sprite(material);
  sprite.scale.set(0.8, 0.2, 1);
  return sprite;
}

/** A pyramid for each camera, with its name. */
function makeCameras(cameras) {
  const all = new THREE.Group(), depth = 0.2;
  for (const camera of cameras) {
    const place = new THREE.Vector3(), turn = new THREE.Quaternion(), [x, y] = camera.tangents.map(t => t * depth);
    readPose(camera.place, 0, place, turn);
    const eye = new THREE.Vector3(), corners = [[-x, -y], [x, -y], [x, y], [-x, y]].map(c => new THREE.Vector3(...c, depth));
    const lines = new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(
      corners.flatMap((corner, i) => [eye, corner, corner, corners[(i + 1) % 4]])), new THREE.LineBasicMaterial({color: '#888'}));
    lines.position.copy(place);
    lines.quaternion.copy(turn);
    const name = nameSprite(camera.name);
    name.position.copy(place).z += 0.2;
    all.add(lines, name);
  }
  all.show = () => {};
  return all;
}

/** The middle of the floor under the person, and how far it goes. */
function groundOf(poses, step) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (let at = 0; at < poses.length; at += step)
    for (const k of [0, 1])
      if (Number.isFinite(poses[at + k])) {
        low[k] = Math.min(low[k], poses[at + k]);
        high[k] = Math.max(high[k], poses[at + k]);
      }
  if (!(low[0] <= high[0])) return {middle: [0, 0], size: 2};
  return {middle: [0, 1].map(k => (low[k] + high[k]) / 2), size: Math.max(high[0] - low[0], high[1] - low[1])};
}

/** Body, hull, skeleton, truth and cameras in space. */
class Stage {
  constructor(part, antialias) {
    this.node = html('div', {class: 'stage'});
    this.renderer = new THREE.WebGLRenderer({antialias});
    this.renderer.setClearColor('#f3f5f7');
    this.node.append(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(40, 1, 0.05, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => { this.changed = true; });
    this.links = part.body.parents.length;
    this.poses = floatsOf(part.body.poses);
    this.light();
    this.standBack();
    this.addLayers(part);
    this.resize();
    new ResizeObserver(() => this.resize()).observe(this.node);
  }
  light() {
    const sun = new THREE.DirectionalLight('#ffffff', 0.75);
    sun.position.set(2, -3, 5);
    this.scene.add(new THREE.HemisphereLight('#ffffff', '#777777', 0.55), sun);
    // The hemisphere's sky is above +y unless it is told where up is.
    this.scene.children[0].position.set(0, 0, 1);
  }
  standBack() {
    const {middle, size} = groundOf(this.poses, 7 * this.links), cells = 2 * Math.ceil(size / 2 + 1.5);
    const floor = new THREE.GridHelper(cells, 2 * cells, '#b4bac2', '#d5dae0');
    floor.rotation.x = Math.PI / 2;
    floor.position.set(Math.round(middle[0]), Math.round(middle[1]), 0);
    this.scene.add(floor);
    this.controls.target.set(...middle, 0.95);
    const back = 3.2 + 0.5 * size;
    this.camera.position.set(middle[0] + 0.8 * back, middle[1] - 0.55 * back, 1.5 + 0.15 * back);
    this.controls.update();
  }
  addLayers(part) {
    this.layers = {};
    if (part.body.cones.length) this.layers.body = makeBody(part.body, this.poses, part.truth ? 0.55 : 1);
    this.layers.skeleton = makeSkeleton(part.body.parents, this.poses);
    if (part.hulls.length) this.layers.hull = makeHull(part.hulls);
    if (part.truth) this.layers.truth = makeTruth(part.truth);
    if (part.cameras.length) this.layers.cameras = makeCameras(part.cameras);
    const bar = html('div', {class: 'layers'});
    for (const [name, layer] of Object.entries(this.layers)) {
      const tick = html('input', {type: 'checkbox'});
      layer.visible = tick.checked = name !== 'hull' || !part.truth;  // it would hide what is compared
      tick.addEventListener('change', () => { layer.visible = tick.checked; this.changed = true; });
      bar.append(html('label', {}, tick, ' ' + name));
      this.scene.add(layer);
    }
    this.node.append(bar);
  }
  resize() {
    const {clientWidth: width, clientHeight: height} = this.node;
    this.renderer.setSize(width || 640, height || 480);
    this.camera.aspect = (width || 640) / (height || 480);
    this.camera.updateProjectionMatrix();
    this.changed = true;
  }
  show(frame) {
    for (const layer of Object.values(this.layers)) layer.show(frame);
    this.changed = true;
  }
  draw() {
    if (!this.changed) return;
    this.changed = false;
    this.renderer.render(this.scene, this.camera);
  }
}

/** The fewest columns in which all views are about as high as the stage. */
function columnsFor(count, aspect) {
  const width = 470, most = 620, caption = 24;
  for (let columns = 1; columns < count; ++columns)
    if (Math.ceil(count / columns) * (width / columns * aspect + caption) <= most) return columns;
  return count;
}

/** The views of all cameras, each an image with outlines. */
class Views {
  constructor(views, cameras) {
    this.views = views;
    this.canvases = cameras.map(camera => html('canvas', {width: VIEW_WIDTH, height: VIEW_WIDTH * 0.75, title: camera.name}));
    const columns = columnsFor(cameras.length, Math.max(...views[0].cameras.map(view => view.aspect)));
    this.node = html('div', {class: 'views', style: `grid-template-columns: repeat(${columns}, 1fr)`}, ...this.canvases.map(
      (canvas, i) => html('figure', {}, canvas, html('figcaption', {}, cameras[i].name))));
    this.pictures = new Map();  // by item: its images, made shortly before they are shown
  }
  picturesOf(item) {
    if (!this.pictures.has(item)) {
      this.pictures.set(item, item.cameras.map((view, i) => {
        if (!view.jpeg) return null;
        const image = new Image();
        image.onload = () => { if (this.shown === item) this.draw(item, i); };
        image.src = 'data:image/jpeg;base64,' + view.jpeg;
        return image;
      }));
      if (this.pictures.size > 24) this.pictures.delete(this.pictures.keys().next().value);
    }
    return this.pictures.get(item);
  }
  draw(item, i) {
    const canvas = this.canvases[i], view = item.cameras[i], height = Math.round(VIEW_WIDTH * view.aspect);
    if (canvas.height !== height) canvas.height = height;
    const pen = canvas.getContext('2d'), image = this.picturesOf(item)[i];
    if (image && !image.complete) return;
    pen.fillStyle = '#333';
    pen.fillRect(0, 0, VIEW_WIDTH, height);
    if (image && image.naturalWidth) pen.drawImage(image, 0, 0, VIEW_WIDTH, height);
    for (const [kind, color] of OUTLINES) this.outline(pen, shortsOf(view[kind]), color);
  }
  outline(pen, numbers, color) {
    const scale = VIEW_WIDTH / OUTLINE_UNITS;
    pen.beginPath();
    for (let i = 0; i < numbers.length;) {
      const corners = numbers[i++];
      for (let k = 0; k < corners; ++k, i += 2) pen[k ? 'lineTo' : 'moveTo'](numbers[i] * scale, numbers[i + 1] * scale);
      pen.closePath();
    }
    pen.strokeStyle = color;
    pen.lineWidth = 1.6;
    pen.stroke();
  }
  show(frame) {
    const item = itemAt(this.views, frame);
    if (item && item !== this.shown) {
      this.shown = item;
      item.cameras.forEach((_, i) => this.draw(item, i));
    }
    const next = this.views.indexOf(item) + 1;
    for (const coming of this.views.slice(next, next + 3)) this.picturesOf(coming);
  }
}

/** Buttons, the line of time, and what is said of the frame. */
class Bar {
  constructor(part, player) {
    this.part = part;
    this.play = html('button', {title: 'space'}, '▶');
    this.play.onclick = () => (timeline.playing ? player.pause() : player.play());
    const step = (text, by, title) => {
      const button = html('button', {title}, text);
      button.onclick = () => { player.pause(); timeline.go(timeline.frame + by); };
      return button;
    };
    this.speed = html('select', {title: 'speed'}, ...['0.1', '0.25', '0.5', '1', '2', '4'].map(
      value => html('option', value === '1' ? {value, selected: ''} : {value}, value + ' ×')));
    this.now = html('span', {class: 'now'});
    this.why = html('span', {class: 'why'});
    const plot = frameOf(TOP + BAND_STEP + BOTTOM), axis = timeAxis();
    drawAcross(plot, axis, TOP + BAND_STEP + BOTTOM, 's');
    plot.append(label(LEFT - 6, TOP + 14, 'end', 'status'));
    drawRuns(plot, axis, part.status, part.states, TOP, BAND_STEP);
    this.node = html('div', {class: 'bar'}, html('div', {class: 'controls'}, this.play, step('◀', -1, 'left'), step('▶|', 1, 'right'),
      this.speed, this.now, this.why), timed(plot), legend(part.states));
  }
  show(frame) {
    const run = this.part.status.find(([first, next]) => first <= frame && frame < next);
    this.now.textContent = `${timeline.seconds[frame].toFixed(2)} s, frame ${frame}`;
    const said = run ? [this.part.states[run[2]].name + (run[3] ? ': ' + run[3] : '')] : [];
    for (const {frame: first, frames, what, why} of this.part.events)
      if (first <= frame && frame < first + frames && what !== 'no pose' && !(why && run && why === run[3]))
        said.push(what + (why ? ': ' + why : ''));
    this.why.textContent = said.join('; ');
  }
}

function eventTable(events, player) {
  const rows = events.map(event => {
    const begin = timeline.seconds[event.frame], end = timeline.end(event.frame + event.frames - 1);
    const row = html('tr', {'data-frame': event.frame}, html('td', {class: 'n'}, begin.toFixed(2)),
      html('td', {class: 'n'}, (end - begin).toFixed(2)), html('td', {}, event.what), html('td', {}, event.why));
    row.onclick = () => {
      player.pause();
      timeline.go(event.frame);
      for (const other of rows) other.classList.toggle('chosen', other === row);
    };
    return row;
  });
  const head = html('tr', {}, ...['at, s', 'for, s', 'what', 'why'].map((name, i) => html('th', i < 2 ? {class: 'n'} : {}, name)));
  return html('div', {class: 'events'}, html('table', {}, head, ...rows));
}

/** Plays the page. window.player is for those who want to drive it by a script. */
class Player {
  constructor(part) {
    const drawing = whoDraws();
    this.stage = drawing !== 'none' ? new Stage(part, drawing === 'hardware') :
      {node: html('p', {}, 'This browser has no WebGL: the body is not shown in space.'), show() {}, draw() {}};
    this.views = part.views.length ? new Views(part.views, part.cameras) : {node: null, show() {}};
    this.bar = new Bar(part, this);
    this.time = 0;
    this.drawn = 0;  // frames since the page was opened
    timeline.followers.push(frame => {
      this.stage.show(frame);
      this.views.show(frame);
      this.bar.show(frame);
      if (!this.inTick) this.time = timeline.seconds[frame];
      ++this.drawn;
    });
    document.addEventListener('keydown', event => this.key(event));
    requestAnimationFrame(now => this.tick(now));
  }
  play() {
    if (timeline.frame >= timeline.seconds.length - 1) timeline.go(0);
    timeline.playing = true;
    this.last = null;
    this.bar.play.textContent = '❚❚';
  }
  pause() {
    timeline.playing = false;
    this.bar.play.textContent = '▶';
    timeline.go(timeline.frame);
  }
  tick(now) {
    if (timeline.playing) {
      this.time += this.last ? (now - this.last) / 1000 * this.bar.speed.value : 0;
      this.last = now;
      const frame = timeline.frameAt(this.time);
      this.inTick = true;
      if (frame !== timeline.frame) timeline.go(frame);
      this.inTick = false;
      if (this.time >= timeline.end(timeline.seconds.length - 1)) this.pause();
    }
    this.stage.draw();
    requestAnimationFrame(next => this.tick(next));
  }
  key(event) {
    if (event.target.closest(event.key === ' ' ? 'input, select, button' : 'input, select')) return;
    const steps = {ArrowLeft: -1, ArrowRight: 1};
    if (event.key === ' ') timeline.playing ? this.pause() : this.play();
    else if (event.key in steps) {
      this.pause();
      timeline.go(timeline.frame + steps[event.key]);
    } else return;
    event.preventDefault();
  }
}

KINDS.player = part => {
  const player = window.player = new Player(part);
  const key = part.views.length ? legend(OUTLINES.map(([, color, name]) => ({name, color}))) : null;
  const losses = part.events.length ? [html('h2', {}, 'Where to look'), eventTable(part.events, player)] : [];
  return [html('div', {class: 'player'}, player.stage.node, player.views.node), key, player.bar.node, ...losses].filter(Boolean);
};
