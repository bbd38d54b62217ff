// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws what an eye sees of a scene through a lens sheet, from a probe of the scene, by
// live_view.glsl. Continues replay_drawing.js. Lengths in mm, in the sheet frame, or in scene units.

const max_live_views = 32; // max_views of live_view.glsl

// The film's refractive index as its lens model has it.
const modelled_ior = ({ sheet, render }) => render?.model === "pinhole" ? 1 : sheet.ior;

// Units of textures: columns, rows, the probe's colours, its nearness.
class LiveView extends SheetDrawing {
  // `gl`: a WebGL 2 context. `shader`: sheet_optics.glsl and live_view.glsl. Throws Error with a
  // sentence if the graphics driver refuses the shader.
  constructor(gl, shader) {
    super(gl);
    this.live = this.program(shader);
    this.steps = this.view_textures();
  }

  // Loads pictures of the scene from eyes in the plane of its own eye, all with the same window,
  // whose shape is the film's: { width, height, sheet_distance, window, views: [{ eye, colours,
  // nearness }] }. window: width and height of the part of the film, around its middle, that shows
  // the scene (default: all of it).
  // sheet_distance: from the eyes to the window, scene units. eye: to the right of the scene's own
  // eye and above, scene units. colours: Uint8Array, sRGB, three a pixel; nearness: Float32Array, 1/r
  // with the distance r from the eyes' plane in scene units, 0 where there is no surface. Both row by
  // row from the upper left.
  set_probe({ width, height, sheet_distance, window = [1, 1], views }) {
    const { gl } = this, size = width * height;
    if (!(views.length >= 1 && views.length <= max_live_views))
      throw Error(`A probe has 1 to ${max_live_views} views, not ${views.length}.`);
    if (views.some(({ colours, nearness }) => colours.length !== 3 * size || nearness.length !== size))
      throw Error(`The probe's views do not have ${width} by ${height} pixels.`);
    for (const texture of this.probe?.textures ?? [])
      gl.deleteTexture(texture);
    const textures = [gl.SRGB8, gl.R32F].map((format, k) => this.view_array(2 + k, format, width, height, views.length));
    let max_nearness = 0;
    const unpacked = gl.getParameter(gl.UNPACK_ALIGNMENT);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    views.forEach(({ colours, nearness }, k) => {
      const relative = nearness.map((v) => v * sheet_distance);
      max_nearness = relative.reduce((a, b) => Math.max(a, b), max_nearness);
      gl.activeTexture(gl.TEXTURE2);
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, k, width, height, 1, gl.RGB, gl.UNSIGNED_BYTE, colours);
      gl.activeTexture(gl.TEXTURE3);
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, k, width, height, 1, gl.RED, gl.FLOAT, relative);
    });
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, unpacked);
    const eyes = new Float32Array(2 * max_live_views);
    views.forEach(({ eye }, k) => eyes.set(eye.map((v) => v / sheet_distance), 2 * k));
    this.probe = { textures, count: views.length, eyes, sheet_distance, window, max_nearness };
  }

  // The view's size in pixels, the part of the sheet that it shows, [x, y, width, height], and the
  // frame's JSON document (frame_metadata.h).
  set_view(size, part, geometry) {
    this.size = size;
    this.part = part;
    this.geometry = geometry;
    this.fill_view_textures(this.steps, geometry, size, part);
  }

  // Draws the view of `eye`, [x, y, distance]. `placement`: { sheet_distance: of the sheet in the
  // scene, scene units; parallax; scene_distance_mm }. `options`: samples (across a pixel), steps (at
  // most, along a line), tint (depth budget in mm, which tints what is sharp, soft and beyond; 0:
  // none), without_sheet (the eye's rays go on straight), corner (the view's lower left pixel).
  draw(eye, placement, { samples = 2, steps = 64, tint = 0, without_sheet = false, corner = [0, 0] } = {}) {
    const { gl, geometry, size, part, probe } = this, { at } = this.live, { sheet, aperture } = geometry;
    gl.useProgram(this.live.program);
    ["columns", "rows", "colours", "nearness"].forEach((name, unit) => gl.uniform1i(at(name), unit));
    this.set_sheet_view(at, { geometry, ior: modelled_ior(geometry) }, { size, part, distance: eye[2], samples, corner });
    const number = (name, value) => gl.uniform1f(at(name), value), whole = (name, value) => gl.uniform1i(at(name), value);
    const half = (mm) => mm === null || mm === undefined ? 1e30 : Math.max(0.5 * mm, 1e-30);
    gl.uniform2f(at("eye"), eye[0], eye[1]);
    whole("without_sheet", without_sheet ? 1 : 0);
    number("aperture_distance", aperture.distance_mm);
    gl.uniform2f(at("aperture_half"), half(aperture.width_mm), half(aperture.height_mm));
    whole("elliptical", aperture.shape === "ellipse" ? 1 : 0);
    whole("upright_slit", Math.abs(sheet.slant_degrees ?? 0) > 45 ? 1 : 0);
    number("sheet_distance", placement.sheet_distance);
    number("scene_distance", placement.scene_distance_mm);
    number("parallax", placement.parallax);
    number("tint", tint);
    whole("view_count", probe.count);
    gl.uniform2fv(at("view_eyes"), probe.eyes);
    number("probe_distance", probe.sheet_distance);
    gl.uniform2fv(at("window"), probe.window);
    number("max_nearness", probe.max_nearness);
    whole("max_steps", steps);
    this.steps.forEach((texture, unit) => this.bind(unit, texture));
    probe.textures.forEach((texture, k) => {
      gl.activeTexture(gl.TEXTURE2 + k);
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    });
    this.cover(corner, 0, size[0]);
  }

  // An empty texture for pictures of a probe, bound to a unit.
  view_array(unit, format, width, height, count) {
    const { gl } = this, texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, format, width, height, count);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, filter, gl.NEAREST);
    return texture;
  }
}
