// SPDX-License-Identifier: AGPL-3.0-or-later
// The replay page: moves the eye and shows what it sees. Lengths in mm, in the sheet frame.

const element = (id) => document.getElementById(id), data = (id) => JSON.parse(element(id).textContent);
const geometry = data("geometry"), start = data("start");
const { sheet, film, aperture } = geometry;
const canvas = element("view");
const frames = [{ geometry, picture: element("frame") }];
if (element("second"))
  frames.push({ geometry: data("second-geometry"), picture: element("second") });
for (const frame of frames)
  frame.ior = start.model === "pinhole" ? 1 : frame.geometry.sheet.ior;
const film_size = film_size_of(geometry);
const offset = sheet.offset_mm ?? [0, 0], slant = slant_of(geometry);
const calm = matchMedia("(prefers-reduced-motion: reduce)");
const farthest = 1e9; // greatest distance of the eye
const within = (v, least, greatest) => Math.min(greatest, Math.max(least, v));

// The view: initially as in the page's data, replaced by the values in the address's fragment, and
// changed by the user. Fields: eye [x, y, distance], pupil, focus, gap, blur, part [x, y, width,
// height], size, raw; from the fragment only: samples, bare, tile. `contain`: whether the fragment
// gives the size or the part.
let state;

function numbers(text, count) {
  const values = (text ?? "").split(/[,x]/).map((v) => v.trim() === "" ? NaN : Number(v));
  return values.length === count && values.every(Number.isFinite) ? values : null;
}

function read_fragment() {
  const said = new URLSearchParams(location.hash.slice(1));
  const number = (name, least, greatest, otherwise) => {
    const value = numbers(said.get(name), 1);
    return value ? within(value[0], least, greatest) : otherwise;
  };
  const eye = numbers(said.get("eye"), 3), size = numbers(said.get("size"), 2);
  const own_part = numbers(said.get("part"), 4), part = own_part ?? start.part;
  const own_size = size && Math.min(...size) >= 1;
  state = {
    eye: eye && eye[2] > 0 ? eye : [...start.eye],
    pupil: number("pupil", 0, 1e6, start.pupil),
    focus: number("focus", -1e6, 1e6, start.focus),
    gap: number("film-gap", -0.999 * sheet.thickness_mm, 1e6, start.film_gap),
    blur: number("lens-blur", 0, 1e6, start.blur),
    part: part[2] > 0 && part[3] > 0 ? part : [0, 0, ...film_size],
    samples: Math.round(number("samples", 1, 64, 0)),
    size: own_size ? size.map(Math.round) : start.size[0] > 0 ? start.size : null,
    contain: Boolean(own_size || own_part),
    raw: Boolean(start.flat) || said.has("raw"),
    bare: said.has("bare"),
    tile: Math.round(number("tile", 1, 1e6, 1e6)),
  };
  focus_before_eye();
  document.body.classList.toggle("bare", state.bare);
  comparison?.begin(said.get("show"), number("split", 0, 1, 0.5));
}

function focus_before_eye() {
  state.focus = Math.max(state.focus, -0.99 * state.eye[2]);
}

// Samples across a pixel: the fragment's value, if it has one. Otherwise that of the page's data, as
// long as scattering (a pupil or blur) is on or off as in the first view. Otherwise the command's
// default: 3, or 8 with scattering.
function samples() {
  const scattered = (view) => view.pupil > 0 || view.blur > 0;
  return state.samples || (scattered(state) === scattered(start) ? start.samples : scattered(state) ? 8 : 3);
}

// Width and height of the zone in which the eye moves, mm; a zone of size 0 in one direction (a
// slit) gets equal sides.
function zone(distance) {
  const scale = distance / aperture.distance_mm, [w, h] = start.zone;
  const width = w || h || 0.4 * aperture.distance_mm;
  return [scale * width, scale * (h || width)];
}

