// SPDX-License-Identifier: AGPL-3.0-or-later
// The page that drives a panel. While its viewport has exactly the panel's pixels, it shows the
// interlaced image, pixel for pixel; otherwise the middle view, with the reason.

const element = (id) => document.getElementById(id);
const page = JSON.parse(element("data").textContent);
const [panel_width, panel_height] = page.size;
const canvas = element("panel");

function say(id, sentence) {
  element(id).textContent = sentence;
  element(id).hidden = !sentence;
}

class PanelDrawing extends SheetDrawing {
  tables = ["across", "shift", "up", "x", "y"];
  textures = {};
  tiles = {};

  constructor(gl, shader) {
    super(gl);
    this.interlaced = this.program(shader);
    this.size = page.size;
    const { light, least } = page.values, stored = new Uint8Array(65536);
    for (let value = 0, k = 0; k < stored.length; stored[k++] = value)
      while (value < 255 && k >= least[value + 1])
        ++value;
    this.light = this.values(gl.R16UI, gl.UNSIGNED_SHORT, 256, 1, Uint16Array.from(light));
    this.stored = this.values(gl.R8UI, gl.UNSIGNED_BYTE, 256, 256, stored);
  }

  // A texture of whole numbers.
  values(format, type, width, height, numbers) {
    const { gl } = this, texture = gl.createTexture();
    this.bind(0, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, gl.RED_INTEGER, type, numbers);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    return texture;
  }

  // Loads the tables, and the quilt or video from its data URI. `tile` and `loaded` as for fill.
  async load(uri, tile, loaded) {
    for (const name of this.tables) {
      const { size, planes, picture } = page.tables[name] ?? { size: [1, 1], planes: 0 };
      await this.load_picture(name, picture, [size[0], size[1] * planes], tile, async () => {});
    }
    if (uri.startsWith("data:video"))
      await this.load_video(uri, loaded);
    else
      await this.load_picture("quilt", uri, page.picture_size, tile, loaded);
  }

  async load_video(uri, loaded) {
    const { gl } = this, video = document.createElement("video");
    const unreadable = Error("This browser cannot play the video: take another browser, or encode it as VP9 in a .webm or H.264 in an .mp4.");
    video.muted = video.loop = video.playsInline = true;
    video.src = URL.createObjectURL(await this.file(uri, uri.indexOf(",") + 1, uri.slice(5, uri.indexOf(";")), loaded));
    await new Promise((done, failed) => {
      video.addEventListener("loadeddata", done);
      video.addEventListener("error", () => failed(unreadable));
    });
    const { videoWidth: width, videoHeight: height } = video, [columns, rows] = page.grid;
    const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    if (width < columns || height < rows)
      throw Error(`The video's ${size_text(width, height)} pixels hold no ${size_text(columns, rows)} views.`);
    if (Math.max(width, height) > most)
      throw Error(`The video has ${size_text(width, height)} pixels; this device's graphics holds ${size_text(most, most)}.`);
    page.picture_size = this.tiles.quilt = [width, height];
    page.view = [Math.floor(width / columns), Math.floor(height / rows)];
    this.textures.quilt = gl.createTexture();
    this.prepare_tiles(this.textures.quilt, width, height, 1);
    this.video = video;
    this.take_video_picture();
  }

  // Takes the video's picture of this moment for the quilt.
  take_video_picture() {
    const { gl, video } = this;
    this.bind_tiles(this.textures.quilt);
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, 0, video.videoWidth, video.videoHeight, 1, gl.RGBA, gl.UNSIGNED_BYTE, video);
  }

  async load_picture(name, uri, size, tile, loaded) {
    this.textures[name] = this.gl.createTexture();
    this.tiles[name] = [1, 1];
    if (uri)
      this.tiles[name] = await this.fill(this.textures[name], await this.file(uri, uri.indexOf(",") + 1, "image/png", loaded), size, tile,
                                         loaded);
  }

  // Draws the image; with a number of a view, that view alone.
  draw(only_view = -1) {
    const { gl } = this, { at } = this.interlaced;
    gl.useProgram(this.interlaced.program);
    [...this.tables, "quilt"].forEach((name, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.textures[name]);
      gl.uniform1i(at(name), unit);
    });
    [this.light, this.stored].forEach((texture, k) => {
      this.bind(this.tables.length + 1 + k, texture);
      gl.uniform1i(at(["light", "stored"][k]), this.tables.length + 1 + k);
    });
    for (const name of this.tables) {
      gl.uniform2iv(at(name + "_table.size"), page.tables[name]?.size ?? [1, 1]);
      gl.uniform2iv(at(name + "_table.tile"), this.tiles[name]);
      gl.uniform1i(at(name + "_table.planes"), page.tables[name]?.planes ?? 0);
    }
    gl.uniform2iv(at("quilt_size"), page.picture_size);
    gl.uniform2iv(at("quilt_tile"), this.tiles.quilt);
    gl.uniform2iv(at("panel"), page.size);
    gl.uniform4iv(at("part_shown"), page.shown);
    gl.uniform2iv(at("mirrored"), page.mirrored.map(Number));
    gl.uniform2iv(at("grid"), page.grid);
    gl.uniform2iv(at("view"), page.view);
    gl.uniform2uiv(at("views"), page.views);
    gl.uniform2iv(at("blends"), page.blends.map(Number));
    gl.uniform1i(at("is_separable"), page.is_separable ? 1 : 0);
    gl.uniform1i(at("has_unseen"), page.has_unseen ? 1 : 0);
    gl.uniform1i(at("only_view"), only_view);
    this.cover([0, 0], 0, panel_width);
  }
}

