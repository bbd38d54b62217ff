// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws what an eye sees of frames through their sheets on a canvas: SheetDrawing has what every
// shader needs that begins with sheet_optics.glsl, ReplayDrawing draws by replay_page.glsl. Lengths in
// mm, in the sheet frame.

const numbers_whole = 0, numbers_part = 1;
const split_number = (v) => [Math.floor(v), v - Math.floor(v)];
const film_pixels_of = ({ film }) => [film.width, film.height];
const film_size_of = ({ film }) => [film.width * film.pixel_pitch_mm[0], film.height * film.pixel_pitch_mm[1]];
const slant_of = ({ sheet }) => (sheet.slant_degrees ?? 0) * Math.PI / 180;

// Unit vectors across the lenses and along them: exact for a slant of 90 or -90 degrees.
function lens_axes(geometry) {
  const slant = slant_of(geometry);
  const across = Math.abs(geometry.sheet.slant_degrees) === 90 ? [0, Math.sign(slant)] : [Math.cos(slant), Math.sin(slant)];
  return { across, along: [-across[1], across[0]] };
}

const row_spacing_of = ({ sheet }) => sheet.arrangement === "hexagonal" ? Math.sqrt(3) / 2 : 1;

// The texels of `columns` (`axis` 0) or `rows` in sheet_optics.glsl, for a view of `part`.
function view_steps(geometry, part, axis, count) {
  const { sheet, film } = geometry, { across, along } = lens_axes(geometry), offset = sheet.offset_mm ?? [0, 0];
  const texels = new Float32Array(8 * count);
  for (let i = 0; i < count; ++i) {
    const mm = part[axis] + (axis === 0 ? i / count - 0.5 : 0.5 - i / count) * part[2 + axis];
    const u = split_number(across[axis] * (mm - offset[axis]) / sheet.pitch_mm);
    const v = split_number(along[axis] * (mm - offset[axis]) / (sheet.pitch_mm * row_spacing_of(geometry)));
    const pitch = film.pixel_pitch_mm[axis];
    const pixel = split_number(axis === 0 ? mm / pitch + film.width / 2 : film.height / 2 - mm / pitch);
    texels.set([u[numbers_whole], u[numbers_part], v[numbers_whole], v[numbers_part]], 4 * i);
    texels.set([pixel[numbers_whole], pixel[numbers_part], mm, 0], 4 * (count + i));
  }
  return texels;
}

// While something moves on slow graphics, pictures have fewer pixels, so that some ten a second are
// drawn; they get sharp when nothing moves.
class CoarseMode {
  moving = false;
  timer = 0;
  slow = 0.4; // share of the pixels across and down while something moves; grows on quick graphics

  // `redraw`: requests a picture.
  constructor(redraw) { this.redraw = redraw; }

  // Something moves: requests a picture now and, when nothing has moved for a moment, a sharp one.
  moves() {
    this.moving = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => { this.moving = false; this.redraw(); }, 200);
    this.redraw();
  }

  get scale() { return this.moving ? this.slow : 1; }

  // After a picture that was begun at `began` (performance.now()): adapts to how long it took.
  drawn(gl, began) {
    const too_slow = 90, quick = 30, least = 0.2; // milliseconds; least share
    if (!this.moving)
      return;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for the picture
    const ms = performance.now() - began;
    if (ms > too_slow)
      this.slow = Math.max(least, this.slow * Math.max(0.4, Math.sqrt(too_slow / ms)));
    else if (ms < quick)
      this.slow = Math.min(1, 1.2 * this.slow);
  }
}

// One triangle that covers the viewport.
const covering_triangle = `#version 300 es
  void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }`;

// |first - second| of two pictures, times `gain`.
const difference_shader = `#version 300 es
  precision highp float;
  uniform sampler2D first, second;
  uniform ivec2 corner;
  uniform float gain;
  out vec4 shown;
  void main() {
    ivec2 at = ivec2(gl_FragCoord.xy) - corner;
    shown = vec4(gain * abs(texelFetch(first, at, 0).rgb - texelFetch(second, at, 0).rgb), 1);
  }`;

class SheetDrawing {
  constructor(gl) {
    this.gl = gl;
    gl.enable(gl.SCISSOR_TEST);
  }

