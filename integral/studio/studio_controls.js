// SPDX-License-Identifier: AGPL-3.0-or-later
// The studio's page, continued: the graph of depths, text, controls and input.

// The scene's depths: how many of the probe's pixels lie at each distance, over log(distance).
const depths = { least: 1, greatest: 2, bins: [], beyond: 0 };

function depths_of_probe() {
  const near = probe.views[0].nearness;
  let least = Infinity, greatest = 0, beyond = 0;
  for (const n of near)
    if (n > 0) {
      least = Math.min(least, 1 / n);
      greatest = Math.max(greatest, 1 / n);
    } else {
      ++beyond;
    }
  if (greatest === 0)
    least = greatest = probe.sheet_distance;
  depths.least = 0.6 * least;
  depths.greatest = Math.min(1.6 * greatest, 1e4 * least);
  depths.bins = new Array(120).fill(0);
  for (const n of near)
    if (n > 0)
      ++depths.bins[within(Math.floor(depths.bins.length * place_of(1 / n)), 0, depths.bins.length - 1)];
  depths.beyond = beyond / near.length;
}

// 0 to 1 across the graph for a distance, and its inverse.
function place_of(distance) { return Math.log(distance / depths.least) / Math.log(depths.greatest / depths.least); }
function distance_at(place) { return depths.least * (depths.greatest / depths.least) ** place; }

function draw_depths() {
  if (!probe || !figures?.placement)
    return;
  const paper = depth_canvas.getContext("2d"), { width, height } = depth_canvas, floor = height - 52;
  const x_of = (distance) => distance === null ? width : width * within(place_of(Math.max(distance, 1e-12)), -1, 2);
  paper.clearRect(0, 0, width, height);
  const band = (ends, colour) => {
    paper.fillStyle = colour;
    paper.fillRect(x_of(ends[0]), 0, x_of(ends[1]) - x_of(ends[0]), floor);
  };
  if (figures.bands) {
    band(figures.bands[1], "#c9a53c44");
    band(figures.bands[0], "#4b83c377");
  }
  const most = Math.max(...depths.bins.map(Math.sqrt), 1), step = width / depths.bins.length;
  paper.fillStyle = "#e8e8e6";
  depths.bins.forEach((count, k) => {
    const tall = Math.sqrt(count) / most * (floor - 8);
    paper.fillRect(k * step, floor - tall, step - 1, tall);
  });
  paper.strokeStyle = "#d9a441";
  paper.lineWidth = 4;
  const at = x_of(placement().sheet_distance);
  paper.beginPath();
  paper.moveTo(at, 0);
  paper.lineTo(at, floor + 8);
  paper.stroke();
  paper.fillStyle = "#d9a441";
  paper.beginPath();
  paper.arc(at, floor + 12, 9, 0, 7);
  paper.fill();
  paper.fillStyle = "#aeb1b6";
  paper.font = "22px system-ui, sans-serif";
  const text = (words, x, align) => { paper.textAlign = align; paper.fillText(words, x, height - 6); };
  text("◂ eye  " + figures_of(depths.least, 3), 4, "left");
  text(figures_of(depths.greatest, 3) + (depths.beyond > 0.001 ? "  far ▸" : ""), width - 4, "right");
}

// Text and controls.

const kind = document.body.dataset.input; // "scene" or "picture"
let page_problem = null; // what went wrong on the page; the scene's own problem is in `scene`
function say_problem(text) {
  page_problem = text;
  show_problem();
}

function show_problem() {
  const text = page_problem ?? scene.problem;
  element("problem").hidden = !text;
  element("problem").textContent = text ?? "";
}