function move_eye(x, y) {
  state.eye = [within(x, -farthest, farthest), within(y, -farthest, farthest), state.eye[2]];
  changed();
}

// Drawing.
const quick = 4; // samples across a pixel while the eye moves, at most
const gap = 8;   // between two views side by side
let gl, drawing, ready = false, drawn = "", pending = 0;
const coarse = new CoarseMode(request);
let views = [1, 1]; // number side by side, and above each other

// The part of the sheet that a view of `size` pixels shows so that it contains `part` unstretched:
// larger, beyond the sheet's edges too, if the shapes differ by more than 1% (fit_part.h).
function contained(part, size) {
  const [x, y, width, height] = part, wider = width / height * size[1] / size[0];
  const scale = Math.max(...size) / Math.max(width, height);
  const nearest = [width, height].map((v) => Math.max(1, Math.round(scale * v)));
  if (String(nearest) === String(size) || Math.abs(Math.log(wider)) <= 0.01)
    return part;
  return wider > 1 ? [x, y, width, height * wider] : [x, y, width / wider, height];
}

// Shows the loaded part, 0 to 1, and lets the browser draw it and respond to the user.
function loaded(part) {
  element("loading").textContent = `Loading the picture ... ${Math.round(100 * part)} %`;
  return new Promise((done) => setTimeout(done));
}

// Width and height of the place for the picture, in the page's pixels.
function room_for_view() {
  const around = 150; // title, caption and margins
  const whole = state.bare || document.fullscreenElement;
  return [canvas.parentElement.clientWidth, whole ? innerHeight : Math.max(200, innerHeight - around)];
}

// Each view has the size in the fragment or in the page's data, or else fits the window. Two views
// are side by side or above each other, whichever makes them larger.
function fit() {
  const dots = devicePixelRatio || 1, most = gl.getParameter(gl.MAX_TEXTURE_SIZE), beside = comparison?.shown === "beside";
  let size = state.size, part = state.part, coarser = 1;
  views = beside ? [2, 1] : [1, 1];
  if (!size) {
    const [, , width, height] = part, room = room_for_view();
    const scale_of = ([across, down]) => Math.min((room[0] - gap * (across - 1)) / (across * width),
                                                  (room[1] - gap * (down - 1)) / (down * height));
    if (beside && scale_of([1, 2]) > scale_of(views))
      views = [1, 2];
    const scale = Math.max(scale_of(views), 0) * dots;
    coarser = coarse.scale;
    size = [width * scale * coarser, height * scale * coarser];
  }
  size = size.map((v) => within(Math.round(v), 1, most));
  if (state.size && state.contain)
    part = contained(part, size);
  if (String([size, part, views]) === drawn)
    return;
  drawn = String([size, part, views]);
  const whole = size.map((v, axis) => v * views[axis] + Math.round(gap * dots) * (views[axis] - 1));
  [canvas.width, canvas.height] = whole;
  canvas.style.width = whole[0] / (dots * coarser) + "px";
  canvas.style.height = whole[1] / (dots * coarser) + "px";
  drawing.set_view(size, part);
}

// The view of a frame. Each frame has its own lenses' blur, unless the fragment gives one.
function view_of(index) {
  const blur = index > 0 && state.blur === start.blur ? start.second_blur : state.blur;
  return { ...state, blur, samples: coarse.moving ? Math.min(coarse.scale < 1 ? 2 : quick, samples()) : samples() };
}

function draw() {
  pending = 0;
  const began = performance.now();
  fit();
  if (comparison)
    comparison.draw(drawing, [view_of(0), view_of(1)], canvas);
  else
    drawing.draw(0, view_of(0));
  draw_ring();
  coarse.drawn(gl, began);
  document.body.dataset.drawn = canvas.width + "x" + canvas.height;
}

function request() {
  if (ready && !pending)
    pending = requestAnimationFrame(draw);
}

// Redraws after a move of the eye.
function changed() {
  focus_before_eye();
  show_state();
  coarse.moves();
}