  // Draws columns `first` to `end` of the view of this.size whose lower left pixel is at `corner`.
  cover(corner, first, end) {
    const { gl } = this;
    gl.viewport(...corner, ...this.size);
    gl.scissor(corner[0] + first, corner[1], end - first, this.size[1]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  bind(unit, texture) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
  }

  floats(texture, format, layout, width, height, values) {
    const { gl } = this;
    this.bind(1, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, layout, gl.FLOAT, values);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  }

  program(fragment_text) {
    const { gl } = this, program = gl.createProgram();
    const compiled = (type, text) => {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      return shader;
    };
    compiled(gl.VERTEX_SHADER, covering_triangle);
    const fragment = compiled(gl.FRAGMENT_SHADER, fragment_text.trim());
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw Error("The graphics driver refuses the program: " + (gl.getShaderInfoLog(fragment) || gl.getProgramInfoLog(program)));
    const known = {};
    return { program, at: (name) => known[name] ??= gl.getUniformLocation(program, name) };
  }

  // A picture's file from its base64 in the page's text, which begins at `begin`, piece by piece.
  // `loaded` gets the share decoded so far, 0 to 0.5, and returns a promise.
  async file(text, begin, type, loaded) {
    const piece = 1 << 22; // a multiple of 4
    const pieces = [];
    for (let at = begin; at < text.length; at += piece) {
      await loaded(0.5 * (at - begin) / (text.length - begin));
      pieces.push(Uint8Array.from(atob(text.slice(at, at + piece)), (letter) => letter.charCodeAt(0)));
    }
    return new Blob(pieces, { type });
  }

  bind_tiles(texture) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
  }

  // Makes room for stored values of `count` tiles.
  prepare_tiles(texture, width, height, count) {
    const { gl } = this;
    this.bind_tiles(texture);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGBA8, width, height, count);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, filter, gl.NEAREST);
  }

  // Loads stored values of a picture of `size`, exact to the bit, in tiles that the graphics
  // processor can hold, with sides of at most `tile`. `loaded` gets 0.5 to 1. Returns the tiles'
  // size.
  async fill(texture, source, size, tile, loaded) {
    const { gl } = this;
    const most = Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), tile);
    const width = Math.min(size[0], most), height = Math.min(size[1], most);
    const columns = Math.ceil(size[0] / width), rows = Math.ceil(size[1] / height);
    if (columns * rows > gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS))
      throw Error(`The picture of ${size[0]} by ${size[1]} pixels is too large for this device's graphics.`);
    this.prepare_tiles(texture, width, height, columns * rows);
    for (let k = 0; k < columns * rows; ++k) {
      const x = k % columns * width, y = Math.floor(k / columns) * height;
      const w = Math.min(width, size[0] - x), h = Math.min(height, size[1] - y);
      await loaded(0.5 + 0.5 * k / (columns * rows));
      const bitmap = await createImageBitmap(source, x, y, w, h, { premultiplyAlpha: "none", colorSpaceConversion: "none" });
      this.bind_tiles(texture);
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, k, w, h, 1, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
      bitmap.close();
    }
    if (gl.getError() === gl.OUT_OF_MEMORY)
      throw Error("The picture does not fit into this device's graphics memory.");
    return [width, height];
  }

  // Textures of a view of `part` of a frame's sheet: [columns, rows].
  view_textures() { return [this.gl.createTexture(), this.gl.createTexture()]; }
  fill_view_textures(textures, geometry, size, part) {
    const { gl } = this;
    textures.forEach((texture, axis) =>
      this.floats(texture, gl.RGBA32F, gl.RGBA, size[axis], 2, view_steps(geometry, part, axis, size[axis])));
  }

  // Uniforms of a view of a frame's sheet from the distance of an eye.
  set_sheet_view(at, { geometry, ior }, { size, part, distance, samples, corner = [0, 0] }) {
    const { gl } = this, { sheet, film } = geometry, { across, along } = lens_axes(geometry);
    const offset = sheet.offset_mm ?? [0, 0], whole = (name, value) => gl.uniform1i(at(name), value);
    whole("arrangement", ["lenticular", "square", "hexagonal"].indexOf(sheet.arrangement));
    whole("subpixels", ["none", "rgb", "bgr"].indexOf(film.subpixels ?? "none"));
    gl.uniform2i(at("film_size"), film.width, film.height);
    gl.uniform2fv(at("pixel_pitch"), film.pixel_pitch_mm);
    gl.uniform1f(at("pitch"), sheet.pitch_mm);
    gl.uniform1f(at("row_spacing"), row_spacing_of(geometry));
    gl.uniform2fv(at("across"), across);
    gl.uniform2fv(at("along"), along);
    gl.uniform2f(at("centre_to_lens"), (across[0] * offset[0] + across[1] * offset[1]) / sheet.pitch_mm,
                 (across[0] * offset[1] - across[1] * offset[0]) / sheet.pitch_mm);
    gl.uniform1f(at("thickness"), sheet.thickness_mm);
    gl.uniform1f(at("n_squared"), ior * ior);
    gl.uniform1f(at("m"), (ior - 1) * (ior + 1));
    gl.uniform2f(at("view_pixel"), part[2] / size[0], part[3] / size[1]);
    gl.uniform2iv(at("corner"), corner);
    whole("view_height", size[1]);
    gl.uniform1f(at("eye_distance"), distance);
    whole("samples", samples);
  }
}