function show_badge() {
  const percent = ` ${Math.round(100 * scene.progress)} %`;
  const working = scene.work === "print" ? `, rendering the ${product()}` + percent : scene.work === "exact" ? ", rendering the exact draft" + percent : scene.work === "probe" ? `, looking at the ${kind}` + percent : "";
  const badge = element("badge");
  badge.classList.toggle("exact", is_exact());
  badge.textContent = !live ? "No picture" : !probe ? `Looking at the ${kind}` + (scene.work ? percent : " ...")
    : is_exact() ? `Exact${exact.draft > 1 ? `, from a draft 1:${exact.draft}` : ""} (${figures_of(exact.seconds, 2)} s)`
    : "Live" + working;
}

// Name of what is rendered.
// Whether the page's words are a command line, as for pictures with depth, in place of a camera's.
const is_command = () => figures.words.startsWith("integral ");
function product() { return state.sheet?.panel ? "panel's image" : "print"; }

function show_print_button() {
  element("print").textContent = (scene.printing ? "Stop rendering the " : "Render the ") + product();
  element("print").setAttribute("aria-pressed", String(Boolean(scene.printing)));
  const nothing = !scene.print || scene.printing;
  element("page-row").hidden = nothing || Boolean(state.sheet?.panel);
  element("show-row").hidden = nothing || !state.sheet?.panel;
}

function say_printed() {
  const file = scene.print_word;
  element("saved").textContent = `${scene.print} is there. See it: integral replay ${file} -o view.png. ` +
    (state.sheet?.panel ? "Show it on the panel if that is connected." : "Make a page of it, to print at its own size.");
}

function show_eye() {
  const [x, y, distance] = eye_mm(), round = (v) => Math.abs(v).toFixed(0) + " mm";
  const places = [Math.abs(x) >= 0.5 ? round(x) + (x < 0 ? " to the left" : " to the right") : "",
                  Math.abs(y) >= 0.5 ? round(y) + (y < 0 ? " below" : " above") : ""].filter(Boolean);
  element("where").textContent = `The eye is ${round(distance)} before the sheet, ${places.join(" and ") || "opposite its middle"}`;
}

function set_control(id, value, text) {
  const input = element(id);
  if (document.activeElement !== input || input.type === "range")
    input.value = value;
  if (text)
    input.setAttribute("aria-valuetext", text);
}

function show() {
  if (!figures || !state.sheet)
    return;
  const put = placement_or_null();
  const { film } = figures.geometry, { width, height, distance } = shape();
  set_control("sheet", state.sheet.name);
  set_control("dpi", figures_of(25.4 / film.pixel_pitch_mm[0], 6));
  set_control("width", figures_of(width));
  set_control("height", figures_of(height));
  set_control("distance", figures_of(distance));
  set_control("distance-slider", Math.log(distance), figures_of(distance) + " mm");
  element("tint").checked = state.tint;
  for (const control of document.querySelectorAll("aside [disabled]"))
    control.disabled = false;
  for (const name of ["dpi", "width", "height", "distance", "distance-slider"])
    element(name).disabled = Boolean(state.sheet.panel);
  if (put) {
    const { sheet_distance: plane, parallax } = put, slider = element("plane-slider");
    slider.min = Math.log(depths.least);
    slider.max = Math.log(depths.greatest);
    set_control("plane", figures_of(plane));
    set_control("plane-slider", Math.log(plane), `${figures_of(plane)} ${element("plane-unit").textContent} from the ${kind}'s eye`);
    set_control("parallax", figures_of(parallax, 3));
    set_control("parallax-slider", Math.log(Math.max(parallax, 1e-3)), figures_of(parallax, 3) + " times");
  }
  const percent = (share) => Math.round(100 * share) + " %", { shares } = figures;
  if (shares) {
    for (const name of ["sharp", "soft", "beyond"])
      element(name).style.width = 100 * shares[name] + "%";
    element("share-words").textContent = `${percent(shares.sharp)} sharp, ${percent(shares.soft)} soft, ${percent(shares.beyond)} beyond; the depth budget is ${figures_of(figures.budget_mm, 3)} mm to either side`;
  } else {
    element("share-words").textContent = "This sheet has no depth budget with these pixels.";
  }
  element("print-words").textContent = `${film.width} × ${film.height} pixels, ${figures_of(figures.lenses, 3)} lenses across, ${figures_of(figures.pixels_per_lens, 3)} pixels per lens`;
  element("words").value = figures.words;
  element("words-name").textContent = is_command() ? "Command for the " + product() : "Words for the camera";
  show_eye();
  show_badge();
  show_print_button();
  draw_depths();
  request_drawing();
}

