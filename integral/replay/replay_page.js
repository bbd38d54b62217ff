// SPDX-License-Identifier: AGPL-3.0-or-later
// The replay page: moves the eye and draws what it sees. Lengths in mm, in the sheet frame.
"use strict";
(() => {
const element = (id) => document.getElementById(id);
const geometry = JSON.parse(element("geometry").textContent), start = JSON.parse(element("start").textContent);
const { sheet, film, aperture } = geometry;
const canvas = element("view"), pictures = [ element("frame"), element("second") ].filter(Boolean);
const film_size = [film.width * film.pixel_pitch_mm[0], film.height * film.pixel_pitch_mm[1]];
const offset = sheet.offset_mm ?? [0, 0], slant = (sheet.slant_degrees ?? 0) * Math.PI / 180;
const ior = start.model === "pinhole" ? 1 : sheet.ior;
const calm = matchMedia("(prefers-reduced-motion: reduce)");
const farthest = 1e9; // greatest distance of the eye
const within = (v, least, greatest) => Math.min(greatest, Math.max(least, v));

// The view: initially as in the page's data, replaced by the values in the address's fragment, and
// changed by the user.
// Fields: eye [x, y, distance], pupil, focus, gap, blur, part [x, y, width, height], size, raw; from
// the fragment only: samples, bare, tile. `contain`: size or part are the fragment's.
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
    raw: said.has("raw"),
    bare: said.has("bare"),
    tile: Math.round(number("tile", 1, 1e6, 1e6)),
  };
  focus_before_eye();
  document.body.classList.toggle("bare", state.bare);
  show_split(number("split", 0, 1, 0.5));
}

// Of two frames, the part of the view's width that shows the first.
let split_at = 0.5, blinking = 0;

function show_split(part)
{
    split_at = part;
    if (pictures.length < 2)
        return;
    element("split").value = part;
    element("comparison").querySelector("output").textContent = part <= 0   ? "the result"
                                                                : part >= 1 ? "the reference"
                                                                            : "both";
}

function set_split(part)
{
    show_split(part);
    request();
}

function toggle_blinking()
{
    const stop = blinking !== 0;
    clearInterval(blinking);
    blinking = stop ? 0 : setInterval(() => set_split(split_at > 0 ? 0 : 1), 500);
    element("blink").setAttribute("aria-pressed", String(!stop));
    set_split(stop ? 0.5 : 1);
}

function show_alone(part)
{
    if (blinking)
        toggle_blinking();
    set_split(part);
}

function on_comparison()
{
    if (pictures.length < 2)
        return;
    element("split").addEventListener("input", (event) => show_alone(Number(event.target.value)));
    element("show-reference").addEventListener("click", () => show_alone(1));
    element("show-result").addEventListener("click", () => show_alone(0));
    element("blink").addEventListener("click", toggle_blinking);
    document.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey)
            return;
        if (event.key === "b")
            toggle_blinking();
        else if (event.key === "1" || event.key === "2")
            show_alone(event.key === "1" ? 1 : 0);
    });
}

function focus_before_eye() {
  state.focus = Math.max(state.focus, -0.99 * state.eye[2]);
}

// Samples per pixel, as for the command: more with a pupil or blur, unless the page's data give a
// number.
function samples() {
  const scattered = (view) => view.pupil > 0 || view.blur > 0;
  return state.samples || (scattered(state) === scattered(start) ? start.samples : scattered(state) ? 8 : 3);
}

// Width and height of the zone in which the eye moves, mm; for a slit the height equals the width.
function zone(distance) {
  const scale = distance / aperture.distance_mm, [w, h] = start.zone;
  const width = w || h || 0.4 * aperture.distance_mm;
  return [scale * width, scale * (h || width)];
}

function move_eye(x, y) {
  state.eye = [within(x, -farthest, farthest), within(y, -farthest, farthest), state.eye[2]];
  changed();
}

// Unit vectors across the lenses and along them: exact where the lenses lie across.
const across = Math.abs(sheet.slant_degrees) === 90 ? [0, Math.sign(slant)] : [Math.cos(slant), Math.sin(slant)];
const along = [-across[1], across[0]];