// Units of textures: film, light, columns, rows for the replay; two views for their difference.
class ReplayDrawing extends SheetDrawing {
  // `gl`: a WebGL 2 context. `shader`: sheet_optics.glsl and replay_page.glsl. Throws Error with a
  // sentence if the graphics driver refuses a shader.
  constructor(gl, shader) {
    super(gl);
    this.replay = this.program(shader);
    this.difference = this.program(difference_shader);
    this.films = [];
    const linear = (v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
    this.light = gl.createTexture();
    this.floats(this.light, gl.R32F, gl.RED, 256, 1, Float32Array.from({ length: 256 }, (_, v) => linear(v / 255)));
  }

  // Loads a frame: { geometry, ior, picture or pixels }. picture: an <img> of a data URI; pixels: a
  // Uint8Array of red, green, blue and alpha. `tile`: the greatest side of a texture. `loaded` gets the share loaded so far, 0 to 1, and returns a promise.
  async add(frame, tile, loaded) {
    const { gl } = this;
    const film = { ...frame, texture: gl.createTexture(), view: this.view_textures() };
    film.tile_size = await this.fill(film.texture, await this.source_of(frame, loaded), film_pixels_of(frame.geometry), tile, loaded);
    this.films.push(film);
  }

  // A frame's picture, for fill.
  async source_of({ geometry, picture, pixels }, loaded) {
    if (pixels)
      return new ImageData(new Uint8ClampedArray(pixels.buffer, pixels.byteOffset, pixels.length), ...film_pixels_of(geometry));
    return this.file(picture.src, picture.src.indexOf(",") + 1, "image/png", loaded);
  }

  // Unloads all frames.
  remove_all() {
    for (const film of this.films)
      for (const texture of [film.texture, ...film.view])
        this.gl.deleteTexture(texture);
    this.films = [];
  }

  // The view's size in pixels, and the part of the sheet that it shows: [x, y, width, height].
  set_view(size, part) {
    const { gl } = this;
    this.size = size;
    this.part = part;
    for (const film of this.films)
      this.fill_view_textures(film.view, film.geometry, size, part);
    for (const view of this.views ?? [])
      gl.deleteTexture(view);
    this.views = null;
  }

  // Draws columns `first` to `end` of a frame's view, whose lower left pixel is at `corner` of the
  // canvas. `view`: eye, pupil, focus, gap, blur, samples, raw.
  draw(index, view, first = 0, end = this.size[0], corner = [0, 0]) {
    const { gl } = this, film = this.films[index];
    gl.useProgram(this.replay.program);
    const { at } = this.replay, [x, y, distance] = view.eye, { size, part } = this;
    const number = (name, value) => gl.uniform1f(at(name), value);
    ["film", "light", "columns", "rows"].forEach((name, unit) => gl.uniform1i(at(name), unit));
    this.set_sheet_view(at, film, { size, part, distance, samples: view.samples, corner });
    gl.uniform2iv(at("tile_size"), film.tile_size);
    gl.uniform2f(at("eye"), x, y);
    number("pupil_radius", 0.5 * view.pupil);
    number("spot_radius", 0.5 * view.blur);
    number("sideways", view.focus / (distance + view.focus));
    number("past_focus", view.gap / film.geometry.sheet.thickness_mm);
    gl.uniform1i(at("raw"), view.raw ? 1 : 0);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, film.texture);
    [this.light, ...film.view].forEach((texture, k) => this.bind(1 + k, texture));
    this.cover(corner, first, end);
  }

  // Draws |first - second| of two frames' views, times `gain`.
  draw_difference(first, second, gain) {
    const { gl } = this;
    this.views ??= [0, 1].map(() => {
      const texture = gl.createTexture();
      this.bind(0, texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, ...this.size);
      return texture;
    });
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    [first, second].forEach((view, k) => {
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.views[k], 0);
      this.draw(k, view);
    });
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(frame);
    gl.useProgram(this.difference.program);
    this.views.forEach((texture, k) => {
      this.bind(k, texture);
      gl.uniform1i(this.difference.at(["first", "second"][k]), k);
    });
    gl.uniform1f(this.difference.at("gain"), gain);
    gl.uniform2i(this.difference.at("corner"), 0, 0);
    this.cover([0, 0], 0, this.size[0]);
  }

  // Fills the canvas with the page's background colour.
  clear(width, height) {
    const { gl } = this;
    gl.scissor(0, 0, width, height);
    gl.clearColor(0.094, 0.098, 0.106, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }
}