function placement_or_null() { return figures?.placement ? placement() : null; }

// A change by hand of the sheet's distance or the parallax ends the fit: both keep their values.
function set_placement(change) {
  const now = placement_or_null();
  if (!now)
    return;
  state.sheet_distance = change.sheet_distance ?? now.sheet_distance;
  state.parallax = change.parallax ?? now.parallax;
  element("saved").textContent = "";
  changed();
  show();
}

function set_print(change) {
  Object.assign(state, change);
  element("saved").textContent = "";
  changed();
}

function on_number(id, take) {
  element(id).addEventListener("change", (event) => {
    const { value, labels } = event.target, [min, max] = ranges[id];
    if (value.trim() !== "" && is_legal(id, Number(value)))
      take(Number(value));
    else
      say_problem(`${labels[0].textContent}: ${value || "nothing"} is not a number from ${min} to ${max}.`);
  });
}

function on_controls() {
  for (const { name, label, panel } of sheets)
    element(panel ? "panels" : "lens-sheets").append(new Option(label, name));
  element("sheet").addEventListener("change", (event) => set_print({ sheet: sheets.find(({ name }) => name === event.target.value) }));
  on_number("dpi", (dpi) => set_print({ dpi }));
  on_number("width", (width) => set_print({ width, height: width * state.height / state.width }));
  on_number("height", (height) => set_print({ height }));
  on_number("distance", (distance) => set_print({ distance }));
  on_number("plane", (sheet_distance) => set_placement({ sheet_distance }));
  on_number("parallax", (parallax) => set_placement({ parallax }));
  const slide = (id, least, greatest, take) => {
    Object.assign(element(id), { min: Math.log(least), max: Math.log(greatest) });
    element(id).addEventListener("input", (event) => take(Number(Math.exp(event.target.value).toPrecision(4))));
  };
  slide("distance-slider", 100, 5000, (distance) => set_print({ distance }));
  slide("plane-slider", 1, 2, (sheet_distance) => set_placement({ sheet_distance }));
  slide("parallax-slider", 0.01, 2, (parallax) => set_placement({ parallax }));
  for (const budgets of [1, 2])
    element("fit" + budgets).addEventListener("click", () => set_print({ budgets, sheet_distance: null, parallax: null }));
  element("tint").addEventListener("change", (event) => { state.tint = event.target.checked; show(); settled(); });
  element("undo").addEventListener("click", () => history.back());
  element("redo").addEventListener("click", () => history.forward());
  element("full").addEventListener("click", () => document.fullscreenElement ? document.exitFullscreen() : element("stage").requestFullscreen());
  element("copy").addEventListener("click", () => {
    element("words").select();
    navigator.clipboard?.writeText(element("words").value);
    element("saved").textContent = is_command() ? "The command is copied; Save writes its file."
      : "The words are copied: Integral_Camera=\"...\" takes them, and so does camera { integral ... }.";
  });
  element("print").addEventListener("click", async () => {
    try {
      element("saved").textContent = "";
      await (scene.printing ? post("/stop-print") : post("/print", settings()));
    } catch (error) {
      say_problem(error.message);
    }
  });
  element("page").addEventListener("click", async () => {
    try {
      const { file, command } = await post("/page", element("paper").value);
      element("saved").textContent = `${file} is there. Print it at 100 % of its size. The command: ${command}`;
    } catch (error) {
      say_problem(error.message);
    }
  });
  element("show").addEventListener("click", async () => {
    try {
      const { command } = await post("/show", settings());
      element("saved").textContent = `The panel shows it; Escape there ends that. The command: ${command}`;
    } catch (error) {
      say_problem(error.message);
    }
  });
  element("save").addEventListener("click", async () => {
    try {
      const { file, command } = await post("/save", settings());
      element("saved").textContent = `${file} is saved. Render the ${product()}: ${command}`;
    } catch (error) {
      say_problem(error.message);
    }
  });
  window.addEventListener("popstate", () => {
    is_own_address = false; // so that no new entry ends Redo
    if (read_fragment())
      changed();
  });
  window.addEventListener("resize", request_drawing);
  document.addEventListener("keydown", on_key);
  on_pointer();
  on_depths();
}