// Drawing.
const WHOLE = 0, PART = 1;
const split = (v) => [Math.floor(v), v - Math.floor(v)];
const quick = 4; // samples across a pixel while the eye moves, at most
let gl, uniform, textures, films, ready = false, drawn = "", pending = 0, settling = 0,
                                  moving = false;

// The part that a view of `size` pixels shows of the sheet so that `part` is in it unstretched: a
// larger one, beyond the sheet's edges too, where the shapes differ by more than 1% (fit_part.h).
function contained(part, size) {
  const [x, y, width, height] = part, wider = width / height * size[1] / size[0];
  const scale = Math.max(...size) / Math.max(width, height);
  const nearest = [width, height].map((v) => Math.max(1, Math.round(scale * v)));
  if (String(nearest) === String(size) || Math.abs(Math.log(wider)) <= 0.01)
    return part;
  return wider > 1 ? [x, y, width, height * wider] : [x, y, width / wider, height];
}

// By columns or rows of a view of `part`, as replay_page.glsl says. `axis` 0: columns.
function steps(part, axis, count) {
  const row_spacing = sheet.arrangement === "hexagonal" ? Math.sqrt(3) / 2 : 1;
  const texels = new Float32Array(8 * count);
  for (let i = 0; i < count; ++i) {
    const mm = part[axis] + (axis === 0 ? i / count - 0.5 : 0.5 - i / count) * part[2 + axis];
    const u = split(across[axis] * (mm - offset[axis]) / sheet.pitch_mm);
    const v = split(along[axis] * (mm - offset[axis]) / (sheet.pitch_mm * row_spacing));
    const pitch = film.pixel_pitch_mm[axis], pixel = split(axis === 0 ? mm / pitch + film.width / 2 : film.height / 2 - mm / pitch);
    texels.set([u[WHOLE], u[PART], v[WHOLE], v[PART]], 4 * i);
    texels.set([pixel[WHOLE], pixel[PART], mm, 0], 4 * (count + i));
  }
  return texels;
}

function floats_texture(unit, format, layout, width, height, values) {
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D, textures[unit]);
  gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, layout, gl.FLOAT, values);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
}

function compiled(type, text) {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  return shader;
}

function set_program() {
  const program = gl.createProgram();
  // One triangle that covers the view.
  gl.attachShader(program, compiled(gl.VERTEX_SHADER, `#version 300 es
    void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }`));
  const fragment = compiled(gl.FRAGMENT_SHADER, element("shader").textContent.trim());
  gl.attachShader(program, fragment);
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw Error("The graphics driver refuses the program: " + (gl.getShaderInfoLog(fragment) || gl.getProgramInfoLog(program)));
  gl.useProgram(program);
  const known = {};
  uniform = (name) => known[name] ??= gl.getUniformLocation(program, name);
}

