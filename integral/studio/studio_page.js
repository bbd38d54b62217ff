// SPDX-License-Identifier: AGPL-3.0-or-later
// The studio's page: its settings, its requests to the server, and its pictures. Lengths in mm in the
// sheet frame, or in scene units where so named. Continued by studio_controls.js.

const element = (id) => document.getElementById(id);
const sheets = JSON.parse(element("sheets").textContent); // { name, label, sheet } each; panels: { word, panel } too, `word` being the name for a shell
const canvas = element("view"), depth_canvas = element("depths");
const within = (v, least, greatest) => Math.min(greatest, Math.max(least, v));
const figures_of = (v, digits = 4) => String(Number(v.toPrecision(digits)));
const base = location.pathname.replace(/\/$/, "");
const still = 300; // ms without a change, after which the exact draft is requested

// The user's settings. While a panel is chosen, the print's size, dpi and distance are kept and not used. `eye`: x and y as parts of the viewing zone's half width, and the distance as
// a multiple of the viewing distance. sheet_distance and parallax: null if they are fitted.
const state = { sheet: null, dpi: 0, width: 0, height: 0, distance: 0, sheet_distance: null, parallax: null, budgets: 2,
                eye: [0, 0, 1], tint: false };
let figures = null;        // the server's answer for the settings
let scene = { probe: 0, exact: 0, work: null, progress: 0, problem: null }; // the server's state
let probe = null;

// Settings as the server reads them, and in the address's fragment.

function settings() {
  const { sheet, dpi, width, height, distance, sheet_distance, parallax, budgets } = state;
  return { panel: sheet.panel ?? null, sheet: sheet.sheet, dpi, print_mm: [width, height], viewing_distance_mm: distance, sheet_distance, parallax, budgets };
}

function use_settings({ panel, sheet, print_mm, dpi, viewing_distance_mm, sheet_distance, parallax, budgets }) {
  state.sheet = sheets.find((known) => JSON.stringify(known.panel ?? known.sheet) === JSON.stringify(panel ?? sheet));
  [state.width, state.height] = print_mm;
  Object.assign(state, { dpi, distance: viewing_distance_mm, sheet_distance, parallax, budgets });
}

// The size of the print or panel, and the distance from which it is seen, mm.
function shape() {
  if (!state.sheet.panel)
    return state;
  const { geometry } = figures, [width, height] = film_size_of(geometry);
  return { width, height, distance: geometry.aperture.distance_mm };
}

// Legal ranges of numbers in controls and in the address's fragment.
const ranges = { dpi: [10, 1e5], width: [1, 1e5], height: [1, 1e5], distance: [10, 1e6], plane: [1e-9, 1e9], parallax: [0, 100], budgets: [0.1, 100] };
const is_legal = (name, value) => value !== null && value >= ranges[name][0] && value <= ranges[name][1];

function fragment() {
  const parameters = new URLSearchParams({ sheet: state.sheet.name, dpi: state.dpi, print: `${state.width}x${state.height}`, distance: state.distance });
  parameters.set("plane", state.sheet_distance ?? "fit");
  parameters.set("parallax", state.parallax ?? "fit");
  parameters.set("budgets", state.budgets);
  if (state.eye.join() !== "0,0,1")
    parameters.set("eye", state.eye.map((v) => figures_of(v)).join());
  if (state.tint)
    parameters.set("tint", "1");
  return "#" + parameters;
}

// Reads the address's fragment; returns whether it has settings that can work.
function read_fragment() {
  const parameters = new URLSearchParams(location.hash.slice(1));
  const number = (text) => text !== null && text.trim() !== "" && Number.isFinite(Number(text)) ? Number(text) : null;
  const value = (name) => number(parameters.get(name)), fitted = (name) => is_legal(name, value(name)) ? value(name) : null;
  const sheet = sheets.find(({ name }) => name === parameters.get("sheet"));
  const [width = null, height = null] = (parameters.get("print") ?? "").split("x").map(number), dpi = value("dpi"), distance = value("distance");
  if (!sheet || !Object.entries({ dpi, width, height, distance }).every(([name, v]) => is_legal(name, v)))
    return false;
  const eye = (parameters.get("eye") ?? "0,0,1").split(",").map(number), budgets = fitted("budgets") ?? 2;
  Object.assign(state, { sheet, dpi, width, height, distance, budgets, sheet_distance: fitted("plane"), parallax: fitted("parallax"),
                         eye: eye.length === 3 && !eye.includes(null) && eye[2] > 0 ? eye : [0, 0, 1], tint: parameters.has("tint") });
  return true;
}