// The text on the page.
const figures = (v, digits = 4) => String(Number(v.toPrecision(digits)));
const mm = (v) => figures(v) + " mm";

function side(v, before, after) {
  return Math.abs(v) < 0.05 ? null : mm(Number(Math.abs(v).toFixed(1))) + (v < 0 ? before : after);
}

function show_state() {
  const [x, y, distance] = state.eye;
  const places = [side(x, " to the left", " to the right"), side(y, " below", " above")].filter(Boolean);
  element("where").textContent = start.flat ? start.flat : state.raw ? "The film, without its lens sheet"
    : `The eye is ${mm(distance)} in front of the sheet, ${places.length ? places.join(" and ") : "opposite its middle"}`;
  const slider = (id, value, text) => {
    const input = element(id);
    input.min = Math.min(input.min, value);
    input.max = Math.max(input.max, value);
    input.value = value;
    input.setAttribute("aria-valuetext", text);
    input.parentElement.querySelector("output").textContent = text;
  };
  slider("distance", Math.log2(distance / aperture.distance_mm), mm(distance));
  slider("pupil", state.pupil, state.pupil > 0 ? mm(state.pupil) : "a point: all is sharp");
  slider("focus", state.focus, side(state.focus, " in front of the sheet", " behind the sheet") ?? "the sheet");
  element("focus").disabled = !(state.pupil > 0);
  element("raw").checked = state.raw;
  document.body.dataset.state = JSON.stringify(state);
}

function show_geometry() {
  const [wide, high] = start.zone;
  const [dx, dy] = film.pixel_pitch_mm, same = dx === dy;
  const lenses = { lenticular: "lenticular: cylinders", square: "lenses in a square grid", hexagonal: "lenses in a hexagonal grid" };
  const lens = [mm(sheet.pitch_mm) + " apart", mm(sheet.thickness_mm) + " thick", "refractive index " + figures(sheet.ior)];
  if (slant !== 0)
    lens.push(`slanted by ${figures(sheet.slant_degrees)}°`);
  if (offset[0] !== 0 || offset[1] !== 0)
    lens.push(`moved by ${figures(offset[0])}, ${mm(offset[1])}`);
  if (state.blur > 0)
    lens.push(`light from a spot ${mm(state.blur)} wide`);
  if (start.model === "pinhole")
    lens.push("taken as pinholes");
  const both = (x, y, unit) => (same ? figures(x) : `${figures(x)} × ${figures(y)}`) + unit; // one value, or two, across and down
  const film_words = [`${film.width} × ${film.height} pixels of ${both(dx, dy, " mm")} (${both(25.4 / dx, 25.4 / dy, " dpi")})`,
                      `${figures(film_size[0])} × ${mm(film_size[1])}`];
  if (film.subpixels)
    film_words.push(`colour stripes ${film.subpixels}`);
  if (state.gap !== 0)
    film_words.push(`${mm(Math.abs(state.gap))} ${state.gap > 0 ? "beyond" : "before"} the lenses' focus`);
  const upright = Math.abs(sheet.slant_degrees ?? 0) <= 45; // slit_is_horizontal
  const zone_words = sheet.arrangement !== "lenticular" ? `${figures(wide)} × ${mm(high)}`
                   : upright ? mm(wide) + " wide" : mm(high) + " high";
  const p = sheet.pitch_mm;
  const per_lens = sheet.arrangement !== "lenticular" ? both(p / dx, p / dy, "")
                 : figures(upright ? p / Math.cos(slant) / dx : p / Math.abs(Math.sin(slant)) / dy); // across cylinders alone
  const lines = [
    ["Scene", geometry.render?.scene], ["Rendered by", geometry.render?.program],
    ["Sheet", `${lenses[sheet.arrangement]}, ${lens.join(", ")}`], ["Film", film_words.join(", ")],
    ["Part shown", state.part[2] === film_size[0] ? "" : `${figures(state.part[2])} × ${mm(state.part[3])}`],
    ["Pixels per lens", per_lens],
    ["Viewing distance", mm(aperture.distance_mm)], ["Viewing zone", zone_words + " at that distance"]];
  for (const [term, text] of lines.filter((line) => line[1])) {
    element("words").append(document.createElement("dt"), document.createElement("dd"));
    element("words").lastChild.previousSibling.textContent = term;
    element("words").lastChild.textContent = text;
  }
  const title = start.title ?? geometry.render?.scene;
  if (title) {
    element("title").textContent = title;
    document.title = title + (start.flat ? "" : " – integral photograph");
  }
  element("help").textContent = (calm.matches ? "Drag" : "Point or drag")
    + " on the picture, or use the arrow keys (with Shift in small steps), to move the eye; "
    + "Page Up and Page Down bring it nearer and farther, Home back.";
}