// Uniforms that do not change: sheet and film.
function set_geometry() {
  const whole = (name, value) => gl.uniform1i(uniform(name), value);
  ["film", "light", "columns", "rows"].forEach((name, unit) => whole(name, unit));
  whole("arrangement", ["lenticular", "square", "hexagonal"].indexOf(sheet.arrangement));
  whole("subpixels", ["none", "rgb", "bgr"].indexOf(film.subpixels ?? "none"));
  gl.uniform2i(uniform("film_size"), film.width, film.height);
  gl.uniform2fv(uniform("pixel_pitch"), film.pixel_pitch_mm);
  gl.uniform1f(uniform("pitch"), sheet.pitch_mm);
  gl.uniform1f(uniform("row_spacing"), sheet.arrangement === "hexagonal" ? Math.sqrt(3) / 2 : 1);
  gl.uniform2fv(uniform("across"), across);
  gl.uniform2fv(uniform("along"), along);
  gl.uniform2f(uniform("centre_to_lens"), (across[0] * offset[0] + across[1] * offset[1]) / sheet.pitch_mm,
               (across[0] * offset[1] - across[1] * offset[0]) / sheet.pitch_mm);
  gl.uniform1f(uniform("thickness"), sheet.thickness_mm);
  gl.uniform1f(uniform("n_squared"), ior * ior);
  gl.uniform1f(uniform("m"), (ior - 1) * (ior + 1));
  const linear = (v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
  floats_texture(1, gl.R32F, gl.RED, 256, 1, Float32Array.from({ length: 256 }, (_, v) => linear(v / 255)));
}

// Says how much is loaded, 0 to 1, and lets the browser show it and answer to the reader.
function loaded(part) {
  element("loading").textContent = `Loading the picture ... ${Math.round(100 * part)} %`;
  return new Promise((done) => setTimeout(done));
}

// The frame's file, out of the page's text, piece by piece.
async function frame_file(picture)
{
    const text = picture.src, begin = text.indexOf(",") + 1, piece = 1 << 22; // a multiple of 4
    const pieces = [];
    for (let at = begin; at < text.length; at += piece) {
        await loaded(0.5 * (at - begin) / (text.length - begin));
        pieces.push(
            Uint8Array.from(atob(text.slice(at, at + piece)), (letter) => letter.charCodeAt(0)));
    }
    return new Blob(pieces, {type : "image/png"});
}

// A frame's stored values, bit by bit, in tiles that the graphics processor can hold.
async function set_film(picture, texture)
{
    const blob = await frame_file(picture);
    const most = Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), state.tile);
    const width = Math.min(film.width, most), height = Math.min(film.height, most);
    const columns = Math.ceil(film.width / width), rows = Math.ceil(film.height / height);
    if (columns * rows > gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS))
        throw Error(`The frame of ${film.width} by ${
            film.height} pixels is too large for this device's graphics.`);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGBA8, width, height, columns * rows);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
        gl.texParameteri(gl.TEXTURE_2D_ARRAY, filter, gl.NEAREST);
    for (let tile = 0; tile < columns * rows; ++tile) {
        const x = tile % columns * width, y = Math.floor(tile / columns) * height;
        const w = Math.min(width, film.width - x), h = Math.min(height, film.height - y);
        await loaded(0.5 + 0.5 * tile / (columns * rows));
        const bitmap = await createImageBitmap(
            blob, x, y, w, h, {premultiplyAlpha : "none", colorSpaceConversion : "none"});
        gl.activeTexture(gl.TEXTURE0);
        gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, tile, w, h, 1, gl.RGBA, gl.UNSIGNED_BYTE,
                         bitmap);
        bitmap.close();
    }
    gl.uniform2i(uniform("tile_size"), width, height);
    if (gl.getError() === gl.OUT_OF_MEMORY)
        throw Error("The frame does not fit into this device's graphics memory.");
}

// The view has the size in the fragment or in the page's data, or else fits the window.
function fit() {
  const dots = devicePixelRatio || 1, most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  let size = state.size, part = state.part;
  if (!size) {
    const [, , width, height] = part;
    const room = [canvas.parentElement.clientWidth, state.bare ? innerHeight : Math.max(200, 0.54 * innerHeight)];
    const scale = Math.min(room[0] / width, room[1] / height) * dots;
    size = [width * scale, height * scale];
  }
  size = size.map((v) => within(Math.round(v), 1, most));
  if (state.size && state.contain)
    part = contained(part, size);
  if (String([size, part]) === drawn)
    return;
  drawn = String([size, part]);
  [canvas.width, canvas.height] = size;
  canvas.style.width = size[0] / dots + "px";
  canvas.style.height = size[1] / dots + "px";
  floats_texture(2, gl.RGBA32F, gl.RGBA, size[0], 2, steps(part, 0, size[0]));
  floats_texture(3, gl.RGBA32F, gl.RGBA, size[1], 2, steps(part, 1, size[1]));
  gl.viewport(0, 0, size[0], size[1]);
  gl.uniform2f(uniform("view_pixel"), part[2] / size[0], part[3] / size[1]);
  gl.uniform1i(uniform("view_height"), size[1]);
}