// The server.

async function post(path, body = "") {
  const answer = await fetch(base + path, { method: "POST", body: typeof body === "object" ? JSON.stringify(body) : body });
  if (!answer.ok)
    throw Error((await answer.text()).trim());
  return answer.json();
}

// A line of JSON, and the bytes after it.
async function get_bytes(path) {
  const answer = await fetch(base + path);
  if (!answer.ok)
    throw Error((await answer.text()).trim());
  const bytes = await answer.arrayBuffer(), end = new Uint8Array(bytes).indexOf(10);
  return { head: JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 0, end))), bytes, at: end + 1 };
}

async function load_probe() {
  const { head, bytes, at } = await get_bytes("/probe");
  const { width, height, sheet_distance, window, eyes } = head, pixels = width * height, colours = Math.ceil(3 * pixels / 4) * 4;
  const first = !probe;
  probe = { width, height, sheet_distance, window, views: eyes.map((eye, k) => {
    const from = at + k * (colours + 4 * pixels);
    return { eye, colours: new Uint8Array(bytes, from, 3 * pixels), nearness: new Float32Array(bytes, from + colours, pixels) };
  }) };
  live?.set_probe(probe);
  depths_of_probe();
  if (first && !read_fragment())
    use_settings((await post("/figures")).settings);
  await refresh();
}

// The figures for the settings; requests made meanwhile are answered once, by the last settings.
let asking = false, ask_again = false;
const shape_of = ({ sheet, film, aperture }) => JSON.stringify([sheet, film, aperture]);
async function refresh() {
  if (asking) {
    ask_again = true;
    return;
  }
  asking = true;
  do {
    ask_again = false;
    try {
      figures = await post("/figures", settings());
      say_problem(null);
    } catch (error) {
      say_problem(error.message);
    }
  } while (ask_again);
  asking = false;
  show();
}

// The exact draft: requested when nothing has moved for a moment, stopped when something moves.
const exact = { requested: 0, number: 0, draft: 1, seconds: 0 }; // number: of the draft that is shown; 0: none
let settling = 0;

function changed() {
  if (!figures)
    return;
  clearTimeout(settling);
  if (exact.requested)
    post("/stop/" + exact.requested).catch(() => {});
  exact.requested = exact.number = 0;
  settling = setTimeout(settled, still);
  coarse.moves();
  refresh();
}

let requests = Date.now() % 1e9; // so that no number of an earlier page occurs again
function settled() {
  if (!figures)
    return;
  if (location.hash !== fragment())
    is_own_address ? history.pushState(null, "", fragment()) : history.replaceState(null, "", fragment());
  is_own_address = true;
  request_exact();
}
let is_own_address = false; // whether this page wrote the address's fragment

function request_exact() {
  if (!probe || !figures || exact.number)
    return;
  exact.requested = ++requests;
  post("/exact/" + exact.requested, settings()).catch((error) => say_problem(error.message));
}

let loading = Promise.resolve(); // one draft after the other
function load_exact({ exact: number, draft, seconds }) {
  loading = loading.then(async () => {
    if (number !== exact.requested || !replay)
      return;
    const { head, bytes, at } = await get_bytes("/exact");
    replay.remove_all();
    await replay.add({ geometry: head, ior: head.sheet.ior, pixels: new Uint8Array(bytes, at) }, 1e6, async () => {});
    if (number !== exact.requested)
      return;
    Object.assign(exact, { number, draft, seconds });
    show();
  }).catch((error) => say_problem(error.message));
}