function trouble(text) {
  element("trouble").textContent = text;
  element("trouble").hidden = false;
}

// Input that moves the eye.

// A mouse sets the eye's position: the picture's width and height are the zone's. A finger moves it by
// the distance dragged.
function on_pointer() {
  let held = null; // last position of the finger
  const moved = (event) => {
    const box = canvas.getBoundingClientRect(), [width, height] = zone(state.eye[2]), [x, y] = state.eye;
    const view_width = box.width / views[0], view_height = box.height / views[1];
    const mm_across = width / view_width, mm_down = height / view_height;
    if (event.pointerType !== "touch") {
      if (event.buttons || !calm.matches)
        move_eye(mm_across * ((event.clientX - box.left) % view_width - view_width / 2),
                 mm_down * (view_height / 2 - (event.clientY - box.top) % view_height));
    } else if (held) {
      move_eye(x + mm_across * (event.clientX - held.clientX), y - mm_down * (event.clientY - held.clientY));
      held = event;
    }
  };
  canvas.addEventListener("pointermove", moved);
  canvas.addEventListener("pointerdown", (event) => {
    held = event;
    if (event.isTrusted)
      canvas.setPointerCapture(event.pointerId);
    moved(event);
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, () => { held = null; });
}

function on_key(event) {
  const for_eye = event.target === canvas || (event.target === document.body && !start.keys_for_pages);
  if (!for_eye || start.flat || event.ctrlKey || event.altKey || event.metaKey)
    return;
  const [x, y, distance] = state.eye, part = event.shiftKey ? 0.01 : 0.05, [width, height] = zone(distance);
  const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }, move = moves[event.key];
  if (move)
    move_eye(x + part * width * move[0], y + part * height * move[1]);
  else if (event.key === "PageUp" || event.key === "PageDown")
    set_distance(distance * (event.key === "PageUp" ? 1 / 1.1 : 1.1));
  else if (event.key === "Home")
    reset();
  else
    return;
  event.preventDefault();
}

function set_distance(distance) {
  state.eye[2] = within(distance, 1e-3, farthest);
  changed();
}

function reset() {
  read_fragment();
  changed();
}

// The eye stays in space, the device turns. Device frame: x right, y up, z towards the eye: beta
// turns about x, gamma about y.
async function tilt() {
  const ask = DeviceOrientationEvent.requestPermission;
  if (ask && await ask.call(DeviceOrientationEvent) !== "granted")
    return trouble("The browser does not tell the page how the device is tilted.");
  let first = null;
  const from = [...state.eye], radians = Math.PI / 180;
  window.addEventListener("deviceorientation", (event) => {
    if (event.beta === null || event.gamma === null)
      return;
    first ??= event;
    const turn = (angle, zero) => Math.tan(within(((angle - zero + 540) % 360 - 180), -60, 60) * radians);
    const x = -turn(event.gamma, first.gamma), y = turn(event.beta, first.beta);
    const held = (screen.orientation?.angle ?? 0) * radians, c = Math.cos(held), s = Math.sin(held);
    move_eye(from[0] + state.eye[2] * (c * x - s * y), from[1] + state.eye[2] * (s * x + c * y));
  });
  setTimeout(() => { if (!first) trouble("This device does not say how it is tilted."); }, 2000);
  element("tilt").hidden = true;
}