function on_key(event) {
  const is_text = event.target.closest("input:not([type=range], [type=checkbox]), textarea, select");
  if ((event.ctrlKey || event.metaKey) && !is_text && (event.key === "z" || event.key === "y")) {
    event.preventDefault();
    return event.key === "z" ? history.back() : history.forward();
  }
  if ((event.target !== canvas && event.target !== document.body) || event.ctrlKey || event.altKey || event.metaKey)
    return;
  const part = event.shiftKey ? 0.02 : 0.1, [x, y, times] = state.eye;
  const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }, move = moves[event.key];
  if (move)
    move_eye(x + part * move[0], y + part * move[1]);
  else if (event.key === "PageUp" || event.key === "PageDown")
    set_eye_distance(event.key === "PageUp" ? times / 1.1 : times * 1.1);
  else if (event.key === "Home")
    move_eye(0, 0);
  else
    return;
  event.preventDefault();
}

// A mouse sets the eye's place: the picture's width is the zone's. A finger moves it by the distance dragged.
function on_pointer() {
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  let finger = null; // its last position
  const moved = (event) => {
    const box = canvas.getBoundingClientRect();
    if (event.pointerType !== "touch") {
      if (event.buttons || !calm.matches)
        move_eye(2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height);
    } else if (finger) {
      move_eye(state.eye[0] + 2 * (event.clientX - finger.clientX) / box.width, state.eye[1] - 2 * (event.clientY - finger.clientY) / box.height);
      finger = event;
    }
  };
  canvas.addEventListener("pointermove", moved);
  canvas.addEventListener("pointerdown", (event) => { finger = event; moved(event); });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, () => { finger = null; });
}

// The sheet is dragged through the scene.
function on_depths() {
  let dragging = false;
  const moved = (event) => {
    const box = depth_canvas.getBoundingClientRect();
    set_placement({ sheet_distance: Number(distance_at(within((event.clientX - box.left) / box.width, 0, 1)).toPrecision(4)) });
  };
  depth_canvas.addEventListener("pointerdown", (event) => {
    dragging = true;
    if (event.isTrusted)
      depth_canvas.setPointerCapture(event.pointerId);
    moved(event);
  });
  depth_canvas.addEventListener("pointermove", (event) => dragging && moved(event));
  for (const end of ["pointerup", "pointercancel"])
    depth_canvas.addEventListener(end, () => { dragging = false; });
}

function begin() {
  gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, stencil: false });
  if (!gl)
    return say_problem("This browser has no WebGL 2, which the studio needs.");
  live = new LiveView(gl, element("live-shader").textContent);
  replay = new ReplayDrawing(gl, element("replay-shader").textContent);
  drawn_size = "";
  exact.number = 0;
  if (probe)
    live.set_probe(probe);
}

canvas.addEventListener("webglcontextlost", (event) => { event.preventDefault(); live = replay = null; });
canvas.addEventListener("webglcontextrestored", () => { begin(); show(); settled(); });
try {
  begin();
} catch (error) {
  say_problem(error.message);
}
on_controls();
listen();