function listen() {
  const events = new EventSource(base + "/events");
  let lost = 0;
  events.onopen = () => clearTimeout(lost);
  events.onmessage = ({ data }) => {
    const before = scene;
    scene = JSON.parse(data);
    if (scene.exact === 0 && before.exact > 0) // the scene has changed
      exact.requested = exact.number = 0;
    if (scene.probe !== before.probe && scene.probe > 0)
      load_probe().then(() => { if (!exact.number) settled(); }).catch((error) => say_problem(error.message));
    if (scene.exact !== before.exact && scene.exact === exact.requested && scene.exact > 0)
      load_exact(scene);
    show_problem();
    show_badge();
    show_print_button();
    if (before.printing && !scene.printing && scene.print)
      say_printed();
  };
  events.onerror = () => {
    clearTimeout(lost);
    lost = setTimeout(() => say_problem("The studio has ended. Start integral studio again and open its new address."), 5000);
  };
}

// The eye.

function zone() {
  const [w, h] = figures.zone_mm;
  return [w || h, h || w].map((extent) => extent * state.eye[2]);
}

function eye_mm() {
  const [width, height] = zone();
  return [0.5 * width * state.eye[0], 0.5 * height * state.eye[1], shape().distance * state.eye[2]];
}

function move_eye(x, y) {
  if (!figures)
    return;
  state.eye = [within(x, -3, 3), within(y, -3, 3), state.eye[2]];
  eye_has_moved();
}

function set_eye_distance(times) {
  if (!figures)
    return;
  state.eye[2] = within(times, 0.1, 10);
  eye_has_moved();
}

let eye_timer = 0;
function eye_has_moved() {
  coarse.moves();
  show_eye();
  clearTimeout(eye_timer);
  eye_timer = setTimeout(() => { if (is_own_address) history.replaceState(null, "", fragment()); }, still);
}

// Drawing.

let gl = null, live = null, replay = null, pending = 0, drawn_size = "";

const coarse = new CoarseMode(request_drawing);

function is_exact() { return exact.number > 0 && !state.tint; }

function fit_canvas() {
  const stage = element("stage"), dots = devicePixelRatio || 1, { width, height } = shape();
  const room = [stage.clientWidth, stage.clientHeight], scale = Math.min(room[0] / width, room[1] / height);
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE), finer = dots * live_scale();
  const size = [width, height].map((mm) => within(Math.round(mm * scale * finer), 1, most));
  const key = [size, exact.number, shape_of(figures.geometry)].join();
  if (key === drawn_size)
    return;
  drawn_size = key;
  [canvas.width, canvas.height] = size;
  canvas.style.width = width * scale + "px";
  canvas.style.height = height * scale + "px";
  const film = figures.geometry.film, part = [0, 0, ...film_size_of({ film })];
  live.set_view(size, part, figures.geometry);
  if (exact.number)
    replay.set_view(size, part);
}

// Share of the pixels across and down. Slow graphics draw a still live picture coarsely, too: the
// processors that they need are the renderer's, and the exact picture follows.
function live_scale() { return is_exact() || coarse.moving ? coarse.scale : Math.min(1, 2 * coarse.slow); }

function placement() {
  const fitted = figures.placement;
  return { sheet_distance: state.sheet_distance ?? fitted.sheet_distance, parallax: state.parallax ?? fitted.parallax,
           scene_distance_mm: fitted.scene_distance_mm };
}

function draw() {
  pending = 0;
  if (!figures?.placement || !probe || !live)
    return;
  fit_canvas();
  const eye = eye_mm(), began = performance.now();
  if (is_exact())
    replay.draw(0, { eye, pupil: 0, focus: 0, gap: 0, blur: 0, samples: coarse.moving ? 1 : 3, raw: false });
  else
    live.draw(eye, placement(), { samples: coarse.moving || coarse.slow < 0.7 ? 1 : 2, tint: state.tint ? figures.budget_mm ?? 0 : 0 });
  coarse.drawn(gl, began);
  document.body.dataset.drawn = is_exact() ? "exact" : "live";
}

function request_drawing() {
  if (!pending)
    pending = requestAnimationFrame(draw);
}