function draw() {
  pending = 0;
  fit();
  const [x, y, distance] = state.eye;
  gl.uniform2f(uniform("eye"), x, y);
  gl.uniform1f(uniform("eye_distance"), distance);
  gl.uniform1f(uniform("pupil_radius"), 0.5 * state.pupil);
  gl.uniform1f(uniform("spot_radius"), 0.5 * state.blur);
  gl.uniform1f(uniform("sideways"), state.focus / (distance + state.focus));
  gl.uniform1f(uniform("past_focus"), state.gap / sheet.thickness_mm);
  gl.uniform1i(uniform("samples"), moving ? Math.min(quick, samples()) : samples());
  gl.uniform1i(uniform("raw"), state.raw ? 1 : 0);
  const edge = films.length < 2 ? canvas.width : Math.round(split_at * canvas.width);
  films.forEach((film_texture, k) => {
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, film_texture);
      gl.scissor(k === 0 ? 0 : edge, 0, k === 0 ? edge : canvas.width - edge, canvas.height);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
  });
  document.body.dataset.drawn = canvas.width + "x" + canvas.height;
}

function request() {
  if (ready && !pending)
    pending = requestAnimationFrame(draw);
}

// Redraws after a move of the eye: at once with few samples, and with all when it stops.
function changed() {
  focus_before_eye();
  clearTimeout(settling);
  moving = samples() > quick;
  if (moving)
    settling = setTimeout(() => { moving = false; request(); }, 150);
  show_state();
  request();
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
  element("where").textContent = state.raw ? "The film, without its lens sheet"
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
  const both = (x, y, unit) => (same ? figures(x) : `${figures(x)} × ${figures(y)}`) + unit; // of across and down
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
  if (geometry.render?.scene) {
    element("title").textContent = geometry.render.scene;
    document.title = geometry.render.scene + " – integral photograph";
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
const reach = 1.2; // width of the picture, in widths of the zone

// A mouse sets the eye's position; a finger moves it by the distance dragged.
function on_pointer() {
  let held = null; // last position of the finger
  const moved = (event) => {
    const box = canvas.getBoundingClientRect(), [width, height] = zone(state.eye[2]), [x, y] = state.eye;
    const mm_across = reach * width / box.width, mm_down = reach * height / box.height;
    if (event.pointerType !== "touch") {
      if (event.buttons || !calm.matches)
        move_eye(mm_across * (event.clientX - box.left - box.width / 2), mm_down * (box.height / 2 - (event.clientY - box.top)));
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
  if ((event.target !== document.body && event.target !== canvas) || event.ctrlKey || event.altKey || event.metaKey)
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
  element("tilt").hidden = !("DeviceOrientationEvent" in window && matchMedia("(pointer: coarse)").matches);
  element("tilt").addEventListener("click", () => tilt().catch((error) => trouble(String(error.message))));
  document.addEventListener("keydown", on_key);
  window.addEventListener("hashchange", reset);
  window.addEventListener("resize", request);
  on_pointer();
}

async function begin() {
  gl = context;
  drawn = "";
  textures = Array.from({length : 5}, () => gl.createTexture());
  films = pictures.map((_, k) => textures[k === 0 ? 0 : 4]); // units 1 to 3 hold tables
  gl.enable(gl.SCISSOR_TEST);
  set_program();
  set_geometry();
  for (const [k, picture] of pictures.entries())
      await set_film(picture, films[k]);
  ready = true;
  element("loading").hidden = true;
  draw();
}

// Without WebGL the page shows only the frame.
function give_up(why) {
  ready = false;
  element("loading").hidden = true;
  document.body.classList.add("flat");
  trouble(why + " Below is the frame as it is on the film.");
}

read_fragment();
show_geometry();
on_controls();
on_comparison();
show_state();
const context = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, stencil: false });
const run = () => begin().catch((error) => give_up(error.message));
canvas.addEventListener("webglcontextlost", (event) => { event.preventDefault(); ready = false; });
canvas.addEventListener("webglcontextrestored", run);
if (context)
  run();
else
  give_up("This browser has no WebGL 2, which the replay needs.");
})();
