#!/usr/bin/python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Simulates a phone's photograph of a calibration page under a lens sheet, by tracing rays.

    photograph.py PAGE.tiff PHOTO.jpg KEY=VALUE...

Each ray of the camera meets the curved surface of a lens, is refracted there (Snell's law, with the
surface's own normal) and reaches the print. Page frame: mm, origin in the page's middle, x to the
right, y up, z towards the camera; the print is z = 0, and the lenses' poles are z = thickness. This
shares no code and no formula of the lens with the reader: bend=pole replaces the curved surface by
the refraction at the lenses' poles.
"""
import sys

import numpy as np
from PIL import Image

DEFAULTS = dict(
    page_dpi=0.0,  # 0: the file's
    pitch=1.27, thickness=3.08, ior=1.6, turn=0.0, phase=0.0,  # degrees; mm, of an axis from the middle
    sheet=(0.0, 0.0), sheet_at=(0.0, 0.0),  # size and middle of the sheet, mm; 0, 0: none
    bend="surface", leak=(0.0, 0.0), scatter=0.0,  # share of light from pitch/6 to the left, the right; blur, mm
    size=(1920, 1080), focal=0.72, middle=(0.0, 0.0),  # focal length and principal point, widths of the picture
    distance=400.0, tilt=(0.0, 0.0), roll=0.0, aim=(0.0, 0.0),  # mm, degrees, degrees, mm
    radial=(0.0, 0.0), tangential=(0.0, 0.0),
    light=(0.0, 0.0), fall=0.4, veil=0.01, exposure=0.75, blur=0.7, sharpen=0.0,
    gain=0.02, noise=0.004, jpeg=90, dot=0.02, spread=0.0, samples=4, seed=1)


def settings(words):
    given = dict(DEFAULTS)
    for word in words:
        key, _, value = word.partition("=")
        if key not in given:
            sys.exit("photograph.py: unknown key " + key)
        old = given[key]
        if isinstance(old, tuple):
            given[key] = tuple(type(old[0])(v) for v in value.split(","))
        else:
            given[key] = type(old)(value)
    return given


def blurred(picture, sigma):
    """Convolves with a Gaussian, in pixels."""
    if sigma <= 0:
        return picture
    reach = max(1, int(np.ceil(3 * sigma)))
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2).astype(np.float32)
    kernel /= kernel.sum()
    for axis in (0, 1):
        pads = [(reach, reach) if a == axis else (0, 0) for a in (0, 1)]
        padded = np.pad(picture, pads, mode="edge")
        out = np.zeros_like(picture)
        for k, weight in enumerate(kernel):
            part = padded[k:k + picture.shape[0]] if axis == 0 else padded[:, k:k + picture.shape[1]]
            out += weight * part
        picture = out
    return picture


def linear(stored):
    v = stored.astype(np.float32) / 255
    return np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4).astype(np.float32)


def encoded(light):
    light = np.clip(light, 0, 1)
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


class Page:
    """The printed page's reflectance."""

    def __init__(self, path, s):
        Image.MAX_IMAGE_PIXELS = None
        with Image.open(path) as picture:
            dpi = picture.info.get("dpi", (0, 0))
            self.light = linear(np.asarray(picture.convert("L")))
        self.step = np.array([25.4 / (s["page_dpi"] or float(d)) for d in dpi])
        if s["spread"]:  # the ink's edges move by this many mm: a soft threshold of the blurred page
            wide = blurred(self.light, s["spread"] / self.step[0])
            self.light = np.minimum(self.light, np.clip(2 * wide - 1, 0, 1))
        self.light = 0.03 + 0.82 * blurred(self.light, s["dot"] / self.step[0])

    def at(self, x, y):
        """Reflectance at page points (mm), between the pixels' centres; a dark table outside."""
        rows, columns = self.light.shape
        u = x / self.step[0] + 0.5 * columns - 0.5
        v = 0.5 * rows - 0.5 - y / self.step[1]
        inside = (u > 0) & (v > 0) & (u < columns - 1.001) & (v < rows - 1.001)
        u, v = np.where(inside, u, 0), np.where(inside, v, 0)
        i, j = u.astype(np.int32), v.astype(np.int32)
        fu, fv = (u - i).astype(np.float32), (v - j).astype(np.float32)
        flat, start = self.light.ravel(), j * columns + i
        top = flat[start] * (1 - fu) + flat[start + 1] * fu
        low = flat[start + columns] * (1 - fu) + flat[start + columns + 1] * fu
        return np.where(inside, top * (1 - fv) + low * fv, np.float32(0.18))


def rotation(s):
    """Columns: the camera's right, down and forward in the page frame; and the camera's place."""
    tx, ty, roll = np.radians([s["tilt"][0], s["tilt"][1], s["roll"]])
    back = np.array([np.sin(tx) * np.cos(ty), np.sin(ty), np.cos(tx) * np.cos(ty)])
    place = s["distance"] * back + np.array([*s["aim"], 0.0])
    right = np.cross([0.0, 1.0, 0.0], back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    turned = np.cos(roll) * right + np.sin(roll) * up
    return np.stack([turned, -np.cross(back, turned), -back], 1), place


def directions(s, frame, px, py):
    """Unit vectors of the page frame through photo points (pixels from the top left corner)."""
    width, height = s["size"]
    x = (px - width * (0.5 + s["middle"][0])) / (width * s["focal"])
    y = (py - height / 2 - width * s["middle"][1]) / (width * s["focal"])
    r2 = x * x + y * y
    swell = 1 + s["radial"][0] * r2 + s["radial"][1] * r2 * r2
    a, b = s["tangential"]
    x, y = (x * swell + 2 * a * x * y + b * (r2 + 2 * x * x),
            y * swell + a * (r2 + 2 * y * y) + 2 * b * x * y)
    d = x[..., None] * frame[:, 0] + y[..., None] * frame[:, 1] + frame[:, 2]
    return d / np.linalg.norm(d, axis=-1, keepdims=True)


def film_points(s, place, d, leak_draw):
    """Where rays reach the print, under the sheet or beside it."""
    t, n, p = s["thickness"], s["ior"], s["pitch"]
    beside = place[:2] - (place[2] / d[..., 2])[..., None] * d[..., :2]
    if s["sheet"][0] <= 0:
        return beside[..., 0], beside[..., 1]
    c, sn = np.cos(np.radians(s["turn"])), np.sin(np.radians(s["turn"]))
    # In the sheet's own frame: u across the lenses, w along them.
    pu, pw = c * place[0] + sn * place[1], -sn * place[0] + c * place[1]
    du, dw, dz = c * d[..., 0] + sn * d[..., 1], -sn * d[..., 0] + c * d[..., 1], d[..., 2]
    depth = np.zeros_like(dz)
    radius = t * (n - 1) / n
    for _ in range(1 if s["bend"] == "pole" else 4):
        way = (t - depth - place[2]) / dz
        u = pu + way * du
        axis = np.round((u - s["phase"]) / p) * p + s["phase"]
        v = u - axis
        if s["bend"] != "pole":
            depth = radius - np.sqrt(radius * radius - v * v)
    w = pw + way * dw
    if s["bend"] == "pole":
        nu, nz = np.zeros_like(v), np.ones_like(v)
        v = np.zeros_like(v)
    else:
        nu, nz = v / radius, np.sqrt(1 - (v / radius) ** 2)
    incidence = -(du * nu + dz * nz)
    shift = incidence / n - np.sqrt(1 - (1 - incidence * incidence) / (n * n))
    iu, iw, iz = du / n + shift * nu, dw / n, dz / n + shift * nz
    inside = (t - depth) / -iz
    u, w = axis + v + inside * iu, w + inside * iw
    left, right = s["leak"]
    u = u + p / 6 * ((leak_draw > 1 - right).astype(np.float64) - (leak_draw < left))
    x, y = c * u - sn * w, sn * u + c * w
    at = place[:2] + ((t - place[2]) / d[..., 2])[..., None] * d[..., :2] - np.array(s["sheet_at"])
    su, sw = c * at[..., 0] + sn * at[..., 1], -sn * at[..., 0] + c * at[..., 1]
    under = (np.abs(su) < s["sheet"][0] / 2) & (np.abs(sw) < s["sheet"][1] / 2)
    return np.where(under, x, beside[..., 0]), np.where(under, y, beside[..., 1])


def photograph(page, s):
    """The photo's linear light, before noise."""
    width, height = s["size"]
    random = np.random.default_rng(s["seed"])
    frame, place = rotation(s)
    out = np.zeros((height, width), np.float32)
    per = s["samples"]
    band = max(1, 400000 // width)
    rows, columns = page.light.shape
    half = np.array([columns * page.step[0], rows * page.step[1]]) / 2
    for first in range(0, height, band):
        last = min(height, first + band)
        py, px = np.mgrid[first:last, 0:width]
        # Pixels that see nothing but the table are not traced.
        d = directions(s, frame, px + 0.5, py + 0.5)
        on = place[:2] - (place[2] / d[..., 2])[..., None] * d[..., :2]
        near = (np.abs(on[..., 0]) < half[0] + 3) & (np.abs(on[..., 1]) < half[1] + 3)
        out[first:last] = 0.18
        if not near.any():
            continue
        px, py = px[near].astype(np.float64), py[near].astype(np.float64)
        total = np.zeros(px.shape)
        for k in range(per * per):
            d = directions(s, frame, px + (k % per + random.random(px.shape)) / per,
                           py + (k // per + random.random(px.shape)) / per)
            x, y = film_points(s, place, d, random.random(px.shape))
            if s["scatter"]:
                x = x + s["scatter"] * random.standard_normal(x.shape)
                y = y + s["scatter"] * random.standard_normal(x.shape)
            lit = 1 + s["light"][0] * x / 200 + s["light"][1] * y / 200
            total += lit * page.at(x, y)
        out[first:last][near] = total / per ** 2
    py, px = np.mgrid[0:height, 0:width]
    r2 = ((px - width / 2) ** 2 + (py - height / 2) ** 2) / (width / 2) ** 2
    return s["exposure"] * ((1 - s["veil"]) * out * (1 - s["fall"] * r2 / (1 + r2)) + s["veil"])


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    s = settings(sys.argv[3:])
    light = blurred(photograph(Page(sys.argv[1], s), s), s["blur"])
    if s["sharpen"]:
        light = light + s["sharpen"] * (light - blurred(light, 1.5))
    random = np.random.default_rng(s["seed"] + 1000)
    deviation = np.sqrt(s["noise"] ** 2 + s["gain"] ** 2 * np.maximum(light, 0))
    cast = np.array([1.04, 1, 0.92])
    colours = light[..., None] * cast + deviation[..., None] * random.standard_normal((*light.shape, 3))
    stored = np.clip(255 * encoded(colours) + 0.5, 0, 255).astype(np.uint8)
    Image.fromarray(stored).save(sys.argv[2], quality=s["jpeg"])


main()