// Pixels of the panel or display in words.
const size_text = (width, height) => `${width} x ${height}`;
// Whether a length in the page's pixels is one of device pixels, as nearly as can be known: lengths
// in the page's pixels are rounded.
const is_length = (length, ratio, pixels) => Math.abs(length * ratio - pixels) < Math.max(1, ratio);
const is_panel = (width, height, ratio) => is_length(width, ratio, panel_width) && is_length(height, ratio, panel_height);

let drawing;

// Draws as the window requires.
function draw() {
  const ratio = devicePixelRatio;
  const on_panel = is_panel(innerWidth, innerHeight, ratio);
  document.body.classList.toggle("on-panel", on_panel || Boolean(document.fullscreenElement));
  canvas.style.width = on_panel ? `${panel_width / ratio}px` : "";
  canvas.style.height = on_panel ? `${panel_height / ratio}px` : "";
  if (!drawing)
    return;
  const middle = Math.floor(page.views[0] / 2) + page.views[0] * Math.floor(page.views[1] / 2);
  drawing.draw(on_panel ? -1 : middle);
  const screen_size = size_text(Math.round(screen.width * ratio), Math.round(screen.height * ratio));
  const wanted = size_text(panel_width, panel_height);
  const full = document.fullscreenElement ? `This screen has ${screen_size} pixels, the panel ${wanted}: press f, move the window to the panel, and press f there.` : "";
  say("trouble", on_panel ? "" : full);
  say("where", `The middle view, for the panel ${page.panel} of ${wanted} pixels. ` +
      (is_panel(screen.width, screen.height, ratio) ? "This screen has the panel's size: click the picture or press f."
       : "getScreenDetails" in window ? "Click the picture or press f: it appears on the screen of that size, if the browser may see all screens."
       : `This screen has ${screen_size}: move the window to the panel, then click the picture or press f.`));
  document.body.dataset.drawn = on_panel ? "panel" : "view";
}

// Draws each picture of a video, and lets the user stop it.
function play() {
  const { video } = drawing;
  const next = () => {
    drawing.take_video_picture();
    draw();
    wait();
  };
  const wait = () => "requestVideoFrameCallback" in video ? video.requestVideoFrameCallback(next) : requestAnimationFrame(next);
  wait();
  element("pause").hidden = false;
  element("pause").addEventListener("click", turn_pause);
  video.play();
}

function turn_pause() {
  const { video } = drawing;
  element("pause").textContent = video.paused ? "Pause" : "Play";
  return video.paused ? video.play() : video.pause();
}

// Enters full screen, on the screen that has the panel's size if the browser lists the screens, or
// leaves it.
async function turn_full_screen() {
  if (document.fullscreenElement)
    return document.exitFullscreen();
  const options = { navigationUI: "hide" };
  try {
    const { screens } = await window.getScreenDetails();
    options.screen = screens.find((one) => is_panel(one.width, one.height, one.devicePixelRatio));
    if (!options.screen)
      delete options.screen;
  } catch {
    // Unknown to the browser, or not permitted: the window's screen is taken.
  }
  try {
    await document.documentElement.requestFullscreen(options);
  } catch {
    say("trouble", "This browser refuses full screen: press F11 on the panel.");
  }
}

async function begin() {
  document.title = `${page.name} on ${page.panel}`;
  element("title").textContent = document.title;
  canvas.width = panel_width;
  canvas.height = panel_height;
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false });
  if (!gl)
    throw Error("This browser has no WebGL 2, which the page needs: update it, or switch its hardware acceleration on.");
  if (gl.drawingBufferWidth !== panel_width || gl.drawingBufferHeight !== panel_height)
    throw Error(`This device's graphics draws ${size_text(gl.drawingBufferWidth, gl.drawingBufferHeight)} pixels, fewer than the panel's.`);
  canvas.addEventListener("webglcontextlost", () => location.reload());
  const fresh = new PanelDrawing(gl, element("shader").textContent);
  const tile = Number(new URLSearchParams(location.hash.slice(1)).get("tile")) || Infinity;
  await fresh.load(element("picture").textContent, tile, (part) => {
    say("where", `Loading the picture ... ${Math.round(100 * part)} %`);
    return new Promise((done) => setTimeout(done));
  });
  drawing = fresh;
  draw();
  if (drawing.video)
    play();
}

for (const event of ["resize", "fullscreenchange"])
  window.addEventListener(event, draw);
canvas.addEventListener("click", turn_full_screen);
element("full").addEventListener("click", turn_full_screen);
window.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey)
    return;
  if (event.key.toLowerCase() === "f")
    turn_full_screen();
  else if (event.key === " " && drawing?.video && event.target.tagName !== "BUTTON")
    turn_pause();
  else
    return;
  event.preventDefault();
});
draw();
begin().catch((error) => {
  say("where", "");
  say("trouble", error.message);
});