function on_controls() {
  const d = aperture.distance_mm, greatest_pupil = Math.max(20, Math.ceil(0.25 * zone(d)[0]));
  Object.assign(element("distance"), { min: -2, max: 2 });
  element("pupil").max = greatest_pupil;
  Object.assign(element("focus"), { min: -Math.ceil(0.4 * d), max: Math.ceil(0.4 * d), step: Math.ceil(0.4 * d) / 400 });
  element("distance").addEventListener("input", (event) => set_distance(Number((d * 2 ** event.target.value).toPrecision(4))));
  for (const id of ["pupil", "focus"])
    element(id).addEventListener("input", (event) => { state[id] = Number(event.target.value); changed(); });
  element("raw").addEventListener("change", (event) => { state.raw = event.target.checked; changed(); });
  element("reset").addEventListener("click", reset);
  element("full").addEventListener("click", () => document.fullscreenElement ? document.exitFullscreen() : canvas.parentElement.requestFullscreen());
  element("tilt").hidden = !("DeviceOrientationEvent" in window && matchMedia("(pointer: coarse)").matches);
  element("tilt").addEventListener("click", () => tilt().catch((error) => trouble(String(error.message))));
  document.addEventListener("keydown", on_key);
  window.addEventListener("hashchange", reset);
  window.addEventListener("resize", request);
  if (!start.flat)
    on_pointer();
}

async function begin() {
  gl = context;
  drawn = "";
  drawing = new ReplayDrawing(gl, element("shader").textContent);
  for (const frame of frames)
    await drawing.add(frame, state.tile, loaded);
  ready = true;
  element("loading").hidden = true;
  canvas.hidden = false;
  element("still")?.remove();
  draw();
}

// Without WebGL the page shows only the frame.
function give_up(why) {
  ready = false;
  element("loading").hidden = true;
  element("still")?.remove();
  document.body.classList.add("flat");
  trouble(why + " Below is the frame as it is on the film.");
}

// Moves the eye to a difference, and marks its place until the eye moves.
let visited = null; // { eye, place }
function visit(difference) {
  visited = difference;
  state.eye = [...difference.eye];
  changed();
}

// The ring about the visited place, on the first view.
function draw_ring() {
  const is_there = visited !== null && String(visited.eye) === String(state.eye);
  element("ring").hidden = !is_there;
  if (!is_there)
    return;
  const { size, part } = drawing, dots = canvas.width / canvas.clientWidth;
  const [across, down] = [0, 1].map((axis) => (visited.place[axis] - part[axis]) / part[2 + axis]);
  element("ring").style.left = canvas.offsetLeft + (0.5 + across) * size[0] / dots + "px";
  element("ring").style.top = canvas.offsetTop + (0.5 - down) * size[1] / dots + "px";
}

const comparison = frames.length > 1 ? new Comparison(start, request, visit) : null;
document.body.classList.toggle("no-lenses", Boolean(start.flat));
read_fragment();
show_geometry();
on_controls();
show_state();
if (element("still")) { // as large as the picture will be
  const [, , width, height] = state.part, room = room_for_view(), scale = Math.min(room[0] / width, room[1] / height);
  Object.assign(element("still").style, { width: width * scale + "px", height: height * scale + "px" });
  canvas.hidden = true;
}
const context = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, stencil: false });
const run = () => begin().catch((error) => give_up(error.message));
canvas.addEventListener("webglcontextlost", (event) => { event.preventDefault(); ready = false; });
canvas.addEventListener("webglcontextrestored", run);
if (context)
  run();
else
  give_up("This browser has no WebGL 2, which the replay needs.");
